#include "zonal/light/quasi_newton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace zonal {
namespace {

/// Rosenbrock 1960: a bent valley whose floor is nearly level.
double valley(std::span<const double> x, std::span<double> slopes) {
  const double off = x[1] - x[0] * x[0];
  slopes[0] = -400 * off * x[0] - 2 * (1 - x[0]);
  slopes[1] = 200 * off;
  return 100 * off * off + (1 - x[0]) * (1 - x[0]);
}

TEST(QuasiNewton, FollowsABentValley) {
  std::vector<double> x = {-1.2, 1};
  int evaluations = 0;
  minimise(
      [&](std::span<const double> at, std::span<double> slopes) {
        ++evaluations;
        return valley(at, slopes);
      },
      x);
  EXPECT_NEAR(x[0], 1, 1e-9);
  EXPECT_NEAR(x[1], 1, 1e-9);
  EXPECT_LT(evaluations, 100);  // steepest descent takes thousands
}

TEST(QuasiNewton, FindsTheBottomOfEllipsoids) {
  constexpr int kSize = 8;
  std::vector<double> x(kSize, 1.0);
  minimise(
      [](std::span<const double> at, std::span<double> slopes) {
        double value = 0;
        for (std::size_t i = 0; i < at.size(); ++i) {
          const double stiffness = std::pow(4, i), off = at[i] - static_cast<double>(i);
          slopes[i] = stiffness * off;
          value += stiffness * off * off / 2;
        }
        return value;
      },
      x);
  for (int i = 0; i < kSize; ++i) EXPECT_NEAR(x[static_cast<std::size_t>(i)], i, 1e-9);
}

TEST(QuasiNewton, KinksDoNotStopIt) {
  std::vector<double> x = {3, 2};
  minimise(
      [](std::span<const double> at, std::span<double> slopes) {
        slopes[0] = at[0] > 0 ? 1 : -1;
        slopes[1] = 20 * at[1];
        return std::abs(at[0]) + 10 * at[1] * at[1];
      },
      x);
  EXPECT_NEAR(x[0], 0, 1e-6);
  EXPECT_NEAR(x[1], 0, 1e-4);
}

TEST(QuasiNewton, StaysWhereNothingIsLower) {
  const std::vector<double> start = {1, 1};
  std::vector<double> x = start;
  minimise(valley, x);  // the minimum itself
  EXPECT_EQ(x, start);
  minimise(
      [](std::span<const double>, std::span<double> slopes) {
        slopes[0] = slopes[1] = 1;  // a slope that leads nowhere
        return std::nan("");
      },
      x);
  EXPECT_EQ(x, start);
  x.clear();
  minimise([](std::span<const double>, std::span<double>) { return 0.0; }, x);
  EXPECT_TRUE(x.empty());
}

}  // namespace
}  // namespace zonal
