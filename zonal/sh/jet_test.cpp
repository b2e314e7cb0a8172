#include "zonal/sh/jet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

Sh<double> random_function(int bands, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Sh<double> sh(bands);
  for (double& value : sh.values()) value = normal(random);
  return sh;
}

/// Ahead along the great circle from d with the unit tangent t.
Vec3 along(Vec3 d, Vec3 t, double angle) { return std::cos(angle) * d + std::sin(angle) * t; }

TEST(Jet, IsTheValueAndItsDifferences) {
  std::mt19937 random(1);
  int compared = 0;
  for (const int bands : {1, 2, 3, 6, 12}) {
    const Sh<double> sh = random_function(bands, random);
    const JetEvaluator jet_at(sh);
    std::vector<Vec3> directions = spiral_directions(20);
    directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}});
    for (const Vec3 d : directions) {
      const Jet jet = jet_at(d);
      EXPECT_NEAR(jet.value, evaluate(sh, d), 1e-13 * bands);
      EXPECT_NEAR(dot(jet.gradient, d), 0, 1e-13 * bands * bands);
      const Vec3 t = normalize(cross(d, {0.3, 0.5, -0.7}));
      // Five points: the error is the sixth derivative, bands^6 at most, times h^4/30 or h^4/90; and rounding over h^2.
      const double h = 0.02 / bands;
      const auto f = [&](double steps) { return evaluate(sh, along(d, t, steps * h)); };
      const double slope = (8 * (f(1) - f(-1)) - (f(2) - f(-2))) / (12 * h);
      const double bend = (16 * (f(1) + f(-1)) - (f(2) + f(-2)) - 30 * f(0)) / (12 * h * h);
      EXPECT_NEAR(dot(jet.gradient, t), slope, 1e-7 * bands * bands);
      const auto& [x, y, z] = jet.hessian_rows;
      EXPECT_NEAR(dot(t, {dot(x, t), dot(y, t), dot(z, t)}), bend, 1e-6 * bands * bands * bands);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 5 * 24);
}

TEST(Jet, IsTheSameAmongManyEmptyBands) {
  // More than 300 bands are scaled; what is in the first ones must not notice.
  std::mt19937 random(3);
  const Sh<double> few = random_function(40, random), many = with_bands(few, 700);
  const JetEvaluator jet_at(few), same_at(many);
  std::vector<Vec3> directions = spiral_directions(20);
  directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, normalize({1e-4, -2e-5, 1}), normalize({1e-9, 0, -1})});
  int compared = 0;
  for (const Vec3 d : directions) {
    const Jet jet = jet_at(d), same = same_at(d);
    // Rounding of 1600 terms, 40 times larger with each derivative.
    EXPECT_NEAR(same.value, jet.value, 1e-12);
    EXPECT_NEAR(length(same.gradient - jet.gradient), 0, 4e-11);
    for (std::size_t row = 0; row < 3; ++row) {
      EXPECT_NEAR(length(same.hessian_rows[row] - jet.hessian_rows[row]), 0, 1.6e-9);
    }
    ++compared;
  }
  EXPECT_EQ(compared, 24);
}

TEST(Jet, BoundsHold) {
  std::mt19937 random(2);
  for (int bands = 2; bands <= 8; ++bands) {
    const Sh<double> sh = random_function(bands, random);
    const JetEvaluator jet_at(sh);
    const double mean = sh[0] / std::sqrt(4 * kPi), h = 1e-4;
    std::array<double, 4> largest = {};
    for (const Vec3 d : spiral_directions(500)) {
      const Jet jet = jet_at(d);
      const Vec3 t = normalize(cross(d, {0.3, 0.5, -0.7}));
      const auto bend = [&](double angle) {
        const Vec3 there = along(d, t, angle), ahead = along(d, t, angle + kPi / 2);
        const auto [x, y, z] = jet_at(there).hessian_rows;
        return dot(ahead, {dot(x, ahead), dot(y, ahead), dot(z, ahead)});
      };
      const std::array sizes = {jet.value - mean, dot(jet.gradient, t), bend(0), (bend(h) - bend(-h)) / (2 * h)};
      for (int order = 0; order < 4; ++order) largest[order] = std::max(largest[order], std::abs(sizes[order]));
    }
    for (int order = 0; order < 4; ++order) {
      EXPECT_LE(largest[order], derivative_bound(sh, order)) << bands << " " << order;
      EXPECT_GT(largest[order], 0.1 * derivative_bound(sh, order)) << bands << " " << order;
    }
  }
}

TEST(Jet, BoundsAreAttainedInEachBand) {
  // The function of one band and unit norm with the largest derivative at +Z along x is the derivative's representer:
  // its coefficients are those derivatives of the basis, here from differences of high order.
  int compared = 0;
  for (int l = 1; l < 7; ++l) {
    const double h = 0.02;
    const auto y_at = [&](int k) {
      Sh<double> y(l + 1);
      basis(l + 1, {std::sin(k * h), 0, std::cos(k * h)}, y.values());
      return y;
    };
    const Sh<double> first = (1 / (12 * h)) * (8 * (y_at(1) - y_at(-1)) - (y_at(2) - y_at(-2)));
    const Sh<double> second = (1 / (12 * h * h)) * (16 * (y_at(1) + y_at(-1)) - (y_at(2) + y_at(-2)) - 30 * y_at(0));
    const Sh<double> third =
        (1 / (8 * h * h * h)) * (8 * (y_at(2) - y_at(-2)) - 13 * (y_at(1) - y_at(-1)) - (y_at(3) - y_at(-3)));
    int order = 0;
    for (const Sh<double>& derivative : {y_at(0), first, second, third}) {
      Sh<double> band(l + 1);
      double square = 0;
      for (int m = -l; m <= l; ++m) {
        band(l, m) = derivative(l, m);
        square += band(l, m) * band(l, m);
      }
      // The error of the differences: about (l h)^4, and rounding over h^3.
      EXPECT_NEAR(derivative_bound(band, order) / square, 1, 2e-4) << l << " " << order;
      ++order, ++compared;
    }
  }
  EXPECT_EQ(compared, 6 * 4);
}

}  // namespace
}  // namespace zonal
