#include "zonal/io/tga.h"

#include <array>

#include "zonal/io/integer_samples.h"

namespace zonal {
namespace {

constexpr std::size_t kHeaderBytes = 18;

struct Header {
  int id_bytes = 0;
  bool run_length = false;
  enum Kind { kPalette = 1, kColor = 2, kGrey = 3 } kind = kColor;
  int palette_first = 0, palette_count = 0, palette_bits = 0;
  int width = 0, height = 0, bits = 0;
  int alpha_bits = 0;
  bool right_to_left = false, top_to_bottom = false;
};

bool is_color_depth(int bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

/// nullopt: these bytes are not the header of a TGA.
std::optional<Header> parse(const std::vector<std::uint8_t>& b) {
  if (b.size() < kHeaderBytes) return std::nullopt;
  const auto word = [&](std::size_t at) { return b[at] | b[at + 1] << 8; };
  Header h;
  const int palette_type = b[1], type = b[2], descriptor = b[17];
  h.run_length = (type & 8) != 0;
  if ((type & ~8) < 1 || (type & ~8) > 3 || palette_type > 1 || (descriptor & 0xc0) != 0) return std::nullopt;
  h.kind = static_cast<Header::Kind>(type & 7);
  h.id_bytes = b[0];
  h.palette_first = word(3);
  h.palette_count = word(5);
  h.palette_bits = b[7];
  h.width = word(12);
  h.height = word(14);
  h.bits = b[16];
  h.alpha_bits = descriptor & 15;
  h.right_to_left = (descriptor & 16) != 0;
  h.top_to_bottom = (descriptor & 32) != 0;
  if (h.width == 0 || h.height == 0 || h.alpha_bits > 8) return std::nullopt;
  if (palette_type == 0) h.palette_count = h.palette_bits = 0;  // some programs leave rubbish there
  if (h.palette_count > 0 && !is_color_depth(h.palette_bits)) return std::nullopt;
  switch (h.kind) {
    case Header::kPalette:
      if (h.palette_count == 0 || (h.bits != 8 && h.bits != 16)) return std::nullopt;
      break;
    case Header::kColor:
      if (!is_color_depth(h.bits)) return std::nullopt;
      break;
    case Header::kGrey:
      if (h.bits != 8 && h.bits != 16) return std::nullopt;  // 16: grey and alpha
      break;
  }
  return h;
}

/// Turns the bytes of one stored pixel into linear colour.
class PixelDecoder {
 public:
  PixelDecoder(ByteReader& reader, const Header& header, bool srgb)
      : header_(header), eight_(linear_of_samples(8, srgb)), five_(linear_of_samples(5, srgb)) {
    std::array<std::uint8_t, 4> bytes = {};
    for (int i = 0; i < header.palette_count; ++i) {
      reader.read(std::span(bytes).first(bytes_of(header.palette_bits)));
      palette_.push_back(color(bytes.data(), header.palette_bits));
    }
  }

  static std::size_t bytes_of(int bits) { return static_cast<std::size_t>((bits + 7) / 8); }

  Rgb operator()(const ByteReader& reader, const std::uint8_t* bytes) const {
    if (header_.kind == Header::kGrey) return Rgb(eight_[bytes[0]], eight_[bytes[0]], eight_[bytes[0]]);
    if (header_.kind == Header::kColor) return color(bytes, header_.bits);
    const int index = (header_.bits == 8 ? bytes[0] : bytes[0] | bytes[1] << 8) - header_.palette_first;
    if (index < 0 || index >= header_.palette_count)
      reader.fail("broken TGA: a pixel names a colour outside the palette");
    return palette_[static_cast<std::size_t>(index)];
  }

 private:
  Rgb color(const std::uint8_t* bytes, int bits) const {
    if (bits >= 24) return Rgb(eight_[bytes[2]], eight_[bytes[1]], eight_[bytes[0]]);
    const unsigned word = bytes[0] | static_cast<unsigned>(bytes[1]) << 8;  // ARRRRRGGGGGBBBBB
    return Rgb(five_[word >> 10 & 31], five_[word >> 5 & 31], five_[word & 31]);
  }

  const Header& header_;
  std::vector<float> eight_, five_;
  std::vector<Rgb> palette_;
};

/// Stored pixels in file order. Runs may cross the ends of rows.
class PixelStream {
 public:
  PixelStream(ByteReader& reader, const Header& header, const PixelDecoder& decoder)
      : reader_(reader),
        run_length_(header.run_length),
        bytes_(PixelDecoder::bytes_of(header.bits)),
        decoder_(decoder) {}

  Rgb next() {
    if (!run_length_) return fetch();
    if (left_ == 0) {
      const int packet = reader_.byte();
      left_ = (packet & 127) + 1;
      repeated_ = (packet & 128) != 0;
      if (repeated_) pixel_ = fetch();
    }
    --left_;
    return repeated_ ? pixel_ : fetch();
  }

 private:
  Rgb fetch() {
    std::array<std::uint8_t, 4> bytes = {};
    reader_.read(std::span(bytes).first(bytes_));
    return decoder_(reader_, bytes.data());
  }

  ByteReader& reader_;
  bool run_length_;
  std::size_t bytes_;
  const PixelDecoder& decoder_;
  int left_ = 0;
  bool repeated_ = false;
  Rgb pixel_;
};

}  // namespace

std::optional<Picture> load_tga(ByteReader& reader, const LoadOptions& options, const Run&) {
  const std::optional<Header> header = parse(reader.head(kHeaderBytes));
  if (!header) return std::nullopt;
  check_picture_size(reader, header->width, header->height, options);
  reader.seek(kHeaderBytes + static_cast<std::size_t>(header->id_bytes));

  Picture picture;
  picture.format = "TGA";
  const int color_bits = header->kind == Header::kPalette ? header->palette_bits : header->bits;
  picture.alpha = color_bits == 32 || (header->kind == Header::kGrey && color_bits == 16) ||
                  (color_bits == 16 && header->alpha_bits > 0);
  picture.channels = (header->kind == Header::kGrey ? 1 : 3) + (picture.alpha ? 1 : 0);
  const PixelDecoder decoder(reader, *header, decide_srgb(options, false, picture));

  // The least the pixels can take: one packet for 128 of them when run-length coded.
  const std::uint64_t pixels = static_cast<std::uint64_t>(header->width) * static_cast<std::uint64_t>(header->height);
  const std::uint64_t pixel_bytes = PixelDecoder::bytes_of(header->bits);
  if (reader.remaining() < (header->run_length ? (pixels + 127) / 128 * (1 + pixel_bytes) : pixels * pixel_bytes)) {
    reader.fail_early_end();
  }
  picture.pixels = Image<Rgb>(header->width, header->height);
  PixelStream stream(reader, *header, decoder);
  for (int j = 0; j < header->height; ++j) {
    const int y = header->top_to_bottom ? j : header->height - 1 - j;
    for (int i = 0; i < header->width; ++i) {
      picture.pixels(header->right_to_left ? header->width - 1 - i : i, y) = stream.next();
    }
  }
  return picture;
}

}  // namespace zonal
