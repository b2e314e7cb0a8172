#include "zonal/light/split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "zonal/base/error.h"
#include "zonal/light/split_test.h"
#include "zonal/light/synthetic_disc.h"

namespace zonal {
namespace {

double texel_deg(const Environment& e) { return degrees(std::sqrt(4 * kPi / static_cast<double>(e.radiance.size()))); }

TEST(SlowSplit, AKnownSunIsMeasured) {
  // At the centre, across the seam, at and near both poles, anywhere.
  const std::vector<Vec3> directions = {{1, 0, 0},  {-1, 0, 0},    normalize({0, 0.01, 1}),
                                        {0, 0, -1}, {0.6, 0, 0.8}, normalize({-0.3, 0.5, -0.2})};
  int suns = 0;
  for (const Vec3 toward : directions) {
    for (const double diameter : {4.0, 7.3}) {  // texels are 0.7 degrees
      const SunOptions options{toward, diameter, {0.5f, 1, 2}, 1e5};
      const Environment whole = sun({Layout::kEquirect}, {512, 256}, options);
      const SplitEnvironment split = split_lights(whole);
      ASSERT_EQ(split.lights.size(), 1u);
      const SplitLight& light = split.lights[0];
      const double half_angle = radians(diameter / 2);
      EXPECT_LT(degrees(angle_between(light.direction, toward)), 0.1 * 180 / 256) << toward.z;
      EXPECT_TRUE(light.resolved);
      EXPECT_NEAR(light.half_angle / half_angle, 1, 1e-3);
      // The excess over a sky of 1 in green; the disc's texels stand for points a texel apart, which costs some 1e-4.
      const double irradiance = (1e5 - 1) * kPi * std::pow(std::sin(half_angle), 2);
      EXPECT_NEAR(light.irradiance.r / irradiance, 0.5, 0.5e-3);
      EXPECT_NEAR(light.irradiance.g / irradiance, 1, 1e-3);
      EXPECT_NEAR(light.irradiance.b / irradiance, 2, 2e-3);
      EXPECT_NEAR(light.energy.g / ((1e5 - 1) * disc(half_angle)), 1, 1e-6);  // texels are floats
      EXPECT_NEAR(light.share, light.energy.g / (light.energy.g + 4 * kPi), 1e-6);
      EXPECT_GT(split.range_before, 100);
      EXPECT_NEAR(split.range_after, 1, 1e-6);
      for (const Rgb& c : split.rest.radiance.values()) ASSERT_NEAR(c.b, 2, 1e-6);
      expect_balance(whole, split);
      ++suns;
    }
  }
  EXPECT_EQ(suns, 12);
}

TEST(SlowSplit, ASunSmallerThanTheTexelsHasABound) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  int suns = 0;
  for (; suns < 20; ++suns) {
    const Vec3 toward = normalize({normal(random), normal(random), normal(random)});
    const Environment whole = sun({Layout::kEquirect}, {512, 256}, {toward, 0.53, {1, 1, 1}, 1e6});
    const SplitEnvironment split = split_lights(whole);
    ASSERT_EQ(split.lights.size(), 1u);
    const SplitLight& light = split.lights[0];
    EXPECT_FALSE(light.resolved);
    EXPECT_GE(degrees(light.half_angle), 0.265 * (1 - 1e-6));
    // It lies on the corner of four texels at worst, each 0.7 degrees high; near the poles they are narrow.
    EXPECT_LE(degrees(light.half_angle), 0.9);
    EXPECT_LT(degrees(angle_between(light.direction, toward)), 0.7 * 0.75);
    EXPECT_NEAR(light.irradiance.g / ((1e6 - 1) * kPi * std::pow(std::sin(radians(0.265)), 2)), 1, 1e-3);
    expect_balance(whole, split);
  }
  EXPECT_EQ(suns, 20);
}

TEST(SlowSplit, EveryProjectionAcrossItsSeams) {
  // Cube edges and corners, octahedral folds, poles, rims.
  const std::vector<Vec3> directions = {
      normalize({1, 1, 0.02}),  normalize({1, -1, 1}), {-1, 0, 0}, normalize({-1, 0.03, 0.02}), {0, 0, 1},
      normalize({0.2, 0.1, -1})};
  int suns = 0;
  for (const Layout layout : all_layouts()) {
    for (const Vec3 toward : directions) {
      const Projection projection{layout};
      const ImageSize size = image_size(layout, layout == Layout::kEquirect ? 128 : 96);
      const Mapping mapping(projection, size);
      if (!mapping.position(toward) || !mapping.position(normalize(toward + Vec3{0, 0, -0.2}))) continue;
      const Environment whole = sun(projection, size, {toward, 8, {1, 1, 1}, 1e4});
      const SplitEnvironment split = split_lights(whole);
      ASSERT_EQ(split.lights.size(), 1u) << name_of(layout) << " " << toward.x << " " << toward.y << " " << toward.z;
      // Texels far out in a ball or a disc are wide: the direction is as good as they.
      EXPECT_LT(degrees(angle_between(split.lights[0].direction, toward)), 0.5 * texel_deg(whole)) << name_of(layout);
      EXPECT_NEAR(split.lights[0].energy.g / ((1e4 - 1) * disc(radians(4))), 1, 1e-4) << name_of(layout);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          const double shown = mapping.texel_direction(x, y) ? 1 : 0;
          ASSERT_NEAR(split.rest.radiance(x, y).g, shown, 1e-6) << name_of(layout);
        }
      }
      expect_balance(whole, split);
      ++suns;
    }
  }
  EXPECT_GE(suns, 13 * 6);  // a fisheye sees the upper half only
}

