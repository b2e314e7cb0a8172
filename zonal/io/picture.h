#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/image.h"
#include "zonal/io/byte_reader.h"
#include "zonal/io/file.h"
#include "zonal/math/vec.h"

namespace zonal {

/// What the integers of an 8 or 16 bit picture mean. Float formats (EXR, HDR, PFM) are linear by definition.
enum class Encoding {
  kAuto,  ///< linear when the file says so, else sRGB, and a note says which was assumed
  kLinear,
  kSrgb,  ///< IEC 61966-2-1
};

struct LoadOptions {
  /// Larger pictures are refused before memory is taken: 12 bytes a pixel.
  std::int64_t max_pixels = std::int64_t{1} << 28;
  Encoding encoding = Encoding::kAuto;
};

/// A decoded picture file: linear pixels as stored (NaN, Inf and negative values included), and how they were stored.
struct Picture {
  Image<Rgb> pixels;
  std::string format;              ///< "OpenEXR", "Radiance HDR", "PFM", "PNG", "JPEG" or "TGA"
  int channels = 3;                ///< in the file, alpha included; one grey channel fills r, g and b alike
  bool alpha = false;              ///< the file has alpha; it is left out, and the colours are not divided by it
  bool srgb_decoded = false;       ///< the integers were taken as sRGB
  std::vector<std::string> notes;  ///< choices made while reading, in words for the user
};

struct SaveOptions {
  int png_bits = 8;       ///< 8 or 16 for each channel
  bool exr_half = false;  ///< 16 bit floats; 32 bit floats keep every bit
  /// PNG: linear values, declared by a gAMA of 1, in place of sRGB: for tables that are not colours.
  bool png_linear = false;
};

/// What a file could not hold. Nothing is clipped silently.
struct SaveReport {
  std::int64_t clipped_pixels = 0;  ///< pixels with a channel outside the format's range (or NaN where it has none)
};

/// Reads OpenEXR, Radiance HDR, PFM, PNG, JPEG and TGA, told apart by their content, never by the name. An EXIF
/// orientation other than upright is noted, not applied.
/// Throws Error{kInput}: missing, no known format, broken or truncated, more than max_pixels. Decoded picture plus
/// small blocks of memory. `run` serves OpenEXR alone; the others are serial by nature.
Picture load_picture(const std::filesystem::path&, const LoadOptions& = {}, const Run& run = {});
/// The same from memory; `name` is used in messages.
Picture decode_picture(std::string name, std::vector<std::byte> bytes, const LoadOptions& = {}, const Run& run = {});

/// Writes .exr, .hdr, .pfm or .png as the extension says, whole or not at all. Throws Error{kUsage} for another
/// extension and Error{kOutput} when the file cannot be written.
SaveReport save_picture(const Image<Rgb>&, const std::filesystem::path&, const SaveOptions& = {});

/// Whether save_picture() knows the extension of this path.
bool can_save_picture(const std::filesystem::path&);

/// For the decoders: throws Error{kInput} unless both sides are positive and the picture has at most max_pixels.
void check_picture_size(const ByteReader&, std::int64_t width, std::int64_t height, const LoadOptions&);

}  // namespace zonal
