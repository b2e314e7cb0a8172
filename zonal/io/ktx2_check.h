#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace zonal {

/// Something that is not as the specification (or our narrower promise) has it, and the offset in bytes where that
/// shows.
struct Ktx2Problem {
  std::uint64_t offset = 0;
  std::string text;
};

/// A strict validator of the KTX 2.0 files that encode_ktx2 writes, apart from that code: identifier, every header
/// field, offsets, lengths, alignment and order of the level index, each field of the data format descriptor, keys
/// (sorted, known when reserved, UTF-8, ended by NUL, padded by zeros), orientation `rd`, levels without gap or
/// overlap, zero padding, nothing after the end. Texel values are not looked at; compressed levels must be one
/// Zstandard frame that states the right size. Empty when the file is in order. Any bytes may be given: nothing is read
/// outside them, and time is bounded by their number. Formats that we do not write (arrays, volumes, block compression,
/// other texels) are problems too.
std::vector<Ktx2Problem> check_ktx2(std::span<const std::byte> file);

}  // namespace zonal
