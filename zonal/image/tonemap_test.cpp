#include "zonal/image/tonemap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "zonal/image/color.h"

namespace zonal {
namespace {

double lightness(Rgb8 c) {
  const auto linear = [](std::uint8_t code) { return srgb_decode(static_cast<float>(code) / 255.0f); };
  const double y = luminance(Rgb{linear(c.r), linear(c.g), linear(c.b)});
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389.0 / 27;
}

TEST(Tonemap, BlackWhiteAndOrder) {
  EXPECT_EQ(tonemap(Rgb{0, 0, 0}, {}), (Rgb8{0, 0, 0}));
  EXPECT_EQ(tonemap(Rgb{8, 8, 8}, {.white = 8}), (Rgb8{255, 255, 255}));
  EXPECT_EQ(tonemap(Rgb{8e20f, 8e20f, 8e20f}, {.white = 8}), (Rgb8{255, 255, 255}));
  int last = -1, rises = 0;
  for (float light = 0.001f; light < 8; light *= 1.1f) {
    const Rgb8 c = tonemap(Rgb{light, light, light}, {});
    EXPECT_EQ(c.r, c.g);
    EXPECT_EQ(c.r, c.b);
    EXPECT_GE(c.r, last);
    rises += c.r > last;
    last = c.r;
  }
  EXPECT_GT(rises, 60);
}

TEST(Tonemap, ExposureIsAFactor) {
  EXPECT_EQ(tonemap(Rgb{0.4f, 0.2f, 0.1f}, {.exposure_ev = 1}), tonemap(Rgb{0.8f, 0.4f, 0.2f}, {}));
}

TEST(Tonemap, BrightColoursKeepTheirOrderOfChannels) {
  const Rgb8 c = tonemap(Rgb{4, 0.4f, 0.1f}, {});
  EXPECT_GT(c.r, c.g);
  EXPECT_GT(c.g, c.b);
}

TEST(Tonemap, DoubtfulValuesShowAsBlackOrWhite) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(tonemap(Rgb{nan, -1, 0}, {}), (Rgb8{0, 0, 0}));
  EXPECT_EQ(tonemap(Rgb{inf, inf, inf}, {}), (Rgb8{255, 255, 255}));
}

TEST(Tonemap, AutoExposurePutsTheLogMeanAtMiddleGrey) {
  Image<Rgb> picture(2, 1);
  picture(0, 0) = {0.1f, 0.1f, 0.1f};
  picture(1, 0) = {0.4f, 0.4f, 0.4f};  // geometric mean 0.2
  EXPECT_NEAR(auto_exposure_ev(picture), std::log2(0.18 / 0.2), 1e-6);
  EXPECT_EQ(auto_exposure_ev(Image<Rgb>(2, 2)), 0);
}

TEST(FalseColor, LightnessIsProportionalToTheValue) {
  int compared = 0;
  for (int i = 0; i <= 100; ++i, ++compared) {
    // One 8-bit code is up to 0.5 of L* where the curve is steepest (dark blue).
    EXPECT_NEAR(lightness(false_color(i / 100.0)), i, 0.6) << i;
  }
  EXPECT_EQ(compared, 101);
  EXPECT_EQ(false_color(0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(false_color(1), (Rgb8{255, 255, 255}));
  EXPECT_EQ(false_color(-3), false_color(0));
  EXPECT_EQ(false_color(std::numeric_limits<double>::quiet_NaN()), (Rgb8{255, 0, 255}));
}

TEST(FalseColor, PictureUsesItsFullScale) {
  Image<float> values(2, 1);
  values(1, 0) = 5;
  const Image<Rgb8> picture = false_color(values, 10);
  EXPECT_EQ(picture(0, 0), false_color(0));
  EXPECT_EQ(picture(1, 0), false_color(0.5));
}

}  // namespace
}  // namespace zonal
