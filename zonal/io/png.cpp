#include "zonal/io/png.h"

#include <cmath>
#include <new>

#include "zonal/io/integer_samples.h"
#include "zonal/io/png_guard.h"

namespace zonal {
namespace {

void on_read(png_structp png, png_bytep into, png_size_t count) {
  auto* reader = static_cast<ByteReader*>(png_get_io_ptr(png));
  if (reader->read_some(std::as_writable_bytes(std::span(into, count))) == count) return;
  static_cast<PngFailure*>(png_get_error_ptr(png))->ended_early = true;
  png_error(png, "the file ends early");
}

class PngReader {
 public:
  explicit PngReader(ByteReader& reader) : reader_(reader) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure_, png_failed, png_warned);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) throw std::bad_alloc();
    png_set_read_fn(png_, &reader_, on_read);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }

  template <class Work>
  void run(const Work& work) {
    if (png_guarded(png_, work)) return;
    if (failure_.ended_early) reader_.fail_early_end();
    reader_.fail("broken PNG: " + std::string(failure_.message.data()));
  }

 private:
  ByteReader& reader_;
  PngFailure failure_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

/// Whether the file declares linear samples; notes what it says and we do not apply.
bool says_linear(png_structp png, png_infop info, Picture& picture) {
  constexpr double kSrgbGamma = 0.45455;  // the value that goes with sRGB (PNG specification, 11.3.3.2)
  double gamma = kSrgbGamma;
  png_get_gAMA(png, info, &gamma);
  if (png_get_valid(png, info, PNG_INFO_iCCP)) picture.notes.push_back("the embedded colour profile is not applied");
  if (png_get_valid(png, info, PNG_INFO_sRGB)) return false;
  if (std::abs(gamma - 1) < 0.01) return true;
  if (std::abs(gamma - kSrgbGamma) > 0.01) picture.notes.push_back("the gamma in the file is not applied");
  return false;
}

/// One row of samples, 8 or 16 bits big-endian, to linear colour. `stride`: samples a pixel, grey where it is below 3.
void decode_row(const std::uint8_t* bytes, int stride, bool wide, const std::vector<float>& linear,
                std::span<Rgb> row) {
  const auto sample = [&](std::size_t i) {
    return linear[wide ? static_cast<std::size_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]) : std::size_t{bytes[i]}];
  };
  for (std::size_t x = 0; x < row.size(); ++x) {
    const std::size_t at = x * static_cast<std::size_t>(stride);
    row[x] = stride < 3 ? Rgb(sample(at), sample(at), sample(at)) : Rgb(sample(at), sample(at + 1), sample(at + 2));
  }
}

}  // namespace

std::optional<Picture> load_png(ByteReader& reader, const LoadOptions& options, const Run&) {
  const std::vector<std::uint8_t> magic = reader.head(8);
  if (magic != std::vector<std::uint8_t>{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}) return std::nullopt;
  PngReader file(reader);
  const png_structp png = file.png();
  const png_infop info = file.info();
  file.run([&] {
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // our own limit follows
    png_read_info(png, info);
  });
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  check_picture_size(reader, width, height, options);
  // Deflate packs at most 1032 bytes into one.
  if (static_cast<std::uint64_t>(height) * png_get_rowbytes(png, info) / 1032 > reader.size()) reader.fail_early_end();

  Picture picture;
  picture.format = "PNG";
  const int color_type = png_get_color_type(png, info);
  picture.alpha = (color_type & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  picture.channels = ((color_type & PNG_COLOR_MASK_COLOR) != 0 ? 3 : 1) + (picture.alpha ? 1 : 0);
  const bool wide = png_get_bit_depth(png, info) == 16;
  const bool srgb = decide_srgb(options, says_linear(png, info, picture), picture);

  int passes = 1;
  file.run([&] {
    png_set_expand(png);
    passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
  });
  const int stride = png_get_channels(png, info);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  const std::vector<float> linear = linear_of_samples(wide ? 16 : 8, srgb);
  picture.pixels = Image<Rgb>(static_cast<int>(width), static_cast<int>(height));
  // An interlaced file is complete only after its last pass; otherwise a row is complete at once.
  std::vector<std::uint8_t> rows(passes == 1 ? row_bytes : row_bytes * height);
  file.run([&] {
    for (int pass = 0; pass < passes; ++pass) {
      for (png_uint_32 y = 0; y < height; ++y) {
        std::uint8_t* row = rows.data() + (passes == 1 ? 0 : y * row_bytes);
        png_read_row(png, row, nullptr);
        if (pass == passes - 1) decode_row(row, stride, wide, linear, picture.pixels.row(static_cast<int>(y)));
      }
    }
    png_read_end(png, nullptr);
  });
  return picture;
}

}  // namespace zonal
