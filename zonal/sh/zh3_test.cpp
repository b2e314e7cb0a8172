#include "zonal/sh/zh3.h"

#include <gtest/gtest.h>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

double squared_norm(const Sh<double, 3>& sh) {
  double sum = 0;
  for (const double value : sh.values()) sum += value * value;
  return sum;
}

TEST(Zh3, KeepsEveryZonalFunction) {
  const std::vector<double> zonal = {1, 0.7, -0.4};
  int compared = 0;
  for (const Vec3 d : spiral_directions(20)) {
    const Sh<double, 3> sh = zonal_toward<3>(zonal, d);
    const Zh3<double> compact = zh3(sh);
    EXPECT_NEAR(compact.zonal, -0.4, 1e-15);
    EXPECT_NEAR(squared_norm(expand(compact) - sh), 0, 1e-30);
    ++compared;
  }
  EXPECT_EQ(compared, 20);
}

TEST(Zh3, IsTheNearestAboutItsAxis) {
  Sh<double, 3> sh;
  for (int i = 0; i < 9; ++i) sh[i] = std::sin(1.0 + i);
  const Zh3<double> best = zh3(sh);
  const double least = squared_norm(expand(best) - sh);
  EXPECT_GT(least, 0.1);  // a general function does lose something
  for (const double step : {-1e-3, 1e-3}) {
    Zh3<double> other = best;
    other.zonal += step;
    EXPECT_NEAR(squared_norm(expand(other) - sh) - least, 1e-6, 1e-14);
  }
}

TEST(Zh3, ColoursShareTheAxisOfTheirLuminance) {
  Sh<RgbD, 3> sh;
  for (int i = 0; i < 9; ++i) sh[i] = {std::sin(1.0 + i), std::cos(2.0 * i), 0.1 * i};
  const Sh<RgbD, 3> back = expand(zh3(sh));
  const Vec3 axis = normalize({luminance(sh(1, 1)), luminance(sh(1, -1)), luminance(sh(1, 0))});
  const Sh<double, 3> about_axis = zonal_toward<3>(std::vector<double>{0, 0, 1}, axis);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(back[i], sh[i]);
  for (int i = 4; i < 9; ++i) {
    EXPECT_NEAR(back[i].r, zh3(sh).zonal.r * about_axis[i], 1e-15);
    EXPECT_NEAR(back[i].g, zh3(sh).zonal.g * about_axis[i], 1e-15);
  }
}

TEST(Zh3, GuessHelpsForADiscOfLightAndAnAmbientTerm) {
  // Cone of 45 degrees over its surroundings: its band factors are integrals of P_0, P_1, P_2 over the cap.
  const double c = std::sqrt(0.5);
  const std::vector<double> cap = {2 * kPi * (1 - c), kPi * (1 - c * c), kPi * c * (1 - c * c)};
  Sh<double, 3> light = zonal_toward<3>(zonal_from_factors(cap), normalize({1, 2, -0.5}));
  light(0, 0) += 1;
  const Sh<double, 2> two = with_bands<2>(light);
  const Sh<double, 3> guessed = expand(zh3_guess(two));
  EXPECT_LT(squared_norm(guessed - light), 0.5 * squared_norm(with_bands<3>(two) - light));
  // The formula itself: l0 = 2, |l1| = 1.
  Sh<double, 2> plain;
  plain(0, 0) = 2;
  plain(1, 0) = -1;
  EXPECT_NEAR(zh3_guess(plain).zonal, 0.08 + 0.6 / 2, 1e-16);
  EXPECT_NEAR(expand(zh3_guess(plain))(2, 0), 0.38, 1e-15);
}

TEST(Zh3, WithoutAnAxisOrAMeanItIsTwoBands) {
  Sh<float, 3> even;
  even(0, 0) = 1;
  even(2, 1) = 1;
  EXPECT_EQ(zh3(even).zonal, 0);
  EXPECT_EQ(expand(zh3(even))(2, 1), 0);
  Sh<Rgb, 2> one_channel;
  one_channel(0, 0) = {1, 0, 0};
  one_channel(1, 1) = {0.5f, 0, 0};
  EXPECT_GT(zh3_guess(one_channel).zonal.r, 0);
  EXPECT_EQ(zh3_guess(one_channel).zonal.g, 0);
  EXPECT_EQ(expand(zh3_guess(Sh<Rgb, 2>())), (Sh<Rgb, 3>()));
}

}  // namespace
}  // namespace zonal
