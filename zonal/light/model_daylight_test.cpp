#include "zonal/light/model_daylight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/light/project.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

TEST(SlowModelDaylight, AgreesWithAFinePicture) {
  int compared = 0;
  for (const double elevation : {8.0, 60.0}) {
    const DaylightOptions options = {.elevation_deg = elevation, .azimuth_deg = 130, .turbidity = 4};
    const Environment picture = daylight_sky({}, {4096, 2048}, options);
    const Sh<RgbD> expected = project(picture, 6), actual = daylight_sh(options, 6);
    for (std::size_t i = 0; i < expected.size(); ++i, ++compared) {
      // The fine picture's own 1e-5; and the sun's centre in the picture is off by a part of a texel of 1.5e-3 radians.
      EXPECT_NEAR(actual[i].g, expected[i].g, 3e-4 * expected[0].g) << elevation << " " << i;
      EXPECT_NEAR(actual[i].b, expected[i].b, 3e-4 * expected[0].b) << elevation << " " << i;
    }
    // The brightest texels lie within the disc: radiance = the sun's irradiance over its solid angle tells its size.
    DaylightOptions no_sun = options;
    no_sun.sun = false;
    const Environment sky = daylight_sky({}, {4096, 2048}, no_sun);
    const Mapping mapping({}, {4096, 2048});
    double disc = 0, brightest = 0;
    for (int y = 0; y < 1024; ++y) {
      for (int x = 0; x < 4096; ++x) {
        const double sun = static_cast<double>(picture.radiance(x, y).g) - sky.radiance(x, y).g;
        disc += mapping.solid_angle(x, y) * sun;
        brightest = std::max(brightest, sun);
      }
    }
    // add_disc scales texels at the rim alone.
    EXPECT_NEAR(degrees(2 * std::sqrt(disc / brightest / kPi)), 0.533, 1e-4) << elevation;
  }
  EXPECT_EQ(compared, 2 * 36);
}

TEST(SlowModelDaylight, TheSkyIsResolved) {
  const DaylightOptions options = {.elevation_deg = 20, .turbidity = 2, .ground_albedo = {}, .sun = false};
  const Sh<RgbD> fine = project(daylight_sky({}, {4096, 2048}, options), 64), used = daylight_sh(options, 64);
  int compared = 0;
  // The fine picture's own midpoint error is 1e-5.
  for (std::size_t i = 0; i < fine.size(); ++i, ++compared) EXPECT_NEAR(used[i].g, fine[i].g, 2e-5 * fine[0].g) << i;
  EXPECT_EQ(compared, 4096);
}

TEST(ModelDaylight, TheGroundIsLitByWhatStandsAboveIt) {
  const DaylightOptions options = {.elevation_deg = 40, .ground_albedo = {1, 0.5f, 0}};
  const Sh<RgbD> light = daylight_sh(options, 40);
  DaylightOptions black = options;
  black.ground_albedo = {};
  const Sh<RgbD> above = daylight_sh(black, 40);
  // A level surface over black ground receives E; white ground reflects E/pi. 40 bands hold E to 40^-3/2 of the sun's.
  const RgbD lit = evaluate(irradiance(above), {0, 0, 1});
  const Sh<RgbD> ground = light - above;
  const double half_in_l0 = std::sqrt(kPi);
  EXPECT_NEAR(ground(0, 0).r / half_in_l0 * kPi / lit.r, 1, 0.01);
  EXPECT_NEAR(ground(0, 0).g / half_in_l0 * kPi / lit.g, 0.5, 0.005);
  EXPECT_EQ(ground(0, 0).b, 0);
}

TEST(ModelDaylight, TurnsWithTheAzimuth) {
  const Sh<RgbD> east = daylight_sh({.elevation_deg = 30}, 3),
                 north = daylight_sh({.elevation_deg = 30, .azimuth_deg = 90}, 3);
  // +X toward +Y: the coefficient of x becomes that of y. The picture's columns repeat after a quarter turn; floats are
  // kept in it.
  EXPECT_NEAR(north(1, -1).r, east(1, 1).r, 1e-6 * east(0, 0).r);
  EXPECT_NEAR(north(1, 1).r, -east(1, -1).r, 1e-6 * east(0, 0).r);
  EXPECT_NEAR(north(2, 2).r, -east(2, 2).r, 1e-6 * east(0, 0).r);
  EXPECT_NEAR(north(2, 0).r, east(2, 0).r, 1e-6 * east(0, 0).r);
  EXPECT_GT(east(1, 1).r, 0.1 * east(0, 0).r);
}

TEST(ModelDaylight, RefusesNightAndNonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(daylight_sh({.elevation_deg = -1}, 3), Error);
  EXPECT_THROW(daylight_sh({.turbidity = 1}, 3), Error);
  EXPECT_THROW(daylight_sh({.turbidity = nan}, 3), Error);
  EXPECT_THROW(daylight_sh({.azimuth_deg = nan}, 3), Error);
  EXPECT_THROW(clear_sky_sh({.azimuth_deg = nan}, 3, 64), Error);
  EXPECT_THROW(clear_sky_sh({}, 3, 5), std::logic_error);
  EXPECT_THROW(daylight_sh({}, 0), std::logic_error);
}

}  // namespace
}  // namespace zonal
