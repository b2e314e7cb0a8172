#include "zonal/sh/irradiance.h"

#include <gtest/gtest.h>

#include "zonal/math/sphere_rule.h"

namespace zonal {
namespace {

TEST(Irradiance, FactorsAreTheIntegralsOfTheClampedCosine) {
  constexpr int kBands = 200;
  const std::vector<double> factors = cosine_factors(kBands);
  const Quadrature gauss = gauss_legendre(kBands / 2 + 2, 0, 1);
  std::vector<double> sums(kBands, 0.0), p(kBands);
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    legendre(gauss.nodes[i], p);
    for (int l = 0; l < kBands; ++l) sums[l] += 2 * gauss.weights[i] * gauss.nodes[i] * p[l];
  }
  for (int l = 0; l < kBands; ++l) EXPECT_NEAR(factors[l], sums[l], 5e-15) << l;
  EXPECT_EQ(factors[2], 0.25);
  EXPECT_EQ(factors[6], 1.0 / 64);
}

TEST(Irradiance, OfAConstantIsPi) {
  Sh<Rgb, 3> radiance;
  radiance(0, 0) = {static_cast<float>(2 * std::sqrt(kPi)), 0, 0};
  EXPECT_FLOAT_EQ(evaluate(irradiance(radiance), {0, 0, 1}).r, static_cast<float>(kPi));
  EXPECT_FLOAT_EQ(evaluate(irradiance_over_pi(radiance), {0.6, 0, 0.8}).r, 1);
}

TEST(Irradiance, IsTheIntegralOverTheHemisphere) {
  constexpr int kBands = 7;
  Sh<double> radiance(kBands);
  for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] = std::sin(3.0 * static_cast<double>(i) + 1);
  const Sh<double> e = irradiance(radiance);
  const Quadrature gauss = gauss_legendre(8, 0, 1);  // n.l times a polynomial of degree 6 over the hemisphere: exact
  int compared = 0;
  for (const Vec3 n : spiral_directions(12)) {
    const Vec3 t = normalize(cross(n, {0.1, 0.9, 0.2})), b = cross(n, t);
    double integral = 0;
    for (std::size_t i = 0; i < gauss.size(); ++i) {
      const double c = gauss.nodes[i], s = std::sqrt(1 - c * c);
      for (int k = 0; k < 16; ++k) {
        const double phi = 2 * kPi * k / 16;
        const Vec3 l = c * n + s * std::cos(phi) * t + s * std::sin(phi) * b;
        integral += gauss.weights[i] * 2 * kPi / 16 * c * evaluate(radiance, l);
      }
    }
    EXPECT_NEAR(evaluate(e, n), integral, 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

}  // namespace
}  // namespace zonal
