#pragma once

#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfLineOrder.h>
#include <OpenEXR/ImfPixelType.h>
#include <png.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "zonal/image/image.h"
#include "zonal/math/vec.h"

/// Small picture files for the tests of the decoders, made by the formats' own libraries or byte by byte.
namespace zonal::sample {

/// A folder of its own that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  std::size_t file_count() const;

 private:
  std::filesystem::path path_;
};

std::vector<std::byte> bytes_of(std::string_view text);
std::vector<std::byte> bytes_of(const std::vector<int>& values);
std::vector<std::byte> operator+(std::vector<std::byte> a, const std::vector<std::byte>& b);

/// Values of every sign and many magnitudes, the same for one seed.
Image<Rgb> random_picture(int width, int height, unsigned seed);

struct Png {
  int width = 0, height = 0, bits = 8;
  int color_type = PNG_COLOR_TYPE_RGB;
  std::vector<std::uint8_t> rows = {};  ///< packed rows, 16 bits big-endian
  std::vector<png_color> palette = {};
  std::vector<std::uint8_t> palette_alpha = {};
  bool interlaced = false;
  double gamma = 0;  ///< 0: no gAMA
};
std::vector<std::byte> png_file(const Png&);

struct Jpeg {
  int width = 0, height = 0, components = 3;  ///< 1 grey, 3 RGB, 4 CMYK
  std::vector<std::uint8_t> samples = {};
  bool progressive = false;
  std::vector<std::uint8_t> app1 = {};
};
std::vector<std::byte> jpeg_file(const Jpeg&);

struct Exr {
  int width = 20, height = 10;
  int left = 0, top = 0;                      ///< of the data window
  int display_width = 0, display_height = 0;  ///< 0: as the data window
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
  Imf::PixelType type = Imf::HALF;
  std::vector<std::string> channels = {"R", "G", "B"};
  int tile = 0;    ///< edge of a tile; 0: scanlines
  int levels = 0;  ///< an Imf::LevelMode
  std::string part_name = {};
  int missing_rows = 0;  ///< the writer stopped before the last rows
  Imf::LineOrder order = Imf::INCREASING_Y;
  float seconds = 0, f_number = 0, iso = 0;  ///< of the exposure; 0: not stated
};
/// What channel `channel` of Exr::channels holds at (x, y) of the data window: a multiple of 1/8 in 8..16, all in one
/// octave of the halves; for unsigned integer channels a whole number below 64.
float exr_value(int channel, int x, int y, Imf::PixelType = Imf::HALF);
std::vector<std::byte> exr_file(const Exr&);
std::vector<std::byte> exr_file(const std::vector<Exr>& parts);
/// A deep file: one sample in each of 4 x 4 pixels.
std::vector<std::byte> deep_exr_file();
/// Luminance and subsampled chroma of a picture, through OpenEXR's own writer.
std::vector<std::byte> luminance_chroma_exr_file(const Image<Rgb>&);

/// One sound small file of every format and flavour, with a name for messages.
struct Named {
  std::string name;
  std::vector<std::byte> bytes;
};
std::vector<Named> one_of_each();

}  // namespace zonal::sample
