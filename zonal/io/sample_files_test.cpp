#include "zonal/io/sample_files_test.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <half.h>

#include <cstdio>
// libjpeg's headers need <cstdio> before them.
#include <jpeglib.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stdexcept>

#include "zonal/io/file.h"
#include "zonal/io/picture.h"

namespace zonal::sample {
namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "zonal-io-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::size_t TemporaryFolder::file_count() const {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
}

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::vector<std::byte> bytes_of(const std::vector<int>& values) {
  std::vector<std::byte> bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

std::vector<std::byte> operator+(std::vector<std::byte> a, const std::vector<std::byte>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Image<Rgb> random_picture(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> mantissa(-1, 1), exponent(-12, 12);
  const auto value = [&] { return mantissa(random) * std::exp2(exponent(random)); };
  Image<Rgb> image(width, height);
  for (Rgb& pixel : image.values()) {
    pixel.r = value();
    pixel.g = value();
    pixel.b = value();
  }
  return image;
}

std::vector<std::byte> png_file(const Png& spec) {
  std::vector<std::byte> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep from, png_size_t count) {
        auto& out = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(p));
        const auto more = std::as_bytes(std::span(from, count));
        out.insert(out.end(), more.begin(), more.end());
      },
      [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(spec.width), static_cast<png_uint_32>(spec.height), spec.bits,
               spec.color_type, spec.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!spec.palette.empty()) png_set_PLTE(png, info, spec.palette.data(), static_cast<int>(spec.palette.size()));
  if (!spec.palette_alpha.empty()) {
    png_set_tRNS(png, info, spec.palette_alpha.data(), static_cast<int>(spec.palette_alpha.size()), nullptr);
  }
  if (spec.gamma > 0) png_set_gAMA(png, info, spec.gamma);
  png_write_info(png, info);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  if (spec.rows.size() != row_bytes * static_cast<std::size_t>(spec.height))
    throw std::logic_error("rows do not fit the PNG");
  const int passes = spec.interlaced ? png_set_interlace_handling(png) : 1;
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < spec.height; ++y)
      png_write_row(png, spec.rows.data() + row_bytes * static_cast<std::size_t>(y));
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

