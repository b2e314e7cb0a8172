#include "zonal/view/sky_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/light/fisheye_light.h"
#include "zonal/light/fisheye_published.h"
#include "zonal/light/resample.h"
#include "zonal/light/synthetic.h"

namespace zonal {
namespace {

constexpr int kPx = 12;
const std::vector<double> kShininess = {40, 1};

/// Brighter to one side, a lamp low over the horizon, a coloured ground.
Environment evening() {
  return paint({Layout::kEquirect}, image_size(Layout::kEquirect, 48), [](Vec3 d) {
    if (d.z < 0) return Rgb{0.3f, 0.2f, 0.1f};
    const auto slope = static_cast<float>(1 + 0.5 * d.x);
    return dot(d, normalize({0.5, -0.8, 0.3})) > 0.95 ? Rgb{9, 6, 3} : Rgb{slope, slope, 1.2f * slope};
  });
}

/// A map for a ground: the zenith's or the nadir's.
RgbD value_of(const SkyMaps& sky, int level, bool published, int x, int y, RgbD ground) {
  const int column = x % kPx, half = kPx / 2;
  const Rgb share =
      sky.shares(std::min(column, kPx - 1 - column) + (x < kPx ? 0 : half), std::min(y, kPx - 1 - y) + level * half);
  return RgbD(sky.maps(x, y + (2 * level + (published ? 0 : 1)) * kPx)) + (published ? share.r : share.g) * ground;
}

// For any ground the maps are those that the library makes for it.
TEST(SlowSkyMaps, AreLinearInTheGround) {
  const SkyMaps sky = sky_maps(evening(), kShininess, kPx);
  ASSERT_EQ(sky.maps.height(), 4 * kPx);
  ASSERT_EQ(sky.shares.height(), kPx);
  const Environment photograph = resample(evening(), {Layout::kFisheye}, sky_photograph_px(kPx));
  int compared = 0;
  for (const Rgb ground : {Rgb{0, 0, 0}, Rgb{2, 1, 0.5f}}) {
    const FisheyeLight light(photograph, ground, kShininess, FisheyeOutside::kTwo);
    for (int level = 0; level < 2; ++level) {
      const double s = kShininess[static_cast<std::size_t>(level)];
      const Image<Rgb> published = published_paraboloid(
          photograph, {.shininess = s, .ground = ground, .size_px = kPx, .outside = FisheyeOutside::kTwo});
      const Image<Rgb> corrected = light.paraboloid(level, kPx);
      double brightest = 0;
      for (const Rgb& value : corrected.values()) brightest = std::max<double>(brightest, max_channel(value));
      for (int y = 0; y < kPx; ++y) {
        for (int x = 0; x < 2 * kPx; ++x) {
          const RgbD first = value_of(sky, level, true, x, y, RgbD(ground)) - RgbD(published(x, y));
          const RgbD second = value_of(sky, level, false, x, y, RgbD(ground)) - RgbD(corrected(x, y));
          EXPECT_LT(std::abs(first.r) + std::abs(first.b), 2e-5) << level << " " << x << " " << y;
          // The photograph made a panorama and convolved, against sums over its pixels: the lamp is five of them wide.
          EXPECT_LT(std::abs(second.r) + std::abs(second.b), 0.05 * brightest) << level << " " << x << " " << y;
          ++compared;
        }
      }
    }
  }
  EXPECT_EQ(compared, 2 * 2 * kPx * 2 * kPx);
}

TEST(SlowSkyMaps, AConstantSkyOverAsBrightAGroundStaysConstant) {
  const SkyMaps sky = sky_maps(furnace({Layout::kEquirect}, {64, 32}, {2, 2, 2}), kShininess, kPx);
  EXPECT_NEAR(sky.sky_mean.g, 2, 1e-5);
  EXPECT_NEAR(sky.ground_mean.g, 2, 1e-5);
  for (const bool published : {true, false}) {
    for (int y = 0; y < kPx; ++y) {
      for (int x = 0; x < 2 * kPx; ++x) {
        for (const int level : {0, 1}) EXPECT_NEAR(value_of(sky, level, published, x, y, sky.ground_mean).g, 2, 0.005);
      }
    }
  }
}

TEST(SlowSkyMaps, MeansAreThoseOfTheHalves) {
  const Environment halves = paint({Layout::kEquirect}, {64, 32}, [](Vec3 d) {
    return d.z > 0 ? Rgb{static_cast<float>(d.z), 1, 0} : Rgb{0, 0, 3};
  });
  const SkyMaps sky = sky_maps(halves, {1}, kPx);
  EXPECT_NEAR(sky.sky_mean.r, 0.5, 1e-3);  // the mean of the height over the upper half
  EXPECT_NEAR(sky.sky_mean.g, 1, 1e-5);
  EXPECT_NEAR(sky.sky_mean.b, 0, 1e-5);
  EXPECT_NEAR(sky.ground_mean.b, 3, 1e-5);
}

TEST(SlowSkyMaps, RefuseWhatTheyCannotBe) {
  const Environment light = furnace({Layout::kEquirect}, {32, 16});
  EXPECT_THROW((void)sky_maps(light, {1}, 7), Error);
  EXPECT_THROW((void)sky_maps(light, {1}, 2), Error);
  EXPECT_THROW((void)sky_maps(light, {-1}, 8), Error);
}

}  // namespace
}  // namespace zonal
