#include "zonal/sh/half_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

struct Entry {
  int l, other, m;
  double value;
};

TEST(HalfSpace, AgreesWithClosedForms) {
  const AxialProduct<6> h = half_space<6>();
  const std::vector<Entry> half = {{0, 0, 0, 0.5},
                                   {0, 1, 0, std::sqrt(3) / 4},
                                   {0, 3, 0, -std::sqrt(7) / 16},
                                   {1, 4, 1, -std::sqrt(30) / 32},
                                   {2, 3, -2, 5 * std::sqrt(7) / 32},
                                   {3, 4, 3, 105.0 / 256},
                                   {4, 5, 0, 27 * std::sqrt(11) / 256},
                                   {4, 5, 4, 63 * std::sqrt(11) / 512}};
  const AxialProduct<6> c = clamped_cosine<6>();
  const std::vector<Entry> cosine = {{0, 0, 0, 0.25},
                                     {0, 4, 0, -1.0 / 32},
                                     {1, 5, 1, -std::sqrt(55) / 256},
                                     {2, 4, 0, 13 * std::sqrt(5) / 256},
                                     {3, 5, -2, 7 * std::sqrt(11) / 256},
                                     {5, 5, 5, 231.0 / 2048},
                                     {5, 5, 0, 165.0 / 512}};
  for (const auto& [l, other, m, value] : half) {
    EXPECT_NEAR(h(l, other, m), value, 2e-15);
    EXPECT_NEAR(h(other, l, -m), value, 2e-15);
  }
  for (const auto& [l, other, m, value] : cosine) EXPECT_NEAR(c(l, other, m), value, 2e-15);
}

TEST(HalfSpace, IsAHalfOfTheIdentityForEvenSumsOfAnyBands) {
  const AxialProduct<> h = half_space(80);
  double worst = 0;
  int compared = 0;
  for (int m = 0; m < 80; ++m) {
    for (int l = m; l < 80; ++l) {
      for (int other = l; other < 80; other += 2, ++compared) {
        worst = std::max(worst, std::abs(h(l, other, m) - (l == other ? 0.5 : 0)));
      }
    }
  }
  EXPECT_EQ(compared, 45100);  // floor((n+1)^2 / 4) summed over n = 1..80
  EXPECT_LT(worst, 1e-13);     // sums of 80 rounded terms
}

TEST(HalfSpace, TwoHalvesMakeAWhole) {
  Sh<double> f(13);
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = std::sin(3.0 * static_cast<double>(i));
  const Sh<double, 5> few = with_bands<5>(f);
  for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, normalize({0.2, -0.7, 0.4}), Vec3{-1, 0, 0}}) {
    const Sh<double> sum = multiply_by_half_space(f, axis) + multiply_by_half_space(f, -axis);
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(sum[i], f[i], 1e-13);
    // max(c, 0) - max(-c, 0) = c.
    const Sh<double, 5> ramp = multiply_by_clamped_cosine(few, axis) - multiply_by_clamped_cosine(few, -axis);
    Sh<double, 5> back;
    for (const auto& [d, weight] : sphere_rule(6)) {
      std::array<double, 25> y;
      basis(5, d, std::span<double>(y));
      for (std::size_t i = 0; i < y.size(); ++i) back[i] += weight * dot(d, axis) * evaluate(few, d) * y[i];
    }
    for (std::size_t i = 0; i < back.size(); ++i) EXPECT_NEAR(ramp[i], back[i], 1e-14 * 4);
  }
}

TEST(HalfSpace, TheMeanOfTheCosineProductIsTheIrradiance) {
  Sh<RgbD, 6> f;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double x = static_cast<double>(i);
    f[i] = {std::cos(x), std::sin(2 * x), 1 / (1 + x)};
  }
  int compared = 0;
  for (const Vec3 n : spiral_directions(20)) {
    const RgbD whole = 2 * std::sqrt(kPi) * multiply_by_clamped_cosine(f, n)[0], e = evaluate(irradiance(f), n);
    EXPECT_NEAR(whole.r, e.r, 1e-13);
    EXPECT_NEAR(whole.g, e.g, 1e-13);
    EXPECT_NEAR(whole.b, e.b, 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 20);
}

TEST(HalfSpace, RefusesBadInput) {
  const Sh<double, 3> f;
  EXPECT_THROW(multiply_by_half_space(f, {0, 0, 0}), std::logic_error);
  EXPECT_THROW(multiply_by_clamped_cosine(f, {0, 0, std::numeric_limits<double>::quiet_NaN()}), std::logic_error);
  EXPECT_THROW(half_space(0), std::logic_error);
  EXPECT_THROW(multiply_by_half_space(Sh<double>(), {0, 0, 1}), std::logic_error);
}

}  // namespace
}  // namespace zonal
