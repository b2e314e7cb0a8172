#include "zonal/view/page_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <string_view>
#include <vector>

#include "zonal/base/check.h"

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

std::size_t PageBytes::add_planes(std::span<const std::byte> numbers, std::size_t width) {
  const std::size_t count = numbers.size() / width;
  std::string planes(numbers.size(), 0);
  for (std::size_t plane = 0; plane < width; ++plane) {
    const std::size_t place = std::endian::native == std::endian::little ? plane : width - 1 - plane;
    for (std::size_t i = 0; i < count; ++i) planes[plane * count + i] = std::to_integer<char>(numbers[i * width + place]);
  }
  const auto [found, is_new] = known_.try_emplace(std::move(planes), bytes_.size());
  if (is_new) bytes_ += found->first;
  return found->second;
}

std::string PageBytes::text() const {
  uLongf length = compressBound(static_cast<uLong>(bytes_.size()));
  std::vector<std::byte> packed(length);
  const int result = compress2(reinterpret_cast<Bytef*>(packed.data()), &length,
                               reinterpret_cast<const Bytef*>(bytes_.data()), static_cast<uLong>(bytes_.size()), 9);
  check(result == Z_OK, "zlib's own bound is enough for its result");
  return base64_text(std::span(packed).first(length));
}

}  // namespace zonal
