#include "zonal/report/png_uri.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/io/png.h"

namespace zonal {

std::string base64(std::span<const std::byte> bytes) {
  static constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < here ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) out += k <= here ? kLetters[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string png_data_uri(const Image<Rgb8>& picture) {
  check(!picture.empty(), "a picture for the page must not be empty");
  return "data:image/png;base64," + base64(encode_png(picture));
}

}  // namespace zonal
