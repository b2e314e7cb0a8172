#include "zonal/io/base64.h"

#include <string_view>

namespace zonal {

std::string base64_text(std::span<const std::byte> bytes) {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  for (std::size_t bit = 0, digit = 0; bit < 8 * bytes.size(); bit += 6, ++digit) {
    const std::size_t i = bit / 8;
    const unsigned first = std::to_integer<unsigned>(bytes[i]) << 8;
    const unsigned pair = first | (i + 1 < bytes.size() ? std::to_integer<unsigned>(bytes[i + 1]) : 0);
    text[digit] = kDigits[pair >> (10 - bit % 8) & 63];
  }
  return text;
}

}  // namespace zonal
