#include "zonal/math/legendre.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"

namespace zonal {
namespace {

std::vector<double> legendre_values(int n, double x) {
  std::vector<double> p(n);
  legendre(x, p);
  return p;
}

TEST(Legendre, AgreesWithTheStandardLibrary) {
  int compared = 0;
  for (const double x : {-1.0, -0.999, -0.5, -0.3, 0.0, 0.2, 0.5, 0.77, 0.9999, 1.0}) {
    const std::vector<double> p = legendre_values(150, x);
    for (unsigned l = 0; l < 150; ++l, ++compared) {
      // Theirs in extended precision; ours rounds once a step, 150 times at most.
      EXPECT_NEAR(p[l], static_cast<double>(std::legendre(l, static_cast<long double>(x))), 1e-14) << l << " " << x;
    }
  }
  EXPECT_EQ(compared, 1500);
}

TEST(Legendre, KeepsTheDigitsOfAnAngleNearZero) {
  // P_l(1 - v) = sum_k (-l)_k (l+1)_k/(k!)^2 (v/2)^k (Murphy 1833). Rounding 1 - v would change P_3000 by l^2 eps/4 =
  // 5e-10.
  constexpr int kDegree = 3000;
  const double versine = 3.3e-8;
  double series = 0, term = 1;
  for (int k = 0; k < 40; ++k) {
    series += term;
    term *= (k - kDegree) * (kDegree + 1.0 + k) / ((k + 1.0) * (k + 1.0)) * (versine / 2);
  }
  std::vector<double> p(kDegree + 1);
  legendre_from_versine(versine, p);
  EXPECT_NEAR(p[kDegree], series, 1e-13);
  legendre_from_versine(2, p);
  EXPECT_EQ(p[kDegree], 1);
  EXPECT_EQ(p[kDegree - 1], -1);
}

TEST(Legendre, IsOrthogonal) {
  constexpr int kDegrees = 60;
  const Quadrature gauss = gauss_legendre(64);
  std::vector<double> gram(kDegrees * kDegrees, 0.0);
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    const std::vector<double> p = legendre_values(kDegrees, gauss.nodes[i]);
    for (int l = 0; l < kDegrees; ++l) {
      for (int k = 0; k < kDegrees; ++k) gram[l * kDegrees + k] += gauss.weights[i] * p[l] * p[k];
    }
  }
  double worst = 0;
  for (int l = 0; l < kDegrees; ++l) {
    for (int k = 0; k < kDegrees; ++k) {
      worst = std::max(worst, std::abs(gram[l * kDegrees + k] - (l == k ? 2.0 / (2 * l + 1) : 0)));
    }
  }
  EXPECT_LT(worst, 1e-14);  // the sum of 64 rounded terms of size 1/64
}

TEST(Legendre, DerivativesObeyTheDifferentialRelation) {
  int compared = 0;
  for (const double x : {-1.0, -0.7, 0.0, 0.4, 0.95, 1.0}) {
    const std::vector<double> p = legendre_values(80, x);
    std::vector<double> d(80);
    legendre_derivatives(p, d);
    for (int l = 1; l < 80; ++l, ++compared) {
      EXPECT_NEAR((1 - x * x) * d[l], l * (p[l - 1] - x * p[l]), 1e-12)
          << l << " " << x;  // l roundings of values up to l
    }
    if (x == 1) {
      EXPECT_EQ(d[79], 79 * 80 / 2);
    }
  }
  EXPECT_EQ(compared, 6 * 79);
}

TEST(AssociatedLegendre, AgreesWithTheStandardLibrary) {
  int compared = 0;
  for (const double theta : {0.0, 0.1, 0.8, kPi / 2, 2.0, 3.1}) {
    for (int m = 0; m < 40; ++m) {
      std::vector<double> values(40 - m);
      associated_legendre(m, std::cos(theta), std::sin(theta), values);
      for (int l = m; l < 40; ++l, ++compared) {
        // The library's carries the Condon-Shortley sign and no sqrt(2).
        const double expected = std::sph_legendre(l, m, theta) * (m % 2 ? -1 : 1) * (m > 0 ? std::numbers::sqrt2 : 1);
        EXPECT_NEAR(values[l - m], expected, 1e-12) << l << " " << m << " " << theta;
      }
    }
  }
  EXPECT_EQ(compared, 6 * 820);
}

TEST(AssociatedLegendre, AdditionTheoremHoldsForAThousandBands) {
  constexpr int kBands = 1000;
  for (const double theta : {1e-3, 0.05, 0.7, 1.5, 3.0}) {
    std::vector<double> sums(kBands, 0.0), values(kBands);
    for (int m = 0; m < kBands; ++m) {
      const std::span<double> column = std::span(values).first(kBands - m);
      associated_legendre(m, std::cos(theta), std::sin(theta), column);
      for (int l = m; l < kBands; ++l) sums[l] += column[l - m] * column[l - m];
    }
    double worst = 0;
    // sum_m y_{l,m}^2 = (2l+1)/4pi; cos^2 + sin^2 = 1 joins m and -m.
    for (int l = 0; l < kBands; ++l) worst = std::max(worst, std::abs(sums[l] * 4 * kPi / (2 * l + 1) - 1));
    EXPECT_LT(worst, 5e-11) << theta;  // relative error grows with the number of steps: 1000 of them, each a few eps
  }
}

}  // namespace
}  // namespace zonal
