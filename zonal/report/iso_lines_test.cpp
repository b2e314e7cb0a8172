#include "zonal/report/iso_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace zonal {
namespace {

bool is_blue(Rgb8 c) { return c.b > c.r && c.b > c.g; }
int sum(Rgb8 c) { return c.r + c.g + c.b; }

TEST(IsoLines, NegativeValuesAreBlueAndNoOthers) {
  const IsoScale scale = {.limit = 2, .step = 0.25};
  int negative = 0, other = 0;
  for (int i = -400; i <= 400; ++i) {
    const double value = i / 100.0;  // beyond the limit on both sides
    EXPECT_EQ(is_blue(iso_color(value, scale)), value < 0) << value;
    ++(value < 0 ? negative : other);
  }
  EXPECT_EQ(negative, 400);
  EXPECT_EQ(other, 401);
  EXPECT_FALSE(is_blue(iso_color(-0.0, scale)));
  EXPECT_TRUE(is_blue(iso_color(-std::numeric_limits<double>::min(), scale)));
}

TEST(IsoLines, StandsForTheSignOfEachPixelUnderTheLinesToo) {
  // A cone's slopes: lines in every direction, at every distance from a pixel's centre.
  Image<double> values(120, 120);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) values(x, y) = std::hypot(x - 59.3, y - 60.1) / 20 - 1.5;
  }
  const Image<Rgb8> picture = iso_lines(values, {.limit = 2, .step = 0.2});
  int negative = 0, whitened = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) {
      EXPECT_EQ(is_blue(picture(x, y)), values(x, y) < 0) << x << ' ' << y;
      negative += values(x, y) < 0;
      whitened += sum(picture(x, y)) > sum(iso_color(values(x, y), {.limit = 2, .step = 0.2})) + 100;
    }
  }
  EXPECT_NEAR(negative, kPi * 30 * 30, 60);  // its area, to a pixel of radius
  // A line every four pixels, one and a half wide with its soft edge.
  EXPECT_GT(whitened, 120 * 120 / 4);
  EXPECT_LT(whitened, 120 * 120 / 2);
}

TEST(IsoLines, LinesLieWhereTheLevelsAre) {
  Image<double> ramp(101, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 101; ++x) ramp(x, y) = (x - 50) / 50.0;
  }
  const Image<Rgb8> picture = iso_lines(ramp, {.limit = 1, .step = 0.4});
  int lines = 0;
  for (int x = 1; x < 100; ++x) {
    const bool bright = sum(picture(x, 1)) > 600;
    const bool level = x == 10 || x == 30 || x == 50 || x == 70 || x == 90;  // -0.8 -0.4 0 0.4 0.8
    EXPECT_EQ(bright, level) << x;
    lines += bright;
  }
  EXPECT_EQ(lines, 5);
}

TEST(IsoLines, NothingIsOneColourWithoutLines) {
  const Image<double> zero(8, 8, 0.0);
  const Image<Rgb8> nothing = iso_lines(zero, {});
  EXPECT_EQ(std::ranges::count(nothing.values(), iso_color(0, {})), 64);
  const Image<double> nan(8, 8, std::nan(""));
  const Image<Rgb8> unknown = iso_lines(nan, {.limit = 1, .step = 0.1});
  EXPECT_EQ(std::ranges::count(unknown.values(), Rgb8{128, 128, 128}), 64);
  EXPECT_TRUE(iso_lines(Image<double>(), {}).empty());
  EXPECT_THROW(iso_lines(zero, {.limit = -1}), std::logic_error);
}

TEST(IsoLines, TheKeyGoesFromBlueToRed) {
  const Image<Rgb8> key = iso_key({.limit = 3, .step = 0.5}, 100, 4);
  int blue = 0;
  for (int x = 0; x < 100; ++x) {
    EXPECT_EQ(is_blue(key(x, 2)), x < 50);
    blue += x < 50;
  }
  EXPECT_EQ(blue, 50);
  EXPECT_GT(key(99, 2).r, key(99, 2).g);
}

}  // namespace
}  // namespace zonal
