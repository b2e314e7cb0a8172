#include "zonal/sh/complex_basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "zonal/math/sphere_rule.h"

namespace zonal {
namespace {

using Complex = std::complex<double>;

TEST(ComplexBasis, HasThePublishedFirstFunctions) {
  int compared = 0;
  for (const Vec3 d : spiral_directions(20)) {
    std::vector<Complex> y(9);
    complex_basis(3, d, y);
    const Complex xy(d.x, d.y);
    const double k11 = std::sqrt(3 / (8 * kPi)), k21 = std::sqrt(15 / (8 * kPi)), k22 = std::sqrt(15 / (32 * kPi));
    const std::vector<Complex> expected = {std::sqrt(1 / (4 * kPi)),
                                           k11 * std::conj(xy),
                                           std::sqrt(3 / (4 * kPi)) * d.z,
                                           -k11 * xy,
                                           k22 * std::conj(xy * xy),
                                           k21 * d.z * std::conj(xy),
                                           std::sqrt(5 / (16 * kPi)) * (3 * d.z * d.z - 1),
                                           -k21 * d.z * xy,
                                           k22 * xy * xy};
    for (std::size_t i = 0; i < 9; ++i, ++compared) EXPECT_LT(std::abs(y[i] - expected[i]), 1e-15) << i;
  }
  EXPECT_EQ(compared, 180);
}

TEST(ComplexBasis, IsOrthonormalWithAConjugateOnly) {
  constexpr int kBands = 8, kCount = kBands * kBands;
  std::vector<Complex> gram(kCount * kCount), y(kCount);
  Complex without;
  for (const auto& [d, weight] : sphere_rule(kBands)) {
    complex_basis(kBands, d, y);
    for (int i = 0; i < kCount; ++i) {
      for (int j = 0; j < kCount; ++j) gram[i * kCount + j] += weight * y[i] * std::conj(y[j]);
    }
    without += weight * y[3] * y[1];
  }
  double worst = 0;
  for (int i = 0; i < kCount; ++i) {
    for (int j = 0; j < kCount; ++j) worst = std::max(worst, std::abs(gram[i * kCount + j] - (i == j ? 1.0 : 0.0)));
  }
  EXPECT_LT(worst, 2e-14);  // sums of 128 terms
  EXPECT_NEAR(without.real(), -1, 1e-14);
}

TEST(ComplexBasis, DescribesTheSameFunctionAndComesBack) {
  Sh<double> sh(9);
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = std::sin(1.1 * static_cast<double>(i) + 0.2);
  const Sh<Complex> complex = to_complex_basis(sh);
  int compared = 0;
  std::vector<Complex> y(sh.size());
  for (const Vec3 d : spiral_directions(20)) {
    complex_basis(9, d, y);
    Complex sum;
    for (std::size_t i = 0; i < y.size(); ++i) sum += complex[i] * y[i];
    EXPECT_LT(std::abs(sum - evaluate(sh, d)), 1e-13);  // 81 terms of size 1
    ++compared;
  }
  EXPECT_EQ(compared, 20);
  const Sh<double> back = from_complex_basis(complex);
  for (std::size_t i = 0; i < sh.size(); ++i) EXPECT_NEAR(back[i], sh[i], 1e-15);
  const Sh<double, 3> few = with_bands<3>(sh);
  EXPECT_EQ(from_complex_basis(to_complex_basis(few)).bands(), 3);
}

TEST(ComplexBasis, RefusesAFunctionThatIsNotReal) {
  Sh<Complex, 3> complex;
  complex(2, 1) = {1, 1};
  EXPECT_THROW(from_complex_basis(complex), Error);
  complex(2, -1) = {-1, 1};
  EXPECT_NEAR(from_complex_basis(complex)(2, 1), -std::sqrt(2.0), 1e-15);
  complex(1, 0) = {0, 1};
  EXPECT_THROW(from_complex_basis(complex), Error);
  complex(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(from_complex_basis(complex), Error);
}

}  // namespace
}  // namespace zonal
