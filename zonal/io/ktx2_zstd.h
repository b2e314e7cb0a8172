#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace zonal {

/// False in a build without libzstd (ZONAL_HAS_ZSTD is not defined): the verbs below then throw Error{kUsage}.
bool has_zstd();

/// The most bytes that compressing `size` bytes can give.
std::size_t zstd_bound(std::size_t size);
/// One frame with its content size and a checksum. Returns its length; `out` holds at least zstd_bound(in.size()).
std::size_t zstd_compress(std::span<const std::byte> in, std::span<std::byte> out, int level);
/// The content size that a frame claims; nullopt unless `in` is exactly one frame and states a size. Decompresses
/// nothing.
std::optional<std::uint64_t> zstd_content_size(std::span<const std::byte> in);
/// False unless `in` decompresses to exactly out.size() bytes and its checksum, if any, holds.
bool zstd_decompress(std::span<const std::byte> in, std::span<std::byte> out);

}  // namespace zonal
