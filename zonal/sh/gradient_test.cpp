#include "zonal/sh/gradient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

#include "zonal/math/sphere_rule.h"
#include "zonal/math/turn.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

std::vector<Vec3> test_directions() {
  std::vector<Vec3> directions = spiral_directions(50);
  directions.insert(directions.end(), {{0, 0, 1},
                                       {0, 0, -1},
                                       {1, 0, 0},
                                       {0, -1, 0},
                                       normalize({1e-9, -2e-9, 1}),
                                       normalize({1e-200, 0, -1}),
                                       normalize({-1e-3, 1e-5, -1})});
  return directions;
}

/// The derivative along t by a step into the complex plane: of the polynomials in x, y, z, so nothing is subtracted.
template <int N>
double complex_step(const Sh<double, N>& sh, Vec3 d, Vec3 t) {
  using Complex = std::complex<double>;
  constexpr double kStep = 1e-50;
  std::array<Complex, coefficient_count(N)> y;
  basis_unrolled<N, Complex>(Complex(d.x, kStep * t.x), Complex(d.y, kStep * t.y), Complex(d.z, kStep * t.z), y.data());
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) sum += sh[i] * y[i].imag() / kStep;
  return sum;
}

template <int N>
int compare_with_complex_step() {
  Sh<double, N> sh;
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = std::cos(2.3 * static_cast<double>(i));
  int compared = 0;
  for (const Vec3 d : test_directions()) {
    const auto [value, slope] = evaluate_with_gradient(sh, d);
    EXPECT_NEAR(value, evaluate(sh, d), 1e-15 * 8 * N * N);
    EXPECT_NEAR(dot(slope, d), 0, 1e-15 * N * N * N);
    const Rotation frame = turn_z_to(d);
    for (const Vec3 t : {frame * Vec3{1, 0, 0}, frame * Vec3{0, 1, 0}}) {
      EXPECT_NEAR(dot(slope, t), complex_step(sh, d, t), 1e-15 * N * N * N) << N;  // N^2 terms of size N
      ++compared;
    }
    const Sh<double> any = with_bands(sh, N);
    EXPECT_EQ(gradient(any, d), slope);
  }
  return compared;
}

TEST(Gradient, AgreesWithAComplexStep) {
  const int compared = compare_with_complex_step<1>() + compare_with_complex_step<2>() +
                       compare_with_complex_step<3>() + compare_with_complex_step<6>() +
                       compare_with_complex_step<10>();
  EXPECT_EQ(compared, 5 * 57 * 2);
}

TEST(Gradient, SumsOfSquaresKnowNoDirectionForTwoHundredBands) {
  // The sum over m of |grad y_lm|^2 is l(l+1)(2l+1)/4pi everywhere: the addition theorem, twice derived.
  constexpr int kBands = 201;
  int compared = 0;
  for (const Vec3 d : {Vec3{0, 0, 1}, normalize({0.3, -0.5, 0.2}), normalize({1e-4, 1e-3, -1})}) {
    for (const int l : {1, 7, 50, 200}) {
      double sum = 0;
      for (int m = -l; m <= l; ++m) {
        Sh<double> sh(l == 200 ? kBands : l + 1);
        sh(l, m) = 1;
        const Vec3 slope = gradient(sh, d);
        sum += dot(slope, slope);
      }
      EXPECT_NEAR(sum / (l * (l + 1.0) * (2 * l + 1.0)) * 4 * kPi, 1, 1e-11) << l;  // a rounded z, 200 bands
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12);
}

TEST(Gradient, StaysANumberForManyBands) {
  Sh<double> sh(1200);
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = std::cos(2.3 * static_cast<double>(i));
  for (const Vec3 d : {Vec3{0, 0, 1}, normalize({1e-200, 1e-200, 1}), normalize({1e-3, 1e-4, -1}), Vec3{1, 0, 0}}) {
    const auto [value, slope] = evaluate_with_gradient(sh, d);
    const double expected = evaluate(sh, d);
    EXPECT_NEAR(value, expected, 1e-9 * (1 + std::abs(expected)));
    EXPECT_TRUE(std::isfinite(length(slope)));
  }
}

TEST(Gradient, RefusesBadInput) {
  const Sh<float, 3> sh;
  EXPECT_THROW(gradient(sh, {0, 0, 0}), std::logic_error);
  EXPECT_THROW(gradient(sh, {std::numeric_limits<double>::quiet_NaN(), 0, 1}), std::logic_error);
  EXPECT_THROW(gradient(Sh<double>(), {0, 0, 1}), std::logic_error);
}

}  // namespace
}  // namespace zonal
