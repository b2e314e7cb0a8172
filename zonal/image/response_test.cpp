#include "zonal/image/response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "zonal/image/color.h"

namespace zonal {
namespace {

TEST(Response, GivenCurvesAreWhatTheySay) {
  const Response linear = Response::linear(), srgb = Response::srgb();
  int compared = 0;
  for (int z = 0; z < kCodes; ++z) {
    for (int c = 0; c < 3; ++c, ++compared) {
      EXPECT_EQ(linear(c, z / 255.0), z / 255.0);
      EXPECT_NEAR(srgb(c, z / 255.0), srgb_decode(static_cast<float>(z / 255.0)), 1e-12);
    }
  }
  EXPECT_EQ(compared, 768);
  EXPECT_EQ(srgb(0, kMiddleCode / 255.0), middle_exposure());
}

TEST(Response, BetweenAndBeyondTheCodes) {
  const Response linear = Response::linear();
  EXPECT_NEAR(linear(1, 0.12345), 0.12345, 1e-15);
  EXPECT_NEAR(linear(1, 3.5), 3.5, 1e-12);  // float pictures
  EXPECT_NEAR(linear(1, -0.25), -0.25, 1e-12);
}

TEST(MakeMonotone, IsTheNearestCurveThatDoesNotFall) {
  std::vector<double> curve = {0, 3, 1, 2, 5, 4, 4, 7};
  const std::vector<double> weights = {1, 1, 1, 2, 1, 3, 1, 1};
  EXPECT_EQ(make_monotone(curve, weights), 5);
  // (3 + 1 + 2·2) / 4 and (5 + 3·4 + 4) / 5, by hand.
  const std::vector<double> expected = {0, 2, 2, 2, 4.2, 4.2, 4.2, 7};
  for (std::size_t i = 0; i < curve.size(); ++i) EXPECT_NEAR(curve[i], expected[i], 1e-12) << i;
  EXPECT_EQ(make_monotone(curve, weights), 0);
}

TEST(MakeMonotone, ValuesWithoutWeightYieldToTheOthers) {
  std::vector<double> curve = {1, 9, 2};
  const std::vector<double> weights = {1, 0, 1};
  EXPECT_EQ(make_monotone(curve, weights), 2);
  EXPECT_NEAR(curve[1], 2, 1e-6);  // its own weight is a billionth
  EXPECT_NEAR(curve[2], 2, 1e-6);
}

TEST(CodeWeight, EndsAtZeroAndIsOneInTheMiddle) {
  for (const CodeWeight kind : {CodeWeight::kHat, CodeWeight::kGaussian}) {
    for (const TrustedCodes trusted : {TrustedCodes{}, TrustedCodes{20, 240}}) {
      EXPECT_EQ(code_weight(kind, trusted, trusted.lowest / 255), 0);
      EXPECT_EQ(code_weight(kind, trusted, trusted.highest / 255), 0);
      EXPECT_EQ(code_weight(kind, trusted, 0), 0);
      EXPECT_EQ(code_weight(kind, trusted, 1), 0);
      EXPECT_NEAR(code_weight(kind, trusted, (trusted.lowest + trusted.highest) / 510), 1, 1e-12);
      EXPECT_EQ(code_weight(kind, trusted, std::numeric_limits<double>::quiet_NaN()), 0);
      for (int i = 1; i < 50; ++i) {
        const double step = i / 50.0, middle = (trusted.lowest + trusted.highest) / 510;
        const double half = (trusted.highest - trusted.lowest) / 510;
        const double weight = code_weight(kind, trusted, middle + step * half);
        EXPECT_NEAR(weight, code_weight(kind, trusted, middle - step * half), 1e-9);
        const double end = std::exp(-4.0);
        const double expected = kind == CodeWeight::kHat ? 1 - step : (std::exp(-4 * step * step) - end) / (1 - end);
        EXPECT_NEAR(weight, expected, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace zonal
