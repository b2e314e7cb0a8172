#include "zonal/image/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace zonal {
namespace {

TEST(Color, KnownPointsOfTheStandard) {
  EXPECT_EQ(srgb_decode(0.0f), 0.0f);
  EXPECT_EQ(srgb_decode(1.0f), 1.0f);
  EXPECT_EQ(srgb_encode(1.0f), 1.0f);
  // 18 % grey, and code 128: values every colour text prints.
  EXPECT_NEAR(srgb_encode(0.18f), 0.461356f, 1e-6f);
  EXPECT_NEAR(srgb_decode(128 / 255.0f), 0.215861f, 1e-6f);
  // On the straight part the slope is 12.92.
  EXPECT_FLOAT_EQ(srgb_encode(0.001f), 0.01292f);
}

TEST(Color, TheCurveHasNoStep) {
  // The standard's rounded constants leave a step of 3e-8 in linear light at the knee.
  const float below = std::nextafter(0.04045f, 0.0f), above = std::nextafter(0.04045f, 1.0f);
  EXPECT_NEAR(srgb_decode(below), srgb_decode(above), 4e-8f);
  EXPECT_LE(srgb_decode(below), srgb_decode(above));
}

TEST(Color, RoundTripOfAllCodes) {
  int compared = 0;
  for (int code = 0; code < 256; ++code, ++compared) {
    EXPECT_EQ(srgb8(srgb_decode(static_cast<float>(code) / 255.0f)), code);
  }
  EXPECT_EQ(compared, 256);
}

TEST(Color, RoundTripBothWaysAndBeyondTheDisplay) {
  int compared = 0;
  for (float linear = -2; linear < 20; linear += 0.0137f, ++compared) {
    // pow and its inverse round to float once each; the power magnifies the first rounding 2.4 times.
    EXPECT_NEAR(srgb_decode(srgb_encode(linear)), linear, 3e-7f * std::abs(linear) + 1e-9f);
  }
  EXPECT_GT(compared, 1500);
}

TEST(Color, EightBitClamps) {
  EXPECT_EQ(srgb8(-1.0f), 0);
  EXPECT_EQ(srgb8(7.0f), 255);
  EXPECT_EQ(srgb8(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(srgb8(std::numeric_limits<float>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace zonal