TEST(SlowSplit, PicturesWithoutSourcesComeBackAsTheyWere) {
  const Projection equirect{Layout::kEquirect};
  const std::vector<Environment> pictures = {sky(32),
                                             sky(32, {}),
                                             sky(32, {-1, -2, -3}),
                                             gradient(equirect, {64, 32}),
                                             checker(equirect, {128, 64}, 20),
                                             testcard(equirect, {128, 64}),
                                             furnace({Layout::kCubeCross}, image_size(Layout::kCubeCross, 8)),
                                             sky(1)};
  int compared = 0;
  for (const Environment& whole : pictures) {
    const SplitEnvironment split = split_lights(whole);
    EXPECT_TRUE(split.lights.empty());
    EXPECT_EQ(split.rest.radiance, whole.radiance);
    EXPECT_EQ(split.changed_texels, 0);
    EXPECT_EQ(split.balance.energy_difference(), 0);
    EXPECT_EQ(split.range_before, split.range_after);
    ++compared;
  }
  EXPECT_EQ(compared, 8);
  EXPECT_EQ(split_lights(sky(32, {})).range_after, 0);
}

/// Three lamps on a dim ceiling, the second the strongest.
Environment three_lamps() {
  Environment e = sky(256, {0.1f, 0.1f, 0.1f});
  add_disc(e, normalize({1, 0, 1}), radians(2), {100, 100, 100});
  add_disc(e, normalize({0, 1, 1}), radians(3), {100, 100, 100});
  add_disc(e, normalize({-1, 0, 1}), radians(1), {100, 100, 100});
  return e;
}

TEST(SlowSplit, TheStrongestFirstAndNoMoreThanAsked) {
  const Environment whole = three_lamps();
  const SplitEnvironment all = split_lights(whole);
  ASSERT_EQ(all.lights.size(), 3u);
  EXPECT_LT(degrees(angle_between(all.lights[0].direction, normalize({0, 1, 1}))), 0.05);
  EXPECT_LT(degrees(angle_between(all.lights[1].direction, normalize({1, 0, 1}))), 0.05);
  EXPECT_LT(degrees(angle_between(all.lights[2].direction, normalize({-1, 0, 1}))), 0.05);
  EXPECT_GT(all.lights[0].share, all.lights[1].share);
  expect_balance(whole, all);

  const SplitEnvironment two = split_lights(whole, {.max_lights = 2});
  EXPECT_EQ(two.lights.size(), 2u);
  EXPECT_EQ(two.sources, 3);
  const Texel third = Mapping(whole.projection, {512, 256}).nearest(normalize({-1, 0, 1}));
  EXPECT_EQ(two.rest.radiance(third.x, third.y), whole.radiance(third.x, third.y));
  expect_balance(whole, two);

  EXPECT_EQ(split_lights(whole, {.max_lights = 0}).rest.radiance, whole.radiance);
  const double smallest = all.lights[2].share;
  EXPECT_EQ(split_lights(whole, {.min_share = 0.99 * smallest}).lights.size(), 3u);
  EXPECT_EQ(split_lights(whole, {.min_share = 1.01 * smallest}).lights.size(), 2u);
  EXPECT_EQ(split_lights(whole, {.threshold = 200}).lights.size(), 3u);  // they are 1001 times as bright
  EXPECT_EQ(split_lights(whole, {.threshold = 1100}).lights.size(), 0u);
  EXPECT_EQ(split_lights(whole, {.max_size_sr = 1.2 * disc(radians(2))}).lights.size(), 2u);
}

