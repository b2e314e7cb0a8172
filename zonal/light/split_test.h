#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "zonal/light/split.h"
#include "zonal/light/synthetic.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

inline constexpr double kRounding = 1e-11;  // sums of a hundred thousand terms in another order

inline Environment sky(int rows, Rgb radiance = {1, 1, 1}) {
  return furnace({Layout::kEquirect}, image_size(Layout::kEquirect, rows), radiance);
}

inline double disc(double half_angle) { return 2 * kPi * (1 - std::cos(half_angle)); }

/// The sums of split.h again, texel by texel.
inline SphereSum summed(const Environment& e) {
  const Mapping mapping(e.projection, {e.radiance.width(), e.radiance.height()});
  SphereSum sum;
  for (int y = 0; y < e.radiance.height(); ++y) {
    for (int x = 0; x < e.radiance.width(); ++x) {
      const auto toward = mapping.texel_direction(x, y);
      if (!toward) continue;
      const RgbD part = mapping.solid_angle(x, y) * RgbD(e.radiance(x, y));
      sum.energy += part;
      sum.vector[0] += part.r * *toward;
      sum.vector[1] += part.g * *toward;
      sum.vector[2] += part.b * *toward;
    }
  }
  return sum;
}

/// Lights and rest add up to the whole, and the report says so truly.
inline void expect_balance(const Environment& whole, const SplitEnvironment& split) {
  EXPECT_LE(split.balance.energy_difference(), kRounding);
  EXPECT_LE(split.balance.vector_difference(), kRounding);
  const SphereSum before = summed(whole), after = summed(split.rest);
  RgbD lights;
  Vec3 vector = luminance(RgbD(1, 0, 0)) * (before.vector[0] - after.vector[0]) +
                luminance(RgbD(0, 1, 0)) * (before.vector[1] - after.vector[1]) +
                luminance(RgbD(0, 0, 1)) * (before.vector[2] - after.vector[2]);
  for (const SplitLight& light : split.lights) {
    lights += light.energy;
    vector = vector - luminance(light.irradiance) * light.direction;
  }
  const double scale = luminance(before.energy);
  EXPECT_LE(length(vector), kRounding * scale);
  const RgbD left = before.energy - after.energy - lights;
  for (const double channel : {left.r, left.g, left.b}) EXPECT_LE(std::abs(channel), kRounding * scale);
  EXPECT_NEAR(split.balance.whole.energy.g, before.energy.g, kRounding * scale);
  EXPECT_NEAR(split.balance.rest.energy.g, after.energy.g, kRounding * scale);
}

}  // namespace zonal
