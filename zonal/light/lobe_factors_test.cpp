#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/base/error.h"
#include "zonal/light/lobe.h"
#include "zonal/math/legendre.h"
#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

/// Edges of panels over the angle from n: they start at `sharpest` and double, none is longer than a few waves of the
/// highest band, and they shrink again towards the horizon, where kernels end like any power, and stop at a cone's rim.
std::vector<double> panel_edges(const Lobe& lobe, int bands, double sharpest) {
  const double longest = std::min(0.25, 20.0 / bands);
  std::vector<double> stops = {kPi / 2, kPi};
  for (double gap = 0.2; gap > 1e-12; gap /= 4) stops.push_back(kPi / 2 - gap);
  if (lobe.kind() == LobeKind::kCone) stops.push_back(lobe.parameter());
  std::ranges::sort(stops);
  std::vector<double> edges = {0};
  double length = std::min(sharpest, longest);
  for (const double stop : stops) {
    while (edges.back() + length < stop) {
      edges.push_back(edges.back() + length);
      length = std::min(2 * length, longest);
    }
    edges.push_back(stop);
  }
  return edges;
}

/// The band factors by quadrature: a path that shares nothing with the recurrences.
std::vector<double> factors_by_quadrature(const Lobe& lobe, int bands, double sharpest) {
  const Quadrature rule = gauss_legendre_panels(30, panel_edges(lobe, bands, sharpest));
  std::vector<double> factors(bands, 0.0), p(bands);
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const double theta = rule.nodes[i], versine = 2 * std::pow(std::sin(theta / 2), 2);
    const double weight = 2 * kPi * rule.weights[i] * std::sin(theta) * lobe.kernel_from_versine(versine);
    if (weight == 0) continue;
    legendre_from_versine(versine, p);
    for (int l = 0; l < bands; ++l) factors[l] += weight * p[l];
  }
  return factors;
}

/// Returns how many factors were compared.
int expect_quadrature(const Lobe& lobe, int bands, double sharpest) {
  const std::vector<double> factors = band_factors(lobe, bands),
                            expected = factors_by_quadrature(lobe, bands, sharpest);
  double worst = 0;
  for (int l = 0; l < bands; ++l) worst = std::max(worst, std::abs(factors[l] - expected[l]));
  // The quadrature's own error: it sums thousands of rounded terms, whose absolute values sum to 1.
  EXPECT_LT(worst, 2e-13) << name_of(lobe.kind()) << " " << lobe.parameter();
  EXPECT_NEAR(factors[0], 1, 1e-15);
  return static_cast<int>(factors.size());
}

TEST(LobeFactors, CosineAndPhongMatchQuadrature) {
  int compared = expect_quadrature(Lobe::cosine(), 400, 0.1);
  for (const double s : {0.0, 0.5, 1.0, 2.0, 3.7, 10.0, 100.0, 1e4}) {
    compared += expect_quadrature(Lobe::phong(s), 400, 0.2 / std::sqrt(1 + s));
  }
  EXPECT_EQ(compared, 9 * 400);
}

TEST(LobeFactors, BlinnPhongMatchesQuadrature) {
  int compared = 0;
  for (const double s : {0.0, 0.5, 1.0, 7.0, 40.0, 1e3, 1e5}) {
    compared += expect_quadrature(Lobe::blinn_phong(s), 600, 0.2 / std::sqrt(1 + s));
  }
  EXPECT_EQ(compared, 7 * 600);
}

TEST(LobeFactors, GgxMatchesQuadrature) {
  int compared = 0;
  for (const double alpha : {1e-4, 1e-3, 0.01, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999999, 1.0}) {
    compared += expect_quadrature(Lobe::ggx(alpha), 1200, alpha / 4);
  }
  EXPECT_EQ(compared, 12 * 1200);
}

