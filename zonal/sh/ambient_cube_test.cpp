#include "zonal/sh/ambient_cube.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

Sh<double> some_function(int bands) {
  Sh<double> sh(bands);
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = std::sin(2.3 * static_cast<double>(i) + 0.4);
  return sh;
}

/// Gauss-Legendre in both angles of each octant, where the cube's function is smooth: to rounding for a few bands.
std::vector<WeightedDirection> octant_rule() {
  std::vector<WeightedDirection> rule;
  const Quadrature polar = gauss_legendre(20, 0, kPi / 2), azimuth = gauss_legendre(20, 0, kPi / 2);
  for (std::size_t i = 0; i < polar.size(); ++i) {
    for (std::size_t k = 0; k < azimuth.size(); ++k) {
      for (int octant = 0; octant < 8; ++octant) {
        const double z = (octant & 4 ? -1 : 1) * std::cos(polar.nodes[i]), r = std::sin(polar.nodes[i]);
        const double phi = azimuth.nodes[k] + kPi / 2 * (octant & 3);
        rule.push_back({{r * std::cos(phi), r * std::sin(phi), z}, r * polar.weights[i] * azimuth.weights[k]});
      }
    }
  }
  return rule;
}

double squared_distance(const AmbientCube<double>& cube, const Sh<double>& sh,
                        const std::vector<WeightedDirection>& rule) {
  double sum = 0;
  for (const auto& [d, weight] : rule) {
    const double difference = evaluate(cube, d) - evaluate(sh, d);
    sum += weight * difference * difference;
  }
  return sum;
}

TEST(AmbientCube, TakesTheValueOfASideOnItsAxis) {
  const AmbientCube<double> cube = {{1, 2, 3, 4, 5, 6}};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(evaluate(cube, kCubeAxes[i]), i + 1);
  EXPECT_NEAR(evaluate(cube, {0.6, -0.8, 0}), 0.36 * 1 + 0.64 * 4, 1e-15);
}

TEST(AmbientCube, FactorsVanishForEvenBandsFromFourOnOnly) {
  std::vector<double> factors(12);
  cube_side_factors(factors);
  EXPECT_NEAR(factors[0], 2 * kPi / 3, 1e-15);
  EXPECT_NEAR(factors[1], kPi / 2, 1e-15);
  EXPECT_NEAR(factors[2], 4 * kPi / 15, 1e-15);
  for (int l = 4; l < 12; l += 2) EXPECT_EQ(factors[l], 0);
  for (int l = 3; l < 12; l += 2) EXPECT_GT(std::abs(factors[l]), 1e-3);
  const Quadrature gauss = gauss_legendre(10, 0, 1);
  std::vector<double> sums(12, 0.0), p(12);
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    legendre(gauss.nodes[i], p);
    for (int l = 0; l < 12; ++l) sums[l] += 2 * kPi * gauss.weights[i] * gauss.nodes[i] * gauss.nodes[i] * p[l];
  }
  for (int l = 0; l < 12; ++l) EXPECT_NEAR(factors[l], sums[l], 2e-15) << l;
}

TEST(AmbientCube, IsTheNearestOfAllCubes) {
  const std::vector<WeightedDirection> rule = octant_rule();
  int compared = 0;
  for (const int bands : {1, 2, 3, 4, 6}) {
    const Sh<double> sh = some_function(bands);
    const AmbientCube<double> cube = ambient_cube(sh);
    const double least = squared_distance(cube, sh, rule);
    for (int side = 0; side < 6; ++side) {
      AmbientCube<double> up = cube, down = cube;
      up.sides[side] += 1e-3;
      down.sides[side] -= 1e-3;
      const double above = squared_distance(up, sh, rule), below = squared_distance(down, sh, rule);
      EXPECT_NEAR(above - below, 0, 1e-12);  // the slope is zero
      EXPECT_NEAR((above + below) / 2 - least, 1e-6 * 2 * kPi / 5, 1e-12);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 30);
}

TEST(AmbientCube, CoefficientsAreTheIntegrals) {
  const AmbientCube<double> cube = {{1, -2, 3, 0.5, 2, -1}};
  constexpr int kBands = 6;
  const Sh<double> sh = sh_from_ambient_cube(cube, kBands);
  std::vector<double> sums(36, 0.0), y(36);
  for (const auto& [d, weight] : octant_rule()) {
    basis(kBands, d, std::span(y));
    for (int i = 0; i < 36; ++i) sums[i] += weight * evaluate(cube, d) * y[i];
  }
  for (int i = 0; i < 36; ++i) EXPECT_NEAR(sh[i], sums[i], 1e-13) << i;
}

TEST(AmbientCube, ThereAndBackKeepsWhatItCan) {
  const Sh<double, 3> sh = with_bands<3>(some_function(3));
  // A few roundings of sums of ten terms of size 1.
  const Sh<double, 3> back = sh_from_ambient_cube<3>(ambient_cube(sh));
  for (const int i : {0, 6, 8}) EXPECT_NEAR(back[i], sh[i], 5e-15) << i;
  for (const int i : {1, 2, 3}) EXPECT_NEAR(back[i], sh[i] * 15 / 16, 5e-15) << i;
  for (const int i : {4, 5, 7}) EXPECT_NEAR(back[i], 0, 5e-15) << i;
}

TEST(AmbientCube, ConvolvedLightingReachesItInThreeBandsRawDoesNot) {
  const Sh<double> radiance = some_function(8), matte = irradiance_over_pi(radiance);
  const AmbientCube<double> all = ambient_cube(matte), three = ambient_cube(with_bands(matte, 3));
  double raw_difference = 0;
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(all.sides[i], three.sides[i], 1e-14);
    raw_difference = std::max(
        raw_difference, std::abs(ambient_cube(radiance).sides[i] - ambient_cube(with_bands(radiance, 3)).sides[i]));
  }
  EXPECT_GT(raw_difference, 0.01);
}

TEST(AmbientCube, TakesColours) {
  const Sh<double, 4> sh = with_bands<4>(some_function(4));
  const AmbientCube<Rgb> cube = ambient_cube(cast<Rgb>(RgbD(1, 2, -1) * sh));
  const AmbientCube<double> scalar = ambient_cube(sh);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(cube.sides[i].r, scalar.sides[i], 1e-6);
    EXPECT_NEAR(cube.sides[i].b, -scalar.sides[i], 1e-6);
  }
  EXPECT_EQ(sh_from_ambient_cube<3>(cube).bands(), 3);
  EXPECT_EQ(ambient_cube(Sh<Rgb, 3>()), AmbientCube<Rgb>());
}

}  // namespace
}  // namespace zonal
