#include "zonal/sh/window.h"

#include <gtest/gtest.h>

#include <random>

#include "zonal/base/error.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

/// The delta function toward +Z: every basis function there.
Sh<double> delta(int bands) {
  Sh<double> sh(bands);
  basis(bands, {0, 0, 1}, sh.values());
  return sh;
}

double peak(const Sh<double>& sh) { return evaluate(sh, {0, 0, 1}); }

TEST(Window, HannAndLanczosAreZeroAtTheirWidth) {
  for (const Window& w : {Window::hann(6), Window::lanczos(6), Window::lanczos(6, 2)}) {
    const std::vector<double> factors = window_factors(w, 9);
    EXPECT_EQ(factors[0], 1);
    for (int l = 1; l < 6; ++l) EXPECT_LT(factors[l], factors[l - 1]);
    for (int l = 6; l < 9; ++l) EXPECT_EQ(factors[l], 0);
  }
  const std::vector<double> hann = window_factors(Window::hann(6), 6), lanczos = window_factors(Window::lanczos(6), 6);
  EXPECT_NEAR(hann[2], 0.75, 1e-16);
  EXPECT_NEAR(hann[3], 0.5, 1e-16);
  EXPECT_NEAR(lanczos[3], 2 / kPi, 1e-16);
  EXPECT_NEAR(window_factors(Window::lanczos(6, 2), 6)[3], 4 / (kPi * kPi), 1e-16);
  EXPECT_EQ(window_factors(Window::none(), 3), (std::vector<double>{1, 1, 1}));
}

TEST(Window, BringsThePeakOfTheDeltaToThePublishedHeight) {
  // Sloan 2008, footnote 12: widths 12.0105 and 9.8725, given to four decimals, bring 36/4pi to 2.25.
  EXPECT_NEAR(peak(delta(6)), 36 / (4 * kPi), 1e-14);
  EXPECT_NEAR(peak(window(delta(6), Window::hann(12.0105))), 2.25, 1e-5);
  EXPECT_NEAR(peak(window(delta(6), Window::lanczos(9.8725))), 2.25, 1e-5);
  EXPECT_NEAR(peak(window(delta(6), Window::hann(12.010498))), 2.25, 1e-7);
}

TEST(Window, SquaredLaplacianIsTheIntegral) {
  constexpr int kBands = 5;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Sh<double> sh(kBands), laplacian(kBands);
  for (int l = 0; l < kBands; ++l) {
    for (int m = -l; m <= l; ++m) {
      sh(l, m) = normal(random);
      laplacian(l, m) = -l * (l + 1) * sh(l, m);
    }
  }
  double integral = 0;
  for (const auto& [direction, weight] : sphere_rule(kBands)) {
    const double value = evaluate(laplacian, direction);
    integral += weight * value * value;
  }
  EXPECT_NEAR(squared_laplacian(sh) / integral, 1, 1e-13);
  EXPECT_NEAR(squared_laplacian(delta(6)) * 4 * kPi, 14700, 1e-10);
  EXPECT_EQ(squared_laplacian(RgbD(1, 2, 0) * sh).g, 4 * squared_laplacian(sh));
}

TEST(Window, LaplacianMinimisesItsObjective) {
  const Sh<double> sh = delta(4);
  const double weight = 0.01;
  const auto objective = [&](const Sh<double>& g) {
    double distance = 0;
    for (std::size_t i = 0; i < g.size(); ++i) distance += (g[i] - sh[i]) * (g[i] - sh[i]);
    return distance + weight * squared_laplacian(g);
  };
  const Sh<double> best = window(sh, Window::laplacian(weight));
  for (std::size_t i = 0; i < sh.size(); ++i) {
    for (const double step : {-1e-3, 1e-3}) {
      Sh<double> moved = best;
      moved[i] += step;
      EXPECT_GT(objective(moved), objective(best));
    }
  }
}

