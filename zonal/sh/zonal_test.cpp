#include "zonal/sh/zonal.h"

#include <gtest/gtest.h>

#include <random>

#include "zonal/math/sphere_rule.h"

namespace zonal {
namespace {

/// A kernel with all bands, none zero.
double kernel(double c) { return std::exp(3 * (c - 1)) * (1 + 0.3 * c); }

std::vector<double> kernel_factors(int bands) {
  const Quadrature gauss = gauss_legendre(40);
  std::vector<double> factors(bands, 0.0), p(bands);
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    legendre(gauss.nodes[i], p);
    for (int l = 0; l < bands; ++l) factors[l] += 2 * kPi * gauss.weights[i] * kernel(gauss.nodes[i]) * p[l];
  }
  return factors;
}

Sh<double> random_sh(int bands) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Sh<double> sh(bands);
  for (double& value : sh.values()) value = normal(random);
  return sh;
}

TEST(Zonal, FactorsAndCoefficientsAreInverse) {
  const std::vector<double> factors = kernel_factors(12), back = factors_from_zonal(zonal_from_factors(factors));
  for (int l = 0; l < 12; ++l) EXPECT_NEAR(back[l], factors[l], 1e-15);
  EXPECT_NEAR(zonal_from_factors(factors)[2], factors[2] * std::sqrt(5 / (4 * kPi)), 1e-15);
}

TEST(Zonal, ConvolutionIsTheIntegralOverTheSphere) {
  constexpr int kBands = 8;
  const Sh<double> sh = random_sh(kBands), blurred = convolve(sh, kernel_factors(kBands));
  const std::vector<WeightedDirection> rule = sphere_rule(30);  // the kernel's bands above 50 are below 1e-15
  int compared = 0;
  for (const Vec3 n : spiral_directions(10)) {
    double integral = 0;
    for (const auto& [direction, weight] : rule)
      integral += weight * kernel(dot(direction, n)) * evaluate(sh, direction);
    EXPECT_NEAR(evaluate(blurred, n), integral, 1e-12);
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

TEST(Zonal, TurnsToADirection) {
  const std::vector<double> zonal = zonal_from_factors(kernel_factors(45));
  const Vec3 axis = normalize({0.3, -0.8, 0.4});
  const Sh<double> turned = zonal_toward(zonal, axis);
  EXPECT_EQ(turned.bands(), 45);
  for (const Vec3 d : spiral_directions(20)) {
    const double c = dot(d, axis);
    EXPECT_NEAR(evaluate(turned, d), kernel(c), 1e-13);
    EXPECT_NEAR(evaluate_zonal(zonal, c), kernel(c), 1e-13);
  }
  const Sh<double, 3> three = zonal_toward<3>(std::span(zonal).first(3), axis);
  EXPECT_NEAR(three(2, -1), turned(2, -1), 1e-15);
  const Sh<double> up = zonal_toward(zonal, {0, 0, 1});
  EXPECT_NEAR(up(5, 0), zonal[5], 1e-15);
  EXPECT_EQ(up(5, 3), 0);
}

TEST(Zonal, NeedsAFactorForEachBand) { EXPECT_THROW(convolve(random_sh(5), kernel_factors(4)), std::logic_error); }

}  // namespace
}  // namespace zonal
