#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "zonal/image/image.h"
#include "zonal/io/ktx2_layout.h"

namespace zonal {

enum class TextureShape { kPicture, kCube };

/// The pictures of one texture, the largest first: each side of level p + 1 is half of level p's, rounded down, at
/// least 1. A level of a cube holds its six square faces +X -X +Y -Y +Z -Z from top to bottom (1:6). Faces are stored
/// as they are: the frame of the lookup (io/engine.h) has been chosen when the picture was made.
struct TextureChain {
  TextureShape shape = TextureShape::kCube;
  std::vector<Image<Rgb>> levels;
};

using Ktx2Metadata = std::vector<std::pair<std::string, std::string>>;  ///< key and text, both UTF-8 without NUL

struct Ktx2Options {
  TexelFormat format = TexelFormat::kRgba16f;
  int zstd_level = 0;            ///< 0: texels are stored as they are; 1..19: each level compressed by Zstandard
  std::string writer = "zonal";  ///< the value of KTXwriter: program and version
  Ktx2Metadata metadata = {};    ///< further keys, in any order; not beginning with KTX or ktx, which are reserved
};

struct Ktx2File {
  std::vector<std::byte> bytes;
  /// Texels that had a value beyond +-65504 and were clamped to it; 0 for 32-bit texels.
  std::size_t clipped_texels = 0;
};

/// A whole KTX 2.0 file in memory; nothing else of its size is held. The same input gives the same bytes. Throws
/// Error{kUsage} for metadata that the format does not allow and for zstd_level > 0 in a build without Zstandard.
Ktx2File encode_ktx2(const TextureChain&, const Ktx2Options& = {});

/// Encodes, runs check_ktx2 on the result and writes it whole or not at all. Returns the number of clipped texels.
std::size_t save_ktx2(const std::filesystem::path&, const TextureChain&, const Ktx2Options& = {});

struct Ktx2Texture {
  TextureChain chain;  ///< blue is 0 where the format has none; alpha is dropped
  TexelFormat format = TexelFormat::kRgba16f;
  Ktx2Metadata metadata;  ///< in the order of the file, KTXorientation and KTXwriter included
};

/// Reads what encode_ktx2 writes. Throws Error{kInput} with the first problem that check_ktx2 finds, when the texels do
/// not decompress, or when they take more than `max_texels`.
Ktx2Texture decode_ktx2(std::span<const std::byte> file, std::uint64_t max_texels = std::uint64_t{1} << 27);

}  // namespace zonal
