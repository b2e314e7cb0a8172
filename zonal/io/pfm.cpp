#include "zonal/io/pfm.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace zonal {
namespace {

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// The next word of the header; takes the one space after it, so that after the last word comes the first pixel.
std::string read_word(ByteReader& reader) {
  constexpr std::size_t kLongest = 64;
  char c = static_cast<char>(reader.byte());
  while (is_space(c)) c = static_cast<char>(reader.byte());
  std::string word;
  for (; !is_space(c); c = static_cast<char>(reader.byte())) {
    if (word.size() == kLongest) reader.fail("broken PFM: the header has a word that does not end");
    word += c;
  }
  return word;
}

template <class Number>
Number read_number(ByteReader& reader, const char* what) {
  const std::string word = read_word(reader);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) {
    reader.fail(std::string("broken PFM: the ") + what + " in the header is not a number");
  }
  return number;
}

float float_at(const std::byte* bytes, bool little_endian) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) {
    bits |= static_cast<std::uint32_t>(bytes[i]) << (8 * (little_endian ? i : 3 - i));
  }
  return std::bit_cast<float>(bits);
}

}  // namespace

std::optional<Picture> load_pfm(ByteReader& reader, const LoadOptions& options, const Run&) {
  const std::vector<std::uint8_t> magic = reader.head(3);
  if (magic.size() < 3 || magic[0] != 'P' || (magic[1] != 'F' && magic[1] != 'f') ||
      !is_space(static_cast<char>(magic[2]))) {
    return std::nullopt;
  }
  reader.seek(2);
  const auto width = read_number<std::int64_t>(reader, "width");
  const auto height = read_number<std::int64_t>(reader, "height");
  const auto scale = read_number<float>(reader, "scale");
  check_picture_size(reader, width, height, options);
  if (scale == 0 || !std::isfinite(scale)) reader.fail("broken PFM: the scale is zero or not finite");
  Picture picture;
  picture.format = "PFM";
  picture.channels = magic[1] == 'F' ? 3 : 1;
  const auto row_bytes = static_cast<std::uint64_t>(4 * picture.channels * width);
  if (reader.remaining() < row_bytes * static_cast<std::uint64_t>(height)) reader.fail_early_end();

  picture.pixels = Image<Rgb>(static_cast<int>(width), static_cast<int>(height));
  const float factor = std::abs(scale);
  if (factor != 1) picture.notes.push_back("values are multiplied by the header's scale, " + std::to_string(factor));
  std::vector<std::byte> bytes(row_bytes);
  for (int y = picture.pixels.height() - 1; y >= 0; --y) {
    reader.read(bytes);
    const std::byte* at = bytes.data();
    const auto next = [&] {
      const float value = float_at(at, scale < 0);
      at += 4;
      return factor == 1 ? value : factor * value;
    };
    for (Rgb& pixel : picture.pixels.row(y)) {
      pixel.r = next();
      pixel.g = picture.channels == 3 ? next() : pixel.r;
      pixel.b = picture.channels == 3 ? next() : pixel.r;
    }
  }
  return picture;
}

SaveReport write_pfm(const Image<Rgb>& image, OutputFile& file, const SaveOptions&) {
  const std::string header = "PF\n" + std::to_string(image.width()) + " " + std::to_string(image.height()) + "\n-1.0\n";
  file.write(std::as_bytes(std::span(header)));
  std::vector<std::byte> bytes(12 * static_cast<std::size_t>(image.width()));
  for (int y = image.height() - 1; y >= 0; --y) {
    std::byte* at = bytes.data();
    for (const Rgb& pixel : image.row(y)) {
      for (const float value : {pixel.r, pixel.g, pixel.b}) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (int shift = 0; shift < 32; shift += 8) *at++ = static_cast<std::byte>(bits >> shift & 255);
      }
    }
    file.write(bytes);
  }
  return {};
}

}  // namespace zonal
