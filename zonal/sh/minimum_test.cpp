#include "zonal/sh/minimum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/peaks.h"

namespace zonal {
namespace {

Sh<double> delta(int bands, Vec3 toward) {
  Sh<double> sh(bands);
  basis(bands, toward, sh.values());
  return sh;
}

double lowest_on_a_grid(const Sh<double>& sh) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3 d : spiral_directions(20000)) lowest = std::min(lowest, evaluate(sh, d));
  return lowest;
}

TEST(Minimum, IsFoundAndBounded) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  int compared = 0;
  for (int bands = 1; bands <= 8; ++bands) {
    for (int trial = 0; trial < 5; ++trial, ++compared) {
      Sh<double> sh(bands);
      for (double& value : sh.values()) value = normal(random);
      const Minimum minimum = certified_minimum(sh, {.tolerance = 1e-6});
      EXPECT_LE(minimum.guaranteed, minimum.found);
      EXPECT_LE(minimum.found - minimum.guaranteed, 1e-6);
      EXPECT_NEAR(evaluate(sh, minimum.direction), minimum.found, 1e-13 * bands);
      // Two ways that know nothing of cells.
      EXPECT_NEAR(minimum.found, find_peaks(sh).minima.front().value, 1e-12 * bands);
      EXPECT_GE(lowest_on_a_grid(sh), minimum.found - 1e-13 * bands);
    }
  }
  EXPECT_EQ(compared, 40);
}

TEST(Minimum, OfAPlateauOrARingEndsToo) {
  const Minimum zero = certified_minimum(Sh<double>(4));
  EXPECT_EQ(zero.found, 0);
  EXPECT_EQ(zero.guaranteed, 0);
  Sh<double> ring(3);
  ring(2, 0) = 1;  // lowest on the whole equator
  const Minimum minimum = certified_minimum(ring, {.tolerance = 1e-5});
  EXPECT_NEAR(minimum.found, -std::sqrt(5 / (16 * kPi)), 1e-14);
  EXPECT_LE(minimum.found - minimum.guaranteed, 1e-5);
}

TEST(Minimum, KeepsItsPromiseWhenStoppedEarly) {
  const Sh<double> sh = delta(6, {0, 0.6, 0.8});
  const Minimum exact = certified_minimum(sh), hasty = certified_minimum(sh, {.max_evaluations = 100});
  EXPECT_LE(hasty.evaluations, 104);
  EXPECT_LT(hasty.guaranteed, exact.guaranteed);
  EXPECT_LT(certified_minimum(sh, {.enough = 0}).evaluations, exact.evaluations);
  EXPECT_LT(certified_minimum(sh, {.enough = 0}).found, 0);
}

}  // namespace
}  // namespace zonal