std::vector<std::byte> jpeg_file(const Jpeg& spec) {
  jpeg_compress_struct jpeg = {};
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &memory, &size);
  jpeg.image_width = static_cast<JDIMENSION>(spec.width);
  jpeg.image_height = static_cast<JDIMENSION>(spec.height);
  jpeg.input_components = spec.components;
  jpeg.in_color_space = spec.components == 1 ? JCS_GRAYSCALE : spec.components == 3 ? JCS_RGB : JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  for (int i = 0; i < jpeg.num_components; ++i) jpeg.comp_info[i].h_samp_factor = jpeg.comp_info[i].v_samp_factor = 1;
  if (spec.progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  if (!spec.app1.empty())
    jpeg_write_marker(&jpeg, JPEG_APP0 + 1, spec.app1.data(), static_cast<unsigned>(spec.app1.size()));
  const std::size_t row_samples = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.components);
  std::vector<JSAMPLE> row(row_samples);
  for (std::size_t y = 0; y < static_cast<std::size_t>(spec.height); ++y) {
    std::copy_n(spec.samples.begin() + static_cast<std::ptrdiff_t>(y * row_samples), row_samples, row.begin());
    JSAMPROW at = row.data();
    jpeg_write_scanlines(&jpeg, &at, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  const auto bytes = std::as_bytes(std::span(memory, size));
  const std::vector<std::byte> copy(bytes.begin(), bytes.end());
  std::free(memory);
  return copy;
}

float exr_value(int channel, int x, int y, Imf::PixelType type) {
  const int step = (7 * x + 13 * y + 29 * channel) % 64;
  return type == Imf::UINT ? static_cast<float>(step) : static_cast<float>(step + 64) / 8;
}

namespace {

Imf::Header header_of(const Exr& spec) {
  using Imath::Box2i, Imath::V2i;
  const Box2i data(V2i(spec.left, spec.top), V2i(spec.left + spec.width - 1, spec.top + spec.height - 1));
  const Box2i display =
      spec.display_width > 0 ? Box2i(V2i(0, 0), V2i(spec.display_width - 1, spec.display_height - 1)) : data;
  Imf::Header header(display, data);
  header.compression() = spec.compression;
  header.lineOrder() = spec.order;
  for (const std::string& name : spec.channels) header.channels().insert(name, Imf::Channel(spec.type));
  if (spec.tile > 0) {
    const auto edge = static_cast<unsigned>(spec.tile);
    header.setTileDescription(Imf::TileDescription(edge, edge, static_cast<Imf::LevelMode>(spec.levels)));
  }
  if (spec.seconds != 0) Imf::addExpTime(header, spec.seconds);
  if (spec.f_number != 0) Imf::addAperture(header, spec.f_number);
  if (spec.iso != 0) Imf::addIsoSpeed(header, spec.iso);
  if (!spec.part_name.empty()) {
    header.setName(spec.part_name);
    header.setType(spec.tile > 0 ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
  }
  return header;
}

/// All channels, each whole, as the 32 bit type that OpenEXR converts from.
class Planes {
 public:
  explicit Planes(const Exr& spec) {
    const std::size_t size = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    for (int c = 0; c < static_cast<int>(spec.channels.size()); ++c) {
      auto& plane = planes_.emplace_back(size * 4);
      for (int y = 0; y < spec.height; ++y) {
        for (int x = 0; x < spec.width; ++x) {
          char* at = plane.data() + static_cast<std::size_t>(y * spec.width + x) * bytes(spec.type);
          const float value = exr_value(c, x, y, spec.type);
          if (spec.type == Imf::HALF) new (at) half(value);
          if (spec.type == Imf::FLOAT) new (at) float(value);
          if (spec.type == Imf::UINT) new (at) unsigned(static_cast<unsigned>(value));
        }
      }
      const Imath::Box2i window(Imath::V2i(spec.left, spec.top),
                                Imath::V2i(spec.left + spec.width - 1, spec.top + spec.height - 1));
      frame_.insert(spec.channels[static_cast<std::size_t>(c)], Imf::Slice::Make(spec.type, plane.data(), window));
    }
  }
  const Imf::FrameBuffer& frame() const { return frame_; }

 private:
  static std::size_t bytes(Imf::PixelType type) { return type == Imf::HALF ? 2 : 4; }
  std::vector<std::vector<char>> planes_;
  Imf::FrameBuffer frame_;
};

void write_tiles(const Exr& spec, const fs::path& path, const Imf::Header& header) {
  const Planes planes(spec);
  Imf::TiledOutputFile file(path.c_str(), header, 0);
  file.setFrameBuffer(planes.frame());  // smaller levels show the beginning of the same planes
  for (int ly = 0; ly < file.numYLevels(); ++ly) {
    for (int lx = 0; lx < file.numXLevels(); ++lx) {
      if (!file.isValidLevel(lx, ly)) continue;
      file.writeTiles(0, file.numXTiles(lx) - 1, 0, file.numYTiles(ly) - 1, lx, ly);
    }
  }
}

}  // namespace

std::vector<std::byte> exr_file(const Exr& spec) {
  const TemporaryFolder folder;
  const fs::path path = folder / "made.exr";
  const Imf::Header header = header_of(spec);
  if (spec.tile > 0) {
    write_tiles(spec, path, header);
  } else {
    const Planes planes(spec);
    Imf::OutputFile file(path.c_str(), header, 0);
    file.setFrameBuffer(planes.frame());
    file.writePixels(spec.height - spec.missing_rows);
  }
  return read_file(path);
}

std::vector<std::byte> exr_file(const std::vector<Exr>& parts) {
  const TemporaryFolder folder;
  const fs::path path = folder / "made.exr";
  {
    std::vector<Imf::Header> headers;
    for (const Exr& part : parts) headers.push_back(header_of(part));
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()), false, 0);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const Planes planes(parts[p]);
      Imf::OutputPart part(file, static_cast<int>(p));
      part.setFrameBuffer(planes.frame());
      part.writePixels(parts[p].height);
    }
  }
  return read_file(path);
}

std::vector<std::byte> deep_exr_file() {
  const TemporaryFolder folder;
  const fs::path path = folder / "made.exr";
  {
    Imf::Header header(4, 4);
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    std::array<unsigned, 16> counts;
    counts.fill(1);
    std::array<float, 16> values = {};
    std::array<float*, 16> pointers;
    for (std::size_t i = 0; i < 16; ++i) pointers[i] = &values[i];
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(
        Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()), sizeof(unsigned), 4 * sizeof(unsigned)));
    for (const char* name : {"R", "G", "B"}) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      frame.insert(name, Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data()), sizeof(float*),
                                        4 * sizeof(float*), sizeof(float)));
    }
    Imf::DeepScanLineOutputFile file(path.c_str(), header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(4);
  }
  return read_file(path);
}

