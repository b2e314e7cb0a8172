#include "zonal/sh/sh.h"

#include <gtest/gtest.h>

#include <vector>

namespace zonal {
namespace {

static_assert(sizeof(Sh<float, 3>) == 36, "a plain value of nine floats");
static_assert(sizeof(Sh<Rgb, 4>) == 16 * sizeof(Rgb));
static_assert(std::is_trivially_copyable_v<Sh<double, 6>>);

template <class T, int N>
Sh<T, N> counting(int bands) {
  Sh<T, N> sh(bands);
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = static_cast<T>(i);
  return sh;
}

TEST(Sh, StartsAtZeroAndKnowsItsSize) {
  const Sh<double, 4> fixed;
  const Sh<Rgb> dynamic(7);
  EXPECT_EQ(fixed.bands(), 4);
  EXPECT_EQ(fixed.size(), 16u);
  EXPECT_EQ(dynamic.bands(), 7);
  EXPECT_EQ(dynamic.size(), 49u);
  for (const double value : fixed.values()) EXPECT_EQ(value, 0);
  for (const Rgb& value : dynamic.values()) EXPECT_EQ(value, Rgb());
  EXPECT_EQ(Sh<float>().bands(), 0);
  EXPECT_THROW((Sh<float, 3>(4)), std::logic_error);
}

TEST(Sh, IndexesByBandAndByPosition) {
  const Sh<double> sh = counting<double, kDynamic>(9);
  int next = 0;
  for (int l = 0; l < 9; ++l) {
    ASSERT_EQ(sh.band(l).size(), static_cast<std::size_t>(2 * l + 1));
    for (int m = -l; m <= l; ++m, ++next) {
      EXPECT_EQ(sh(l, m), next);
      EXPECT_EQ(sh.band(l)[m + l], next);
    }
  }
  EXPECT_EQ(next, 81);
}

TEST(Sh, AddsAndScales) {
  const Sh<float, 3> a = counting<float, 3>(3);
  EXPECT_EQ(a + a, 2 * a);
  EXPECT_EQ(3 * a - a, a + a);
  EXPECT_EQ((2 * a)(2, 2), 16);
  const Sh<double> b = counting<double, kDynamic>(3);
  EXPECT_EQ(b + b, 2 * b);
  EXPECT_THROW(b + Sh<double>(4), std::logic_error);
}

TEST(Sh, TakesAColor) {
  const Sh<Rgb, 2> tinted = Rgb(1, 2, -3) * counting<float, 2>(2);
  for (int i = 0; i < 4; ++i) {
    const auto value = static_cast<float>(i);
    EXPECT_EQ(tinted[i], Rgb(value, 2 * value, -3 * value));
  }
}

TEST(Sh, ChangesPrecisionAndBands) {
  const Sh<Rgb> wide = cast<Rgb>(RgbD(1, 0.5, 2) * counting<double, kDynamic>(3));
  EXPECT_EQ(wide[8], Rgb(8, 4, 16));
  const Sh<double, 3> fixed = with_bands<3>(counting<double, kDynamic>(5));
  EXPECT_EQ(fixed, (counting<double, 3>(3)));
  const Sh<double> padded = with_bands(fixed, 4);
  EXPECT_EQ(padded.bands(), 4);
  EXPECT_EQ(padded[8], 8);
  for (int i = 9; i < 16; ++i) EXPECT_EQ(padded[i], 0);
}

TEST(Sh, BridgesFromRunTimeToCompileTime) {
  std::vector<int> seen;
  for (int bands = 0; bands <= 8; ++bands) seen.push_back(with_static_bands(bands, []<int N>() { return N; }));
  EXPECT_EQ(seen, (std::vector<int>{kDynamic, 1, 2, 3, 4, 5, 6, kDynamic, kDynamic}));
}

}  // namespace
}  // namespace zonal
