#include "zonal/view/rgb9e5.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace zonal {
namespace {

TEST(Rgb9e5, HoldsWhatItPromises) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> mantissa(0, 1);
  int compared = 0;
  for (int exponent = -30; exponent <= 15; ++exponent) {
    for (int i = 0; i < 200; ++i) {
      const Rgb color = {std::ldexp(mantissa(random), exponent), std::ldexp(mantissa(random), exponent),
                         std::ldexp(mantissa(random), exponent)};
      const Rgb back = rgb_from_rgb9e5(rgb9e5(color));
      const float bound = std::max(max_channel(color) / 512, std::ldexp(1.0f, -25));
      for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
        EXPECT_LE(std::abs(back.*channel - color.*channel), bound) << color.*channel;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 46 * 200 * 3);
}

TEST(Rgb9e5, IsExactForItsOwnNumbers) {
  int compared = 0;
  // A shared exponent is only written when the largest channel needs it: its upper half, or the lowest exponent.
  for (std::uint32_t exponent = 0; exponent < 32; ++exponent) {
    for (std::uint32_t most = exponent == 0 ? 0 : 256; most < 512; most += 17) {
      const std::uint32_t packed = most | (most / 2) << 9 | (most / 3) << 18 | exponent << 27;
      if (most == 0) continue;
      EXPECT_EQ(rgb9e5(rgb_from_rgb9e5(packed)), packed);
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(Rgb9e5, LivesWithOddNumbers) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Rgb odd = rgb_from_rgb9e5(rgb9e5({std::nanf(""), -3, infinity}));
  EXPECT_EQ(odd.r, 0);
  EXPECT_EQ(odd.g, 0);
  EXPECT_EQ(odd.b, kRgb9e5Max);
  EXPECT_EQ(rgb9e5({0, 0, 0}), 0u);
  // 511.9 rounds up to 512 steps: the next power of two.
  EXPECT_EQ(rgb_from_rgb9e5(rgb9e5({511.9f, 0, 0})).r, 512);
  EXPECT_EQ(rgb_from_rgb9e5(rgb9e5({1e30f, 1e30f, 1e30f})).g, kRgb9e5Max);
}

}  // namespace
}  // namespace zonal
