#include "zonal/sh/peaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "zonal/base/error.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

Sh<double> random_function(int bands, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Sh<double> sh(bands);
  for (double& value : sh.values()) value = normal(random);
  return sh;
}

TEST(Peaks, OfALinearFunctionAreItsAxis) {
  Sh<float, 2> sh;
  sh(0, 0) = 1;
  sh(1, 1) = 3;
  const Peaks peaks = find_peaks(sh);
  ASSERT_EQ(peaks.maxima.size(), 1u);
  ASSERT_EQ(peaks.minima.size(), 1u);
  EXPECT_NEAR(length(peaks.maxima[0].direction - Vec3{1, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(length(peaks.minima[0].direction - Vec3{-1, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(peaks.maxima[0].value, (1 + 3 * std::sqrt(3.0)) / std::sqrt(4 * kPi), 1e-12);
  EXPECT_TRUE(peaks.maxima[0].isolated);
  EXPECT_LT(peaks.largest_gradient, 1e-12);
}

TEST(Peaks, OfXyzAreTheCornersOfTheCube) {
  Sh<double, 4> sh;
  sh(3, -2) = -2;  // xyz
  const Peaks peaks = find_peaks(sh);
  ASSERT_EQ(peaks.maxima.size(), 4u);
  ASSERT_EQ(peaks.minima.size(), 4u);
  for (const Peak& peak : peaks.maxima) {
    const auto [x, y, z] = peak.direction;
    EXPECT_LT(x * y * z, 0);
    for (const double c : {x, y, z}) EXPECT_NEAR(std::abs(c), 1 / std::sqrt(3), 1e-12);
  }
}

TEST(Peaks, RingsAndPlateausAreOne) {
  Sh<double, 3> ring;
  ring(2, 0) = -1;  // highest on the whole equator
  const Peaks peaks = find_peaks(ring);
  ASSERT_EQ(peaks.maxima.size(), 1u);
  EXPECT_FALSE(peaks.maxima[0].isolated);
  EXPECT_NEAR(peaks.maxima[0].direction.z, 0, 1e-7);
  ASSERT_EQ(peaks.minima.size(), 2u);
  EXPECT_TRUE(peaks.minima[0].isolated);

  for (const double value : {0.0, 2.5}) {
    Sh<double, 4> constant;
    constant(0, 0) = value;
    const Peaks plateau = find_peaks(constant);
    ASSERT_EQ(plateau.maxima.size(), 1u);
    ASSERT_EQ(plateau.minima.size(), 1u);
    EXPECT_EQ(plateau.maxima[0].value, value / std::sqrt(4 * kPi));
    EXPECT_EQ(plateau.maxima[0].gradient, 0);
    EXPECT_FALSE(plateau.maxima[0].isolated);
  }
}

TEST(Peaks, DoNotDependOnTheScaleOrTheMean) {
  std::mt19937 random(4);
  const Sh<double> sh = random_function(6, random);
  const Peaks peaks = find_peaks(sh);
  for (const double scale : {1e-30, 1e30}) {
    Sh<double> other = scale * sh;
    other[0] += 100 * scale;
    const Peaks same = find_peaks(other);
    ASSERT_EQ(same.maxima.size(), peaks.maxima.size());
    for (std::size_t i = 0; i < peaks.maxima.size(); ++i) {
      EXPECT_NEAR(length(same.maxima[i].direction - peaks.maxima[i].direction), 0, 1e-9);
    }
  }
}

TEST(Peaks, RefuseWhatIsNotANumber) {
  Sh<double, 3> sh;
  sh(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(find_peaks(sh), Error);
  sh(2, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(find_peaks(sh), Error);
  EXPECT_THROW(find_peaks(Sh<double>(0)), std::logic_error);
}

TEST(SlowPeaks, AreAllThatADenseGridSees) {
  std::mt19937 random(6);
  int maxima = 0, missed = 0, missed_highest = 0, functions = 0;
  for (int bands = 2; bands <= 8; ++bands) {
    const std::vector<Vec3> grid = spiral_directions(60 * bands * bands);
    const double spacing = std::sqrt(4 * kPi / static_cast<double>(grid.size()));
    std::vector<std::vector<std::size_t>> neighbours(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
      for (std::size_t k = 0; k < grid.size(); ++k) {
        if (i != k && length(grid[i] - grid[k]) < 2.5 * spacing) neighbours[i].push_back(k);
      }
    }
    for (int trial = 0; trial < 60; ++trial, ++functions) {
      const Sh<double> sh = random_function(bands, random);
      const Peaks peaks = find_peaks(sh);
      const double unit = derivative_bound(sh, 0);
      EXPECT_LT(peaks.largest_gradient, 1e-12 * bands * unit);
      std::vector<double> values;
      for (const Vec3 d : grid) values.push_back(evaluate(sh, d));
      missed_highest += *std::max_element(values.begin(), values.end()) > peaks.maxima.front().value;
      missed_highest += *std::min_element(values.begin(), values.end()) < peaks.minima.front().value;
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const bool highest = std::all_of(neighbours[i].begin(), neighbours[i].end(),
                                         [&](std::size_t k) { return values[k] < values[i]; });
        if (!highest) continue;
        ++maxima;
        // Where the climb from it ends.
        const Vec3 top = descend(-1 * sh, grid[i]).direction;
        missed += std::none_of(peaks.maxima.begin(), peaks.maxima.end(),
                               [&](const Peak& peak) { return length(peak.direction - top) < 1e-3 / bands; });
      }
    }
  }
  EXPECT_EQ(functions, 7 * 60);
  EXPECT_EQ(missed_highest, 0);
  EXPECT_GT(maxima, 2000);
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace zonal