TEST(SlowSplit, TwoPeaksAreTwoLightsWhereTheSaddleIsLow) {
  // Radii of 2 degrees, 5 apart, with a glow of `between` around both that is still a compact source.
  const Vec3 left = {1, 0, 0}, right = {std::cos(radians(5)), std::sin(radians(5)), 0};
  const Vec3 middle = normalize(left + right);
  const auto lights_with = [&](double between) {
    Environment e = sky(256, {0.01f, 0.01f, 0.01f});
    add_disc(e, middle, radians(6), between * RgbD{1, 1, 1});
    add_disc(e, left, radians(2), {100, 100, 100});
    add_disc(e, right, radians(2), {60, 60, 60});
    const SplitEnvironment split = split_lights(e);
    expect_balance(e, split);
    return split.lights;
  };
  const auto apart = lights_with(10);
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_LT(degrees(angle_between(apart[0].direction, left)), 1);
  EXPECT_LT(degrees(angle_between(apart[1].direction, right)), 1);
  EXPECT_EQ(lights_with(40).size(), 1u);  // 100 is less than four times the saddle
}

TEST(SlowSplit, AStripIsNoDisc) {
  // The mean of 1 - cos of the angle from its middle is half_length² / 6, and of the largest disc 0.06 / 4 pi: as long
  // as 9.7 degrees to each side.
  int strips = 0;
  for (const double half_length_deg : {6.0, 9.0, 11.0, 60.0}) {
    Environment whole = sky(256, {0.1f, 0.1f, 0.1f});
    const int from = static_cast<int>(256 - half_length_deg / 180 * 256), to = 512 - from;
    for (int y = 127; y < 129; ++y) {
      for (int x = from; x < to; ++x) whole.radiance(x, y) = {200, 200, 200};
    }
    const SplitEnvironment split = split_lights(whole);
    EXPECT_EQ(split.lights.size(), half_length_deg < 9.7 ? 1u : 0u) << half_length_deg;
    expect_balance(whole, split);
    ++strips;
  }
  EXPECT_EQ(strips, 4);
}

TEST(SlowSplit, ASunInABrightWindowLeavesTheWindow) {
  Environment whole = sky(256, {0.1f, 0.1f, 0.1f});
  const Vec3 toward = normalize({1, 1, 0.5});
  std::mt19937 random(3);
  std::uniform_real_distribution<float> noise(0.8f, 1.2f);
  add_disc(whole, toward, radians(20), {50, 50, 50});  // 0.38 steradians
  for (Rgb& c : whole.radiance.values()) c = noise(random) * c;
  add_disc(whole, toward, radians(2), {5000, 5000, 5000});
  const SplitEnvironment split = split_lights(whole);
  ASSERT_EQ(split.lights.size(), 1u);  // and not one for each grain of the noise
  EXPECT_LT(degrees(angle_between(split.lights[0].direction, toward)), 0.05);
  EXPECT_NEAR(split.lights[0].energy.g / (5000 * disc(radians(2))), 1, 2e-3);  // the noise under it
  const Texel t = Mapping(whole.projection, {512, 256}).nearest(toward);
  EXPECT_NEAR(split.rest.radiance(t.x, t.y).g, 50, 5);
  expect_balance(whole, split);
}

