#include "zonal/report/png_uri.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "zonal/image/color.h"
#include "zonal/io/picture.h"

namespace zonal {
namespace {

constexpr std::string_view kPrefix = "data:image/png;base64,";

std::vector<std::byte> from_base64(std::string_view text) {
  static constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::byte> out;
  std::size_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6 | kLetters.find(c);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out.push_back(static_cast<std::byte>(bits >> count));
  }
  return out;
}

TEST(PngUri, HoldsEveryPixel) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> byte(0, 255);
  const auto next = [&] { return static_cast<std::uint8_t>(byte(random)); };
  int compared = 0;
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{7, 3}, std::pair{64, 33}}) {
    Image<Rgb8> picture(width, height);
    for (Rgb8& pixel : picture.values()) pixel = {next(), next(), next()};
    const std::string uri = png_data_uri(picture);
    EXPECT_EQ(uri, png_data_uri(picture));
    ASSERT_TRUE(uri.starts_with(kPrefix));
    const Image<Rgb> back = decode_picture("a.png", from_base64(std::string_view(uri).substr(kPrefix.size()))).pixels;
    ASSERT_EQ(back.width(), width);
    ASSERT_EQ(back.height(), height);
    for (std::size_t i = 0; i < picture.size(); ++i) {
      const Rgb linear = back.values()[i];
      ASSERT_EQ((Rgb8{srgb8(linear.r), srgb8(linear.g), srgb8(linear.b)}), picture.values()[i]);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 1 + 21 + 64 * 33);
}

TEST(PngUri, RefusesNothing) { EXPECT_THROW(png_data_uri({}), std::logic_error); }

}  // namespace
}  // namespace zonal
