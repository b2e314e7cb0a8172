// Lights plus rest shade like the whole: on matte surfaces facing everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "zonal/light/model.h"
#include "zonal/light/reference.h"
#include "zonal/light/split.h"
#include "zonal/light/split_test.h"

namespace zonal {
namespace {

/// Directions spread evenly (Gonzalez 2010).
std::vector<Vec3> directions(int count) {
  std::vector<Vec3> spread;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, azimuth = i * kPi * (3 - std::sqrt(5.0));
    spread.push_back({std::sqrt(1 - z * z) * std::cos(azimuth), std::sqrt(1 - z * z) * std::sin(azimuth), z});
  }
  return spread;
}

/// The largest difference of the irradiance by discs and rest from that by the whole, in any channel, over the greatest
/// irradiance in that channel.
double worst_shading_error(const Environment& whole, const SplitEnvironment& split) {
  const std::vector<Vec3> normals = directions(150);
  const std::vector<RgbD> expected = convolve_at(whole, Lobe::cosine(), normals);  // E / pi
  const std::vector<RgbD> rest = convolve_at(split.rest, Lobe::cosine(), normals);
  RgbD most, worst;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    RgbD irradiance = kPi * rest[i];
    for (const SplitLight& light : split.lights) {
      const double facing = cone_irradiance(light.half_angle, 0);
      const double seen = cone_irradiance(light.half_angle, angle_between(normals[i], light.direction));
      irradiance += (seen / facing) * light.irradiance;
    }
    const RgbD e = kPi * expected[i], off = irradiance - e;
    most = {std::max(most.r, e.r), std::max(most.g, e.g), std::max(most.b, e.b)};
    worst = {std::max(worst.r, std::abs(off.r)), std::max(worst.g, std::abs(off.g)),
             std::max(worst.b, std::abs(off.b))};
  }
  return max_channel(RgbD{worst.r / most.r, worst.g / most.g, worst.b / most.b});
}

TEST(SlowSplitShading, LightsAndRestShadeLikeTheWhole) {
  int suns = 0;
  for (const double diameter : {0.53, 3.0, 10.0}) {
    const Environment whole =
        sun({Layout::kEquirect}, {512, 256}, {normalize({0.5, -0.7, 0.4}), diameter, {1, 2, 4}, 1e5});
    const SplitEnvironment split = split_lights(whole);
    ASSERT_EQ(split.lights.size(), 1u);
    // Only where a surface's horizon crosses the source do they differ: the whole is a few points up to half a texel
    // from their centre, 0.006 here, and no kink of the cosine is missed by more than a quarter of that.
    EXPECT_LT(worst_shading_error(whole, split), 0.006 / 4) << diameter;
    ++suns;
  }
  EXPECT_EQ(suns, 3);
}

TEST(SlowSplitShading, ADaylightSkyAndItsSun) {
  const DaylightOptions sky_options{.elevation_deg = 30, .azimuth_deg = 50, .turbidity = 3, .sun = false};
  DaylightOptions sun_options = sky_options;
  sun_options.sun = true;
  const Projection equirect{Layout::kEquirect};
  const Environment without = daylight_sky(equirect, {512, 256}, sky_options);
  const Environment whole = daylight_sky(equirect, {512, 256}, sun_options);
  const SplitEnvironment split = split_lights(whole);
  ASSERT_EQ(split.lights.size(), 1u);
  const Vec3 toward = {std::cos(radians(30)) * std::cos(radians(50)), std::cos(radians(30)) * std::sin(radians(50)),
                       0.5};
  EXPECT_LT(degrees(angle_between(split.lights[0].direction, toward)), 0.35);  // half a texel: the sun is smaller
  // What the sun adds around itself; it lights the ground too. The sky under it is fainter by five digits.
  const Mapping mapping(equirect, {512, 256});
  double added = 0;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 512; ++x) {
      if (angle_between(*mapping.texel_direction(x, y), toward) > radians(3)) continue;
      added += mapping.solid_angle(x, y) * (double{whole.radiance(x, y).g} - double{without.radiance(x, y).g});
    }
  }
  EXPECT_NEAR(split.lights[0].energy.g / added, 1, 1e-3);
  EXPECT_LT(worst_shading_error(whole, split), 0.006 / 4);
  expect_balance(whole, split);
}

}  // namespace
}  // namespace zonal