TEST(SlowSplit, TheSameBitsOnAnyNumberOfThreads) {
  const Environment whole = three_lamps();
  const SplitEnvironment one = split_lights(whole, {}, {.threads = 1});
  int compared = 0;
  for (const int threads : {2, 7}) {
    const SplitEnvironment other = split_lights(whole, {}, {.threads = threads});
    EXPECT_EQ(other.rest.radiance, one.rest.radiance);
    EXPECT_EQ(other.balance.whole.energy, one.balance.whole.energy);
    EXPECT_EQ(other.threshold_luminance, one.threshold_luminance);
    ASSERT_EQ(other.lights.size(), one.lights.size());
    for (std::size_t i = 0; i < one.lights.size(); ++i, ++compared) {
      EXPECT_EQ(other.lights[i].direction, one.lights[i].direction);
      EXPECT_EQ(other.lights[i].irradiance, one.lights[i].irradiance);
      EXPECT_EQ(other.lights[i].half_angle, one.lights[i].half_angle);
    }
  }
  EXPECT_EQ(compared, 6);
}

TEST(SlowSplit, BrightnessHasNoUnit) {
  const SplitEnvironment reference = split_lights(three_lamps());
  int compared = 0;
  for (const float scale : {1e-30f, 1e30f}) {
    Environment whole = three_lamps();
    for (Rgb& c : whole.radiance.values()) c = scale * c;
    const SplitEnvironment split = split_lights(whole);
    ASSERT_EQ(split.lights.size(), reference.lights.size());
    for (std::size_t i = 0; i < split.lights.size(); ++i, ++compared) {
      EXPECT_NEAR(split.lights[i].share, reference.lights[i].share, 1e-5);
      EXPECT_NEAR(split.lights[i].irradiance.g / (scale * reference.lights[i].irradiance.g), 1, 1e-5);
    }
  }
  EXPECT_EQ(compared, 6);
}

TEST(SlowSplit, TheSmallestPictures) {
  int pictures = 0;
  for (const Layout layout : all_layouts()) {
    for (const int size_px : {1, 2, 3, 4}) {
      if (layout == Layout::kDualFisheye && size_px == 1) continue;
      Environment whole = furnace({layout}, image_size(layout, size_px));
      whole.radiance(whole.radiance.width() / 2, whole.radiance.height() / 2) = {1e6f, 1e6f, 1e6f};
      const SplitEnvironment split = split_lights(whole);
      expect_balance(whole, split);
      for (const Rgb& c : split.rest.radiance.values()) ASSERT_TRUE(std::isfinite(c.r));
      for (const SplitLight& light : split.lights) ASSERT_TRUE(std::isfinite(light.half_angle + light.irradiance.r));
      ++pictures;
    }
  }
  EXPECT_EQ(pictures, 14 * 4 - 1);
}

ErrorKind kind_of(const Environment& e, const SplitOptions& options = {}, const Run& run = {}) {
  try {
    (void)split_lights(e, options, run);
  } catch (const Error& error) {
    EXPECT_FALSE(error.hint().empty() && error.kind() != ErrorKind::kCancelled) << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "accepted";
  return ErrorKind::kOutput;
}

TEST(SlowSplit, RefusesWhatItCannotSplit) {
  Environment nan = sky(8), infinite = sky(8);
  nan.radiance(3, 3).g = std::nanf("");
  infinite.radiance(3, 3).b = INFINITY;
  EXPECT_EQ(kind_of(nan), ErrorKind::kInput);
  EXPECT_EQ(kind_of(infinite), ErrorKind::kInput);
  EXPECT_EQ(kind_of({}), ErrorKind::kInput);
  EXPECT_EQ(kind_of({Image<Rgb>(7, 2), {Layout::kEquirect}}), ErrorKind::kInput);
  const double not_a_number = std::nan("");
  EXPECT_EQ(kind_of(sky(8), {.max_lights = -1}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of(sky(8), {.threshold = 0.5}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of(sky(8), {.threshold = not_a_number}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of(sky(8), {.min_share = 1.5}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of(sky(8), {.min_share = not_a_number}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of(sky(8), {.max_size_sr = 0}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of(sky(8), {.max_size_sr = not_a_number}), ErrorKind::kUsage);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(kind_of(sky(8), {}, {.stop = stop.get_token()}), ErrorKind::kCancelled);
}

}  // namespace
}  // namespace zonal
