#include "zonal/light/split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "zonal/light/split_test.h"
#include "zonal/light/synthetic_disc.h"

namespace zonal {
namespace {

TEST(SplitFill, TheFillIsAMembrane) {
  // Linear functions solve Laplace's equation on a flat disc; on the sphere they bend by the square of its radius.
  const Projection equirect{Layout::kEquirect};
  const auto linear = [](Vec3 d) { return static_cast<float>(2 + d.x + 0.5 * d.y - 0.3 * d.z); };
  Environment whole = paint(equirect, {512, 256}, [&](Vec3 d) { return Rgb{linear(d), linear(d), linear(d)}; });
  const Environment background = whole;
  add_disc(whole, normalize({0.2, 1, 0.7}), radians(4), {1e4, 1e4, 1e4});
  const SplitEnvironment split = split_lights(whole);
  ASSERT_EQ(split.lights.size(), 1u);
  double worst = 0;
  int changed = 0;
  for (std::size_t i = 0; i < whole.radiance.size(); ++i) {
    if (whole.radiance.values()[i] == split.rest.radiance.values()[i]) continue;
    worst = std::max<double>(worst, std::abs(split.rest.radiance.values()[i].g - background.radiance.values()[i].g));
    ++changed;
  }
  EXPECT_GT(changed, 90);  // a disc of 5.7 texels' radius and a ring
  EXPECT_LT(worst, 0.01);  // (4.7 degrees)² = 0.0067, and the staircase of the rim
}

TEST(SplitFill, TheFillStaysBetweenTheRimsValues) {
  std::mt19937 random(17);
  std::uniform_real_distribution<float> radiance(0.5f, 2);
  Environment whole = sky(128);
  for (Rgb& c : whole.radiance.values()) c = {radiance(random), radiance(random), radiance(random)};
  add_disc(whole, {0, 0, 1}, radians(5), {1e4, 2e4, 3e4});
  add_disc(whole, normalize({-1, 0.01, 0}), radians(3), {1e5, 1e5, 1e5});
  const SplitEnvironment split = split_lights(whole);
  ASSERT_EQ(split.lights.size(), 2u);
  for (const Rgb& c : split.rest.radiance.values()) {
    for (const float channel : {c.r, c.g, c.b}) {
      ASSERT_GE(channel, 0.5f);
      ASSERT_LE(channel, 2.0f);
    }
  }
  expect_balance(whole, split);
}

TEST(SplitFill, RingingBesideASunGoesWithIt) {
  Environment whole = sky(128);
  const Mapping mapping(whole.projection, {256, 128});
  const Texel sun_texel = mapping.nearest(normalize({1, 0.3, 0.4}));
  for (int y = -3; y <= 3; ++y) {
    for (int x = -3; x <= 3; ++x) {
      const int ring = std::max(std::abs(x), std::abs(y));
      const float lobe = std::array{2e6f, -9000.0f, 300.0f, -20.0f}[static_cast<std::size_t>(ring)];
      whole.radiance(sun_texel.x + x, sun_texel.y + y) = {lobe, lobe, lobe};
    }
  }
  whole.radiance(3, 100) = {-7, -7, -7};  // elsewhere it is none of our business
  const SplitEnvironment split = split_lights(whole);
  ASSERT_EQ(split.lights.size(), 1u);
  int negative = 0;
  for (const Rgb& c : split.rest.radiance.values()) negative += c.r < 0;
  EXPECT_EQ(negative, 1);
  EXPECT_EQ(split.rest.radiance(3, 100).r, -7);
  EXPECT_EQ(split.changed_texels, 49);
  expect_balance(whole, split);
}

TEST(SplitFill, AChannelTheSourceLacksStaysAsItIs) {
  Environment whole = sky(128, {0.2f, 0.4f, 1});
  const Vec3 toward = normalize({1, 0.3, 0.4});
  const Mapping mapping(whole.projection, {256, 128});
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 256; ++x) {
      if (angle_between(*mapping.texel_direction(x, y), toward) < radians(3)) whole.radiance(x, y) = {2000, 500, 0.25f};
    }
  }
  const SplitEnvironment split = split_lights(whole);
  ASSERT_EQ(split.lights.size(), 1u);
  EXPECT_EQ(split.lights[0].energy.b, 0);
  EXPECT_EQ(split.lights[0].irradiance.b, 0);
  EXPECT_NEAR(split.lights[0].energy.r / split.lights[0].energy.g, 1999.8 / 499.6, 1e-5);
  for (std::size_t i = 0; i < whole.radiance.size(); ++i)
    ASSERT_EQ(split.rest.radiance.values()[i].b, whole.radiance.values()[i].b);
  expect_balance(whole, split);
}

}  // namespace
}  // namespace zonal