TEST(LobeFactors, CharlieMatchesQuadrature) {
  int compared = 0;
  // Towards n the kernel falls like theta^(1/alpha): the panels shrink there.
  for (const double alpha : {1e-4, 1e-3, 0.01, 0.1, 0.25, 0.3, 0.5, 0.8, 1.0}) {
    compared += expect_quadrature(Lobe::charlie(alpha), 500, 1e-6);
  }
  EXPECT_EQ(compared, 9 * 500);
}

TEST(LobeFactors, ConeAndGaussianMatchQuadrature) {
  int compared = 0;
  for (const double angle : {1e-6, 0.0047, 0.3, kPi / 2, 2.5, kPi}) {
    compared += expect_quadrature(Lobe::cone(angle), 800, angle / 4);
  }
  for (const double width : {1e-5, 0.001, 0.01, 0.3, 2.0, 100.0}) {
    compared += expect_quadrature(Lobe::gaussian(width), 800, std::min(width, 1.0) / 2);
  }
  EXPECT_EQ(compared, 12 * 800);
}

TEST(LobeFactors, AreBoundedByOneAndDoNotDependOnHowManyAreAsked) {
  for (const Lobe& lobe : {Lobe::phong(33.3), Lobe::blinn_phong(200), Lobe::ggx(0.01), Lobe::ggx(0.6),
                           Lobe::charlie(0.1), Lobe::cone(1), Lobe::gaussian(0.1)}) {
    const std::vector<double> many = band_factors(lobe, 3000), few = band_factors(lobe, 50);
    for (int l = 0; l < 3000; ++l) EXPECT_LE(std::abs(many[l]), 1) << name_of(lobe.kind()) << " " << l;
    for (int l = 0; l < 50; ++l) EXPECT_NEAR(many[l], few[l], 1e-14) << name_of(lobe.kind()) << " " << l;
    EXPECT_EQ(band_factors(lobe, 1), std::vector<double>{1});
  }
}

TEST(LobeFactors, SharpGgxFollowsItsBesselLimit) {
  // lambda_l ~ x K_1(x), x = 2 alpha sqrt(l(l+1)); the limit's own error comes from the logarithm in the kernel's
  // integral.
  const double alpha = 1e-4, limit_error = -2 * alpha * alpha * std::log(2 * alpha * alpha);
  const std::vector<double> factors = band_factors(Lobe::ggx(alpha), 60000);
  int compared = 0;
  for (int l = 1; l < 60000; l += 777, ++compared) {
    const double x = 2 * alpha * std::sqrt(l * (l + 1.0));
    EXPECT_NEAR(factors[l], x * std::cyl_bessel_k(1.0, x), limit_error) << l;
  }
  EXPECT_EQ(compared, 78);
}

TEST(BandsFor, IsTheFirstBandOfTheTail) {
  int checked = 0;
  for (const Lobe& lobe : {Lobe::cosine(), Lobe::phong(5), Lobe::blinn_phong(20), Lobe::ggx(0.02), Lobe::ggx(0.5),
                           Lobe::charlie(0.3), Lobe::cone(0.2), Lobe::gaussian(0.05)}) {
    for (const double tolerance : {0.5, 1e-2, 1e-4}) {
      const int bands = bands_for(lobe, tolerance);
      const std::vector<double> factors = band_factors(lobe, 8 * bands + 8);
      EXPECT_GE(std::abs(factors[bands - 1]), tolerance);
      double tail = 0;
      for (std::size_t l = bands; l < factors.size(); ++l) tail = std::max(tail, std::abs(factors[l]));
      EXPECT_LT(tail, tolerance) << name_of(lobe.kind());
      ++checked;
    }
  }
  EXPECT_EQ(checked, 24);
  EXPECT_EQ(bands_for(Lobe::ggx(0.1), 1e-3), 41);
  EXPECT_EQ(bands_for(Lobe::cosine(), 1e-2), 7);
}

TEST(BandsFor, GivesUpOnWhatNoTransformCouldDo) { EXPECT_THROW(bands_for(Lobe::cone(1e-6), 1e-9), Error); }

}  // namespace
}  // namespace zonal
