#include "zonal/io/half.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace zonal {
namespace {

constexpr int kFiniteHalves = 0x7c00;  // of one sign: 0 .. 65504

std::vector<std::uint16_t> all_halves() {
  std::vector<std::uint16_t> all(65536);
  std::iota(all.begin(), all.end(), std::uint16_t{0});
  return all;
}

/// The value by the definition of binary16, apart from the kernel.
double half_by_definition(int half) {
  const int exponent = (half >> 10) & 31, fraction = half & 1023;
  const double sign = (half & 0x8000) ? -1 : 1;
  if (exponent == 31) return fraction ? std::nan("") : sign * std::numeric_limits<double>::infinity();
  return exponent == 0 ? sign * std::ldexp(fraction, -24) : sign * std::ldexp(1024 + fraction, exponent - 25);
}

std::uint16_t half_of(float value, Isa isa, std::size_t* clipped = nullptr) {
  std::uint16_t half = 0;
  const std::size_t count = halves_from_floats({&value, 1}, {&half, 1}, isa);
  if (clipped) *clipped = count;
  return half;
}

TEST(Half, EveryHalfIsTheFloatOfItsDefinition) {
  const std::vector<std::uint16_t> halves = all_halves();
  int levels = 0, compared = 0;
  for (const Isa isa : available_isas()) {
    ++levels;
    std::vector<float> floats(halves.size());
    floats_from_halves(halves, floats, isa);
    for (int i = 0; i < 65536; ++i, ++compared) {
      const double expected = half_by_definition(i);
      if (std::isnan(expected)) {
        ASSERT_TRUE(std::isnan(floats[i])) << i;
      } else {
        ASSERT_EQ(std::bit_cast<std::uint32_t>(floats[i]), std::bit_cast<std::uint32_t>(static_cast<float>(expected)))
            << i;
      }
    }
  }
  EXPECT_EQ(compared, 65536 * levels);
}

TEST(Half, EveryHalfSurvivesTheRoundTrip) {
  const std::vector<std::uint16_t> halves = all_halves();
  for (const Isa isa : available_isas()) {
    std::vector<float> floats(halves.size());
    std::vector<std::uint16_t> again(halves.size());
    floats_from_halves(halves, floats, isa);
    EXPECT_EQ(halves_from_floats(floats, again, isa), 2u);  // the two infinities
    int same = 0, nan = 0;
    for (int i = 0; i < 65536; ++i) {
      const int magnitude = i & 0x7fff;
      if (magnitude > kFiniteHalves) {
        EXPECT_EQ(again[i], i | 0x200);  // a NaN keeps its sign and payload and is quiet
        ++nan;
      } else {
        EXPECT_EQ(again[i], magnitude == kFiniteHalves ? i - 1 : i);
        ++same;
      }
    }
    EXPECT_EQ(same, 2 * (kFiniteHalves + 1));
    EXPECT_EQ(nan, 2 * 1023);
  }
}

TEST(Half, RoundsToNearestAndTiesToEven) {
  int compared = 0;
  for (const Isa isa : available_isas()) {
    std::vector<float> values;
    std::vector<std::uint16_t> expected;
    for (int h = 0; h + 1 < kFiniteHalves; ++h) {
      const float middle = static_cast<float>((half_by_definition(h) + half_by_definition(h + 1)) / 2);
      for (const int sign : {0, 0x8000}) {
        const float s = sign ? -1.0f : 1.0f;
        values.insert(values.end(), {s * std::nextafter(middle, 0.0f), s * middle, s * std::nextafter(middle, 1e9f)});
        const int even = h % 2 == 0 ? h : h + 1;
        for (const int nearest : {h, even, h + 1}) expected.push_back(static_cast<std::uint16_t>(sign | nearest));
      }
    }
    std::vector<std::uint16_t> halves(values.size());
    EXPECT_EQ(halves_from_floats(values, halves, isa), 0u);
    for (std::size_t i = 0; i < values.size(); ++i, ++compared) ASSERT_EQ(halves[i], expected[i]) << values[i];
  }
  EXPECT_EQ(compared, static_cast<int>(available_isas().size()) * 6 * (kFiniteHalves - 1));
}

TEST(Half, ClampsAndCountsWhatDoesNotFit) {
  const float inf = std::numeric_limits<float>::infinity();
  int cases = 0;
  for (const Isa isa : available_isas()) {
    std::size_t clipped = 9;
    EXPECT_EQ(half_of(std::nextafter(65520.0f, 0.0f), isa, &clipped), 0x7bff);
    EXPECT_EQ(clipped, 0u);
    for (const float large : {65520.0f, 1e6f, std::numeric_limits<float>::max(), inf}) {
      EXPECT_EQ(half_of(large, isa, &clipped), 0x7bff) << large;
      EXPECT_EQ(clipped, 1u);
      EXPECT_EQ(half_of(-large, isa, &clipped), 0xfbff) << large;
      EXPECT_EQ(clipped, 1u);
      ++cases;
    }
    EXPECT_EQ(half_of(std::numeric_limits<float>::signaling_NaN(), isa, &clipped) & 0x7e00, 0x7e00);
    EXPECT_EQ(clipped, 0u);
    EXPECT_EQ(half_of(1e-30f, isa, &clipped), 0);
    EXPECT_EQ(half_of(-std::numeric_limits<float>::denorm_min(), isa, &clipped), 0x8000);
    EXPECT_EQ(clipped, 0u);
  }
  EXPECT_EQ(cases, 4 * static_cast<int>(available_isas().size()));
}

TEST(Half, TexelsGainAlphaOneAndAreCountedOnce) {
  constexpr int kTexels = 2500;  // more than two inner blocks, and a remainder
  std::vector<Rgb> texels(kTexels);
  for (int i = 0; i < kTexels; ++i) {
    const float step = static_cast<float>(i);
    texels[i] = {0.5f * step, -1 / (step + 1), 3};
  }
  texels[7] = {1e9f, -1e9f, 1e9f};
  texels[2499].b = std::numeric_limits<float>::infinity();
  int compared = 0;
  for (const Isa isa : available_isas()) {
    std::vector<std::uint16_t> halves(4 * kTexels);
    EXPECT_EQ(rgba_halves_from_rgb(texels, halves, isa), 2u);
    for (int i = 0; i < kTexels; ++i) {
      ASSERT_EQ(halves[4 * i + 0], half_of(texels[i].r, isa)) << i;
      ASSERT_EQ(halves[4 * i + 1], half_of(texels[i].g, isa)) << i;
      ASSERT_EQ(halves[4 * i + 2], half_of(texels[i].b, isa)) << i;
      ASSERT_EQ(halves[4 * i + 3], 0x3c00) << i;
      compared += 4;
    }
  }
  EXPECT_EQ(compared, 4 * kTexels * static_cast<int>(available_isas().size()));
}

TEST(Half, SpansOfDifferentLengthAreAMistakeOfTheCaller) {
  std::vector<float> two(2);
  std::vector<std::uint16_t> one(1);
  EXPECT_THROW((void)halves_from_floats(two, one), std::logic_error);
  EXPECT_THROW(floats_from_halves(one, two), std::logic_error);
}

}  // namespace
}  // namespace zonal
