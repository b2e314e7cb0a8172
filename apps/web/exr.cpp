// OpenEXR in a page. The library of that name wants threads, files and exceptions, of which there are none: this is
// TinyEXR. Its compressions are none, RLE, ZIPS, ZIP and PIZ. Nothing is freed: a run shows one picture, and its memory
// goes with it. A broken file may lead this reader astray, but no farther than the memory of that run.
#include "zonal/io/exr.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

#include <tinyexr.h>

#include "zonal/io/exr_channels.h"
#include "zonal/io/exr_headers.h"

namespace zonal {
namespace {

constexpr const char* kHint =
    "a page reads OpenEXR uncompressed or with RLE, ZIP or PIZ; convert it: zonal convert IN.exr -o OUT.hdr (or "
    "OUT.pfm, which keeps every bit), or write a page for it: zonal view IN.exr --html PAGE.html";

/// What the reader says of itself ends with a line.
std::string words_of(const char* error) {
  std::string words = error != nullptr ? error : "its pixels cannot be decoded";
  while (!words.empty() && words.back() == '\n') words.pop_back();
  return words;
}

class Exr {
 public:
  explicit Exr(ByteReader& reader) : reader_(reader), bytes_(reader.head(reader.size())) {
    const unsigned char* bytes = bytes_.data();
    const std::size_t size = bytes_.size();
    ask([&](const char**) { return ParseEXRVersionFromMemory(&version_, bytes, size); });
    if (version_.multipart != 0) {
      EXRHeader** headers = nullptr;
      int count = 0;
      ask([&](const char** error) {
        return ParseEXRMultipartHeaderFromMemory(&headers, &count, &version_, bytes, size, error);
      });
      headers_.assign(headers, headers + count);
    } else {
      if (version_.non_image != 0) reader.fail("this OpenEXR is deep: it has no flat picture", "flatten it");
      headers_ = {new EXRHeader};
      InitEXRHeader(headers_[0]);
      ask([&](const char** error) { return ParseEXRHeaderFromMemory(headers_[0], &version_, bytes, size, error); });
    }
  }

  std::vector<ExrPart> parts() const {
    std::vector<ExrPart> parts;
    for (const EXRHeader* header : headers_) parts.push_back(part_of(*header));
    return parts;
  }

  const EXRHeader& header(int part) const { return *headers_[static_cast<std::size_t>(part)]; }

  /// All of the file, which is read at once.
  EXRImage decode(int part) {
    double bytes = 0;  // that no numbers of a header can overflow
    for (EXRHeader* header : headers_) {
      // Each block says where its rows go; the reader would turn those of another order upside down.
      header->line_order = 0;
      const EXRBox2i& window = header->data_window;
      bytes += 1.0 * sizeof(float) * header->num_channels * (1.0 + window.max_x - window.min_x) *
               (1.0 + window.max_y - window.min_y);
      for (int c = 0; c < header->num_channels; ++c) {
        const bool half = header->pixel_types[c] == TINYEXR_PIXELTYPE_HALF;
        if (half) header->requested_pixel_types[c] = TINYEXR_PIXELTYPE_FLOAT;
      }
    }
    // The reader does not ask whether it was given what it asks for.
    if (!(bytes < 1.0 * std::numeric_limits<std::size_t>::max())) throw std::bad_alloc();
    ::operator delete(::operator new(static_cast<std::size_t>(bytes)));

    std::vector<EXRImage> images(headers_.size());
    for (EXRImage& image : images) InitEXRImage(&image);
    ask([&](const char** error) {
      if (version_.multipart == 0) {
        return LoadEXRImageFromMemory(images.data(), headers_[0], bytes_.data(), bytes_.size(), error);
      }
      std::vector<const EXRHeader*> headers(headers_.begin(), headers_.end());
      return LoadEXRMultipartImageFromMemory(images.data(), headers.data(), static_cast<unsigned>(headers.size()),
                                             bytes_.data(), bytes_.size(), error);
    });
    const EXRImage& image = images[static_cast<std::size_t>(part)];
    check_tiles(header(part), image);
    return image;
  }

