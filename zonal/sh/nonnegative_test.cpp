#include "zonal/sh/nonnegative.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "zonal/base/error.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/minimum.h"

namespace zonal {
namespace {

/// `peak` times a delta toward a direction, and 1 everywhere: rings below zero.
Sh<double> ringing(int bands, double peak, Vec3 toward) {
  Sh<double> sh(bands);
  basis(bands, toward, sh.values());
  sh *= peak;
  sh[0] += 2 * std::sqrt(kPi);
  return sh;
}

double lowest_on_a_grid(const Sh<double>& sh) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3 d : spiral_directions(20000)) lowest = std::min(lowest, evaluate(sh, d));
  return lowest;
}

TEST(NonNegative, WindowIsTheWeakestThatWillDo) {
  int compared = 0;
  for (const int bands : {3, 4, 6, 8}) {
    for (const WindowKind family : {WindowKind::kHann, WindowKind::kLanczos, WindowKind::kLaplacian}) {
      const Sh<double> sh = ringing(bands, 30, normalize({1, -2, 0.5}));
      ASSERT_LT(lowest_on_a_grid(sh), -0.1);
      const double mean = sh[0] / std::sqrt(4 * kPi);
      const NonNegativeWindow result = nonnegative_window(sh, {.family = family});
      EXPECT_EQ(result.window.kind(), family);
      EXPECT_GE(result.guaranteed_minimum, -1e-5 * mean);
      EXPECT_LE(result.guaranteed_minimum, result.minimum_found);
      EXPECT_GE(lowest_on_a_grid(window(sh, result.window)), result.guaranteed_minimum);
      // A window weaker by one part in a thousand leaves something negative beyond the tolerance.
      const double amount = result.window.amount();
      const Window weaker = family == WindowKind::kHann      ? Window::hann(amount * 1.001)
                            : family == WindowKind::kLanczos ? Window::lanczos(amount * 1.001)
                                                             : Window::laplacian(amount / 1.001);
      EXPECT_LT(certified_minimum(window(sh, weaker)).found, -1e-5 * mean);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12);
}

TEST(NonNegative, IrradianceNeedsLessThanRadiance) {
  const Sh<double> radiance = ringing(6, 600, {0, 0, 1});
  const NonNegativeWindow raw = nonnegative_window(radiance), matte = nonnegative_window(irradiance(radiance));
  ASSERT_EQ(matte.window.kind(), WindowKind::kHann);
  EXPECT_GT(matte.window.amount(), raw.window.amount());
  EXPECT_GE(lowest_on_a_grid(irradiance(window(radiance, matte.window))), matte.guaranteed_minimum);
}

TEST(NonNegative, ColoursShareTheWindowOfTheWorst) {
  const Sh<double> calm = ringing(4, 0.01, {0, 0, 1}), wild = ringing(4, 20, {1, 0, 0});
  const Sh<RgbD> both = RgbD(1, 0, 0) * calm + RgbD(0, 1, 0) * wild;  // and a blue of zero
  EXPECT_NEAR(nonnegative_window(both).window.amount(), nonnegative_window(wild).window.amount(), 1e-12);
  EXPECT_EQ(nonnegative_window(calm).window, Window::none());
}

TEST(NonNegative, StatesTheSpecialCases) {
  const Sh<float, 3> zero;
  EXPECT_EQ(nonnegative_window(zero).window, Window::none());
  EXPECT_EQ(nonnegative_window(zero).guaranteed_minimum, 0);
  Sh<double, 3> touching;  // 1 + z
  touching(0, 0) = std::sqrt(4 * kPi);
  touching(1, 0) = std::sqrt(4 * kPi / 3);
  EXPECT_EQ(nonnegative_window(touching).window, Window::none());
  Sh<double, 3> no_mean;
  no_mean(1, 0) = 1;
  const NonNegativeWindow all_gone = nonnegative_window(no_mean);
  EXPECT_NEAR(all_gone.window.amount(), 1, 1e-5);
  EXPECT_EQ(all_gone.guaranteed_minimum, 0);
  EXPECT_THROW(nonnegative_window(no_mean, {.family = WindowKind::kLaplacian}), Error);
  Sh<double, 3> negative;
  negative(0, 0) = -1;
  EXPECT_THROW(nonnegative_window(negative), Error);
  EXPECT_THROW(nonnegative_window(zero, {.family = WindowKind::kNone}), Error);
  negative(2, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(nonnegative_window(negative), Error);
  Sh<double, 6> faint = with_bands<6>(ringing(6, 1, {0, 0, 1}));
  faint(0, 0) = 1e-9;  // almost no mean: the Laplacian must almost level it
  const NonNegativeWindow level = nonnegative_window(faint, {.family = WindowKind::kLaplacian});
  EXPECT_GE(level.guaranteed_minimum, -1e-14);
}

}  // namespace
}  // namespace zonal
