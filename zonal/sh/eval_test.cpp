#include "zonal/sh/eval.h"

#include <gtest/gtest.h>

#include "zonal/math/sphere_rule.h"

namespace zonal {
namespace {

const std::vector<Vec3> kAxes = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

std::vector<Vec3> test_directions() {
  std::vector<Vec3> directions = spiral_directions(100);
  directions.insert(directions.end(), kAxes.begin(), kAxes.end());
  return directions;
}

/// The unrolled evaluator against the recurrence for any number of bands; returns how many values were compared.
template <int N, class T>
int compare_evaluators() {
  int compared = 0;
  for (const Vec3 d : test_directions()) {
    std::array<T, coefficient_count(N)> y;
    basis_unrolled<N, T>(static_cast<T>(d.x), static_cast<T>(d.y), static_cast<T>(d.z), y.data());
    visit_basis(N, d, [&](int i, double value) {
      // Values reach 1.5; each of at most 2N steps rounds once.
      EXPECT_NEAR(y[i], value, 4 * N * std::numeric_limits<T>::epsilon()) << N << " " << i;
      ++compared;
    });
  }
  return compared;
}

TEST(Basis, UnrolledAndRecurrenceAgree) {
  int compared = 0;
  [&]<int... n>(std::integer_sequence<int, n...>) {
    ((compared += compare_evaluators<n + 1, double>() + compare_evaluators<n + 1, float>()), ...);
  }
  (std::make_integer_sequence<int, 8>());
  EXPECT_EQ(compared, 2 * 106 * (1 + 4 + 9 + 16 + 25 + 36 + 49 + 64));
}

TEST(Basis, IsThePolynomialsOfTheFirstBandsWithoutCondonShortley) {
  for (const Vec3 d : test_directions()) {
    const auto [x, y, z] = d;
    const double k1 = std::sqrt(3 / (4 * kPi)), k2 = std::sqrt(15 / (4 * kPi)), k20 = std::sqrt(5 / (16 * kPi));
    const std::vector<double> expected = {
        std::sqrt(1 / (4 * kPi)), k1 * y, k1 * z, k1 * x, k2 * x * y, k2 * y * z, k20 * (3 * z * z - 1), k2 * x * z,
        k2 / 2 * (x * x - y * y)};
    std::vector<double> actual(9);
    basis(3, d, std::span(actual));
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-15) << i;
  }
}

TEST(Basis, IsOrthonormal) {
  for (const int bands : {6, 12}) {
    const int count = coefficient_count(bands);
    std::vector<double> gram(count * count, 0.0), y(count);
    for (const auto& [direction, weight] : sphere_rule(bands)) {
      basis(bands, direction, std::span(y));
      for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) gram[i * count + j] += weight * y[i] * y[j];
      }
    }
    double worst = 0;
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) worst = std::max(worst, std::abs(gram[i * count + j] - (i == j)));
    }
    EXPECT_LT(worst, 2e-14) << bands;  // the sum of 2 bands^2 rounded terms
  }
}

TEST(Basis, AdditionTheoremHoldsForFiveHundredBands) {
  constexpr int kBands = 500;
  for (const Vec3 d : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, normalize({0.3, -0.5, 0.2}), normalize({1e-3, 1e-4, -1})}) {
    std::vector<double> sums(kBands, 0.0);
    int visited = 0;
    visit_basis(kBands, d, [&](int i, double value) {
      sums[static_cast<int>(std::sqrt(i))] += value * value;
      ++visited;
    });
    EXPECT_EQ(visited, kBands * kBands);
    double worst = 0;
    for (int l = 0; l < kBands; ++l) worst = std::max(worst, std::abs(sums[l] * 4 * kPi / (2 * l + 1) - 1));
    EXPECT_LT(worst, 1e-10);  // a rounded z turns the last direction by eps/(2 sin) = 1e-13, times 500 bands
  }
}

TEST(Evaluate, SumsTheBasis) {
  const int bands = 9;
  Sh<RgbD> sh(bands);
  for (int i = 0; i < coefficient_count(bands); ++i) sh[i] = {std::cos(1.0 * i), std::sin(2.0 * i), 1.0 / (1 + i)};
  std::vector<double> y(sh.size());
  for (const Vec3 d : test_directions()) {
    basis(bands, d, std::span(y));
    RgbD sum;
    for (std::size_t i = 0; i < y.size(); ++i) sum += y[i] * sh[i];
    const RgbD value = evaluate(sh, d);
    EXPECT_NEAR(value.r, sum.r, 1e-13);
    EXPECT_NEAR(value.g, sum.g, 1e-13);
    EXPECT_NEAR(value.b, sum.b, 1e-13);
    // The same function through the static container in float.
    const Rgb low = evaluate(cast<Rgb>(with_bands<4>(sh)), d);
    const RgbD exact = evaluate(with_bands(sh, 4), d);
    EXPECT_NEAR(low.r, exact.r, 1e-5);  // 16 float products of size 1
    EXPECT_NEAR(low.b, exact.b, 1e-5);
  }
}

TEST(Evaluate, RecoversAConstantAndALinearFunction) {
  Sh<double, 2> sh;
  sh(0, 0) = 2 * std::sqrt(kPi);  // f = 1
  sh(1, 1) = std::sqrt(4 * kPi / 3);
  sh(1, -1) = 0.5 * std::sqrt(4 * kPi / 3);
  for (const Vec3 d : test_directions()) EXPECT_NEAR(evaluate(sh, d), 1 + d.x + d.y / 2, 1e-15 * 8);
}

}  // namespace
}  // namespace zonal