 private:
  static ExrPart part_of(const EXRHeader& header) {
    const auto window = [](const EXRBox2i& box) { return ExrWindow{box.min_x, box.min_y, box.max_x, box.max_y}; };
    ExrPart part{.name = header.name,
                 .is_deep = header.non_image != 0,
                 .channels = {},
                 .data = window(header.data_window),
                 .display = window(header.display_window),
                 .chromaticities = {},
                 .envmap = {}};
    for (int c = 0; c < header.num_channels; ++c) part.channels.emplace_back(header.channels[c].name);
    for (int i = 0; i < header.num_custom_attributes; ++i) {
      const EXRAttribute& attribute = header.custom_attributes[i];
      const std::string_view name = attribute.name;
      std::array<float, 8> primaries;
      if (name == "chromaticities" && attribute.size == sizeof(primaries)) {
        std::memcpy(primaries.data(), attribute.value, sizeof(primaries));
        part.chromaticities = primaries;
      }
      if (name == "envmap" && attribute.size == 1) part.envmap = attribute.value[0];
    }
    return part;
  }

  /// The reader believes what a tile says of its place.
  void check_tiles(const EXRHeader& header, const EXRImage& image) const {
    for (int i = 0; header.tiled != 0 && i < image.num_tiles; ++i) {
      const EXRTile& tile = image.tiles[i];
      const auto lies_in = [](int place, int step, int size, int limit) {
        return place >= 0 && std::int64_t{step} * place < limit && size >= 0 && size <= step;
      };
      if (lies_in(tile.offset_x, header.tile_size_x, tile.width, image.width) &&
          lies_in(tile.offset_y, header.tile_size_y, tile.height, image.height)) {
        continue;
      }
      reader_.fail("broken OpenEXR: a tile lies outside of the picture", "save it again");
    }
  }

  template <class Call>
  void ask(const Call& call) const {
    const char* error = nullptr;
    if (call(&error) != TINYEXR_SUCCESS) reader_.fail("OpenEXR that a page cannot read: " + words_of(error), kHint);
  }

  ByteReader& reader_;
  std::vector<std::uint8_t> bytes_;
  EXRVersion version_;
  std::vector<EXRHeader*> headers_;
};

/// Samples are words: of floats, or of whole numbers.
float sample(const unsigned char* samples, std::size_t place, int type) {
  std::uint32_t word;
  std::memcpy(&word, samples + sizeof(word) * place, sizeof(word));
  return type == TINYEXR_PIXELTYPE_UINT ? static_cast<float>(word) : std::bit_cast<float>(word);
}

/// One channel of the largest level.
template <class Set>
void each_sample(const EXRHeader& header, const EXRImage& image, int c, const Set& set) {
  const int type = header.requested_pixel_types[c];
  const auto index = static_cast<std::size_t>(c);
  if (header.tiled == 0) {
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        set(x, y, sample(image.images[index], static_cast<std::size_t>(y) * image.width + x, type));
      }
    }
    return;
  }
  for (int i = 0; i < image.num_tiles; ++i) {
    const EXRTile& tile = image.tiles[i];
    const int left = tile.offset_x * header.tile_size_x, top = tile.offset_y * header.tile_size_y;
    for (int y = 0; y < tile.height && top + y < image.height; ++y) {
      for (int x = 0; x < tile.width && left + x < image.width; ++x) {
        set(left + x, top + y, sample(tile.images[index], static_cast<std::size_t>(y) * header.tile_size_x + x, type));
      }
    }
  }
}

int channel_of(const EXRHeader& header, const std::string& name) {
  int c = 0;
  while (header.channels[c].name != name) ++c;
  return c;
}

}  // namespace

std::optional<Picture> load_exr(ByteReader& reader, const LoadOptions& options, const Run&) {
  if (!is_exr(reader)) return std::nullopt;
  check_exr_headers(reader, options);
  Exr file(reader);
  const ExrChoice choice = choose_exr_channels(reader, file.parts());
  if (choice.kind == ExrChoice::kLuminanceChroma) reader.fail("luminance-chroma OpenEXR is not read in a page", kHint);
  const EXRHeader& header = file.header(choice.part);
  for (int c = 0; c < header.num_channels; ++c) {
    if (header.channels[c].x_sampling == 1 && header.channels[c].y_sampling == 1) continue;
    reader.fail("subsampled OpenEXR is not read in a page", kHint);
  }
  const EXRImage image = file.decode(choice.part);

  Picture picture = exr_picture(choice, image.width, image.height);
  for (std::size_t i = 0; i < choice.channels.size(); ++i) {
    each_sample(header, image, channel_of(header, choice.channels[i]), [&](int x, int y, float value) {
      Rgb& pixel = picture.pixels(x, y);
      (i == 0 ? pixel.r : i == 1 ? pixel.g : pixel.b) = value;
      if (choice.kind == ExrChoice::kLuminance) pixel.g = pixel.b = value;
    });
  }
  return picture;
}

}  // namespace zonal