std::vector<std::byte> luminance_chroma_exr_file(const Image<Rgb>& image) {
  const TemporaryFolder folder;
  const fs::path path = folder / "made.exr";
  {
    std::vector<Imf::Rgba> pixels;
    for (const Rgb& p : image.values()) pixels.emplace_back(p.r, p.g, p.b);
    Imf::RgbaOutputFile file(path.c_str(), image.width(), image.height(), Imf::WRITE_YC);
    file.setFrameBuffer(pixels.data(), 1, static_cast<std::size_t>(image.width()));
    file.writePixels(image.height());
  }
  return read_file(path);
}

namespace {

std::vector<std::byte> saved(const Image<Rgb>& image, std::string_view name, const SaveOptions& options = {}) {
  const TemporaryFolder folder;
  save_picture(image, folder / name, options);
  return read_file(folder / name);
}

/// Rows of samples without any pattern that a compressor could fold away.
std::vector<std::uint8_t> noise(std::size_t count) {
  std::mt19937 random(7);
  std::vector<std::uint8_t> samples(count);
  for (std::uint8_t& sample : samples) sample = static_cast<std::uint8_t>(random());
  return samples;
}

std::vector<std::byte> tga_file(int type, int bits) {
  std::vector<std::byte> file = bytes_of({0, 0, type, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 0, 5, 0, bits, 0});
  const int pixels = 30, pixel_bytes = bits / 8;
  for (int i = 0; i<pixels; i += type> 8 ? 3 : 1) {
    if (type > 8)
      file.push_back(static_cast<std::byte>(i % 2 ? 0x82 : 0x02));  // three equal pixels, three different ones
    const int stored = type > 8 && i % 2 == 0 ? 3 : 1;
    for (int b = 0; b < stored * pixel_bytes; ++b) file.push_back(static_cast<std::byte>(17 * i + 5 * b));
  }
  return file;
}

}  // namespace

std::vector<Named> one_of_each() {
  Image<Rgb> smooth(20, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x)
      smooth(x, y) = Rgb(0.05f * static_cast<float>(x), 0.1f * static_cast<float>(y), x < 10 ? 0.25f : 4.0f);
  }
  std::vector<Named> all = {
      {"hdr", saved(smooth, "a.hdr")},
      {"hdr flat", bytes_of("#?RGBE\n\n-Y 2 +X 3\n") + bytes_of({9, 128, 7, 129, 1, 2, 200, 128, 0, 0, 0, 0}) +
                       bytes_of({128, 3, 3, 120, 128, 0, 0, 100, 0, 255, 0, 131})},
      {"pfm", saved(smooth, "a.pfm")},
      {"png 8", saved(smooth, "a.png")},
      {"png 16", saved(smooth, "a.png", {.png_bits = 16})},
      {"png interlaced",
       png_file(
           {.width = 9, .height = 7, .color_type = PNG_COLOR_TYPE_RGBA, .rows = noise(9 * 7 * 4), .interlaced = true})},
      {"png palette", png_file({.width = 8,
                                .height = 4,
                                .bits = 4,
                                .color_type = PNG_COLOR_TYPE_PALETTE,
                                .rows = noise(16),
                                .palette = std::vector<png_color>(16, {10, 20, 30})})},
      {"jpeg", jpeg_file({.width = 17, .height = 9, .samples = noise(17 * 9 * 3)})},
      {"jpeg progressive", jpeg_file({.width = 17, .height = 9, .samples = noise(17 * 9 * 3), .progressive = true})},
      {"jpeg grey", jpeg_file({.width = 17, .height = 9, .components = 1, .samples = noise(17 * 9)})},
      {"exr half", saved(smooth, "a.exr", {.exr_half = true})},
      {"exr float", saved(smooth, "a.exr")},
      {"exr tiles", exr_file(Exr{.tile = 8})},
      {"exr luminance-chroma", luminance_chroma_exr_file(smooth)},
      {"exr parts", exr_file(std::vector<Exr>{{.channels = {"Z"}, .part_name = "depth"}, {.part_name = "beauty"}})},
      {"tga 24", tga_file(2, 24)},
      {"tga rle 32", tga_file(10, 32)},
      {"tga rle grey", tga_file(11, 8)},
  };
  for (int c = Imf::NO_COMPRESSION; c < Imf::NUM_COMPRESSION_METHODS; ++c) {
    all.push_back(
        {"exr compression " + std::to_string(c), exr_file(Exr{.compression = static_cast<Imf::Compression>(c)})});
  }
  return all;
}

}  // namespace zonal::sample
