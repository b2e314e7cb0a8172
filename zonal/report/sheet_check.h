#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "zonal/image/color.h"
#include "zonal/image/tonemap.h"
#include "zonal/io/picture.h"

namespace zonal {

/// The bytes of a base64 text. Only for tests.
inline std::vector<std::byte> base64_bytes(std::string_view text) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::byte> bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<unsigned>(kLetters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> count & 255));
  }
  return bytes;
}

/// The pictures inside a drawing, in their order, as the display codes they were made of. Only for tests.
inline std::vector<Image<Rgb8>> pictures_in(std::string_view svg) {
  constexpr std::string_view kBegin = "data:image/png;base64,";
  std::vector<Image<Rgb8>> pictures;
  for (std::size_t at = 0; (at = svg.find(kBegin, at)) != std::string_view::npos;) {
    at += kBegin.size();
    const Picture read = decode_picture("picture", base64_bytes(svg.substr(at, svg.find('"', at) - at)));
    Image<Rgb8>& picture = pictures.emplace_back(read.pixels.width(), read.pixels.height());
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const Rgb c = read.pixels(x, y);
        picture(x, y) = {srgb8(c.r), srgb8(c.g), srgb8(c.b)};
      }
    }
  }
  return pictures;
}

}  // namespace zonal