TEST(Window, LaplacianFractionIsReachedForAnySpectrum) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform;
  int compared = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const int bands = 2 + trial % 9;
    std::vector<double> energies(bands);
    for (double& energy : energies) energy = std::pow(10, 8 * uniform(random) - 4);
    const double fraction = 0.001 + 0.998 * uniform(random), weight = laplacian_weight(energies, fraction);
    double before = 0, after = 0;
    for (int l = 0; l < bands; ++l) {
      const double stiffness = std::pow(l * (l + 1.0), 2), damp = 1 + weight * stiffness;
      before += stiffness * energies[l];
      after += stiffness * energies[l] / (damp * damp);
    }
    EXPECT_NEAR(after / before / fraction, 1, 1e-11);  // rounding of sums of size 1, over a fraction down to 0.001
    ++compared;
  }
  EXPECT_EQ(compared, 2000);
}

TEST(Window, FractionLooksAtColoursTogetherOrApart) {
  Sh<RgbD> sh(4);
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = {1.0, std::cos(static_cast<double>(i)), i < 4 ? 1.0 : 0.01};
  const RgbD before = squared_laplacian(sh);
  const RgbD joint = squared_laplacian(window(sh, Window::laplacian_fraction(0.3)));
  const RgbD each = squared_laplacian(window(sh, Window::laplacian_fraction(0.3, WindowChannels::kEach)));
  EXPECT_NEAR((joint.r + joint.g + joint.b) / (before.r + before.g + before.b), 0.3, 1e-14);
  EXPECT_GT(joint.b / before.b, 0.4);  // the smooth channel is spared when they go together
  EXPECT_NEAR(each.r / before.r, 0.3, 1e-14);
  EXPECT_NEAR(each.g / before.g, 0.3, 1e-14);
  EXPECT_NEAR(each.b / before.b, 0.3, 1e-14);
}

TEST(Window, FixedBandsAndFloatsKeepTheirType) {
  const Sh<float, 3> sh = cast<float>(with_bands<3>(delta(3)));
  const Sh<float, 3> windowed = window(sh, Window::hann(4));
  EXPECT_FLOAT_EQ(windowed(2, 0), sh(2, 0) / 2);
  EXPECT_EQ(windowed(0, 0), sh(0, 0));
}

TEST(Window, FunctionsWithNothingToReduceStayAsTheyAre) {
  EXPECT_EQ(laplacian_weight(std::vector<double>{7, 0, 0}, 0.1), 0);
  EXPECT_EQ(laplacian_weight(std::vector<double>(), 0.1), 0);
  EXPECT_EQ(laplacian_weight(std::vector<double>{1, 1, 1}, 1), 0);
  const Sh<double> zero(5);
  EXPECT_EQ(window(zero, Window::laplacian_fraction(0.5)), zero);
}

TEST(Window, RefusesWhatMeansNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Window::hann(0), Error);
  EXPECT_THROW(Window::hann(nan), Error);
  EXPECT_THROW(Window::lanczos(-1), Error);
  EXPECT_THROW(Window::lanczos(6, 0), Error);
  EXPECT_THROW(Window::laplacian(-1e-9), Error);
  EXPECT_THROW(Window::laplacian_fraction(0), Error);
  EXPECT_THROW(Window::laplacian_fraction(nan), Error);
  EXPECT_THROW(laplacian_weight(std::vector<double>{1, nan}, 0.5), Error);
  EXPECT_THROW(window_factors(Window::laplacian_fraction(0.5), 4), std::logic_error);
}

TEST(Window, ContentDecidesWhereItActs) {
  const Vec3 light = {0, 0, 1};
  EXPECT_EQ(unwindowed_weight(light, light), 1);
  EXPECT_EQ(unwindowed_weight(light, {1, 0, 0}), 0);
  EXPECT_EQ(unwindowed_weight(light, {0, 0, -1}), 0);
  const double c = 0.535;  // half way from 0.07 to 1
  EXPECT_NEAR(unwindowed_weight(light, {std::sqrt(1 - c * c), 0, c}), std::pow(0.5, 0.8), 1e-15);
  EXPECT_THROW(unwindowed_weight(light, light, {.threshold = 1}), Error);
}

}  // namespace
}  // namespace zonal
