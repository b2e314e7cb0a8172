#include "zonal/sh/vector_irradiance.h"

#include <gtest/gtest.h>

#include <random>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

template <int N>
Sh<double, N> random_function(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Sh<double, N> sh;
  for (double& value : sh.values()) value = normal(random);
  return sh;
}

TEST(VectorIrradiance, IsTheIntegralOfLightTimesDirection) {
  std::mt19937 random(1);
  const Sh<double, 5> radiance = random_function<5>(random);
  Vec3 sum;
  for (const auto& [direction, weight] : sphere_rule(6)) sum += weight * evaluate(radiance, direction) * direction;
  EXPECT_NEAR(length(sum - vector_irradiance(radiance)), 0, 1e-13);
}

TEST(VectorIrradiance, IsWhatPassesThroughASurface) {
  std::mt19937 random(2);
  const Sh<double, 6> radiance = random_function<6>(random), e = irradiance(radiance);
  int compared = 0;
  for (const Vec3 n : spiral_directions(50)) {
    EXPECT_NEAR(evaluate(e, n) - evaluate(e, -n), net_irradiance(vector_irradiance(radiance), n), 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 50);
}

TEST(VectorIrradiance, IsAllThereIsToOneDirectionalLight) {
  // Many bands, so that the truncated cosine is one: its error falls like bands^-2.
  const Vec3 toward = normalize({1, -2, 2});
  Sh<double> radiance = zonal_toward(delta_zonal(100), toward);
  radiance *= 3;
  const Vec3 e = vector_irradiance(radiance);
  EXPECT_NEAR(length(e - 3 * toward), 0, 1e-14);
  const Sh<double> exact = irradiance(radiance);
  int compared = 0;
  for (const Vec3 n : spiral_directions(40)) {
    EXPECT_NEAR(irradiance_from_vector(e, n), evaluate(exact, n), 0.02);
    EXPECT_EQ(irradiance_from_vector(e, n), std::max(3 * dot(n, toward), 0.0) > 0 ? dot(n, e) : 0);
    ++compared;
  }
  EXPECT_EQ(compared, 40);
}

TEST(VectorIrradiance, ChannelsHaveTheirOwn) {
  const Sh<double, 3> red = zonal_toward<3>(delta_zonal(3), {1, 0, 0}),
                      blue = zonal_toward<3>(delta_zonal(3), {0, 0, 1});
  const Sh<RgbD, 3> light = RgbD(2, 0, 0) * red + RgbD(0, 0, 5) * blue;
  const auto [r, g, b] = vector_irradiance(light);
  EXPECT_NEAR(length(r - Vec3{2, 0, 0}), 0, 1e-15);
  EXPECT_EQ(g, (Vec3{0, 0, 0}));
  EXPECT_NEAR(length(b - Vec3{0, 0, 5}), 0, 2e-15);
  const auto [fr, fg, fb] = vector_irradiance(cast<Rgb>(light));
  EXPECT_NEAR(length(fr - r) + length(fg - g) + length(fb - b), 0, 1e-6);  // rounded to float before
}

TEST(OptimalLinearDirection, FindsALightBesideTheAmbient) {
  std::mt19937 random(3);
  int compared = 0;
  for (const Vec3 toward : spiral_directions(30)) {
    Sh<double, 4> light = zonal_toward<4>(delta_zonal(4), toward);
    light(0, 0) += 7;
    const auto found = optimal_linear_direction(light);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(length(*found - toward), 0, 1e-15);
    ++compared;
  }
  EXPECT_EQ(compared, 30);
}

TEST(OptimalLinearDirection, GoesByLuminance) {
  const Sh<double, 2> x = zonal_toward<2>(delta_zonal(2), {1, 0, 0}), y = zonal_toward<2>(delta_zonal(2), {0, 1, 0});
  const auto found = optimal_linear_direction(RgbD(1, 0, 0) * x + RgbD(0, 1, 0) * y);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(length(*found - normalize({0.2126, 0.7152, 0})), 0, 1e-15);
}

TEST(OptimalLinearDirection, IsNoneWithoutALinearBand) {
  Sh<double, 3> sh;
  sh(0, 0) = 1;
  sh(2, 1) = 1;
  EXPECT_FALSE(optimal_linear_direction(sh).has_value());
  EXPECT_FALSE(optimal_linear_direction(RgbD(1, 1, 1) * sh).has_value());
  EXPECT_EQ(vector_irradiance(sh), (Vec3{0, 0, 0}));
  sh(1, 0) = 1e-200;  // its square vanishes
  EXPECT_NEAR(length(*optimal_linear_direction(sh) - Vec3{0, 0, 1}), 0, 1e-15);
  EXPECT_THROW(optimal_linear_direction(Sh<double>(1)), std::logic_error);
}

}  // namespace
}  // namespace zonal
