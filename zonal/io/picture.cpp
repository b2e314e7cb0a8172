#include "zonal/io/picture.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/exif.h"
#include "zonal/io/exr.h"
#include "zonal/io/hdr.h"
#include "zonal/io/pfm.h"
#include "zonal/io/picture_loaders.h"
#include "zonal/io/picture_writer.h"
#include "zonal/io/png.h"

namespace zonal {
namespace {

struct Format {
  std::string_view extension;
  PictureWriter write;
};

constexpr std::array<Format, 4> kWriters = {
    {{".exr", write_exr}, {".hdr", write_hdr}, {".pfm", write_pfm}, {".png", write_png}}};

void note_orientation(const ByteReader& file, Picture& picture) {
  ByteReader reader = file.another();
  const int orientation = exif_orientation(find_exif(reader));
  if (orientation <= 1) return;
  picture.notes.push_back("the EXIF orientation (" + std::to_string(orientation) +
                          ") is not applied: pixels are taken as stored");
}

Picture decode(ByteReader& reader, const LoadOptions& options, const Run& run) {
  if (reader.size() == 0) reader.fail("the file is empty", "copy or download it again");
  for (const PictureLoader load : picture_loaders()) {
    std::optional<Picture> picture = load(reader, options, run);
    if (!picture) continue;
    const bool is_float = picture->format == "OpenEXR" || picture->format == "Radiance HDR" || picture->format == "PFM";
    if (is_float && options.encoding == Encoding::kSrgb) {
      picture->notes.push_back("float pictures are linear: the sRGB option is ignored");
    }
    note_orientation(reader, *picture);
    if (picture->alpha) picture->notes.push_back("alpha is left out; colours are not divided by it");
    return std::move(*picture);
  }
  reader.fail("this is not a picture that can be read", "use " + std::string(picture_format_names()));
}

}  // namespace

Picture load_picture(const std::filesystem::path& path, const LoadOptions& options, const Run& run) {
  ByteReader reader(path);
  return decode(reader, options, run);
}

Picture decode_picture(std::string name, std::vector<std::byte> bytes, const LoadOptions& options, const Run& run) {
  ByteReader reader(std::move(name), std::move(bytes));
  return decode(reader, options, run);
}

static std::optional<PictureWriter> picture_writer_for(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  for (const Format& format : kWriters) {
    if (format.extension == extension) return format.write;
  }
  return std::nullopt;
}

PictureWriter require_picture_writer(const std::filesystem::path& path) {
  const std::optional<PictureWriter> writer = picture_writer_for(path);
  if (!writer) {
    throw Error(ErrorKind::kUsage, path.string() + ": this extension names no format that can be written",
                "use .exr, .hdr, .pfm or .png");
  }
  return *writer;
}

bool can_save_picture(const std::filesystem::path& path) { return picture_writer_for(path).has_value(); }

SaveReport save_picture(const Image<Rgb>& image, const std::filesystem::path& path, const SaveOptions& options) {
  check(!image.empty(), "an empty picture cannot be saved");
  const PictureWriter write = require_picture_writer(path);
  OutputFile file(path);
  const SaveReport report = write(image, file, options);
  file.commit();
  return report;
}

void check_picture_size(const ByteReader& reader, std::int64_t width, std::int64_t height, const LoadOptions& options) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width <= 0 || height <= 0) reader.fail("broken: a picture of " + size + " pixels");
  constexpr std::int64_t kLongestSide = std::numeric_limits<int>::max();
  if (width > kLongestSide || height > kLongestSide) reader.fail("a side is too long: " + size + " pixels");
  if (width > options.max_pixels / height) {
    reader.fail("the picture has " + size + " pixels; the limit is " + std::to_string(options.max_pixels) + " in all",
                "raise --max-pixels if you trust the file (12 bytes of memory a pixel)");
  }
}

}  // namespace zonal
