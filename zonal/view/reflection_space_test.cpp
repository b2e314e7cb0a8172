#include "zonal/view/reflection_space.h"

#include <gtest/gtest.h>

#include <cmath>

#include "zonal/base/error.h"
#include "zonal/light/brdf.h"
#include "zonal/light/lobe.h"
#include "zonal/light/lobe_lean.h"
#include "zonal/light/synthetic.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr ReflectionSpaceOptions kSmall = {
    .roughnesses = {0.3, 0.5, 0.6, 1}, .views = 3, .map_px = 7, .environment_rows = 16};

Environment two_lamps() {
  return paint({Layout::kEquirect}, image_size(Layout::kEquirect, 16), [](Vec3 d) {
    return dot(d, normalize({0.5, 0.6, 0.4})) > 0.8 ? Rgb{5, 1, 0}
           : dot(d, {0, -1, 0}) > 0.9               ? Rgb{0, 1, 8}
                                                    : Rgb{0.1f, 0.1f, 0.1f};
  });
}

constexpr int kSide = 21, kLayers = 4;

TEST(ReflectionSpace, ChangesNothingOfAConstantSky) {
  const Image<Rgb> maps = reflection_space_maps(furnace({Layout::kEquirect}, {32, 16}, {2, 3, 4}), kSmall);
  ASSERT_EQ(maps.width(), kSide);
  ASSERT_EQ(maps.height(), kLayers * kSide);
  for (const Rgb& value : maps.values()) {
    EXPECT_NEAR(value.r, 1, 1e-5);
    EXPECT_NEAR(value.g, 1, 1e-5);
    EXPECT_NEAR(value.b, 1, 1e-5);
  }
}

/// The mean of the light through the library's BRDF.
RgbD mean_through(const Brdf& brdf, const Environment& light, Vec3 n, Vec3 v) {
  const Mapping panorama(light.projection, {light.radiance.width(), light.radiance.height()});
  const Vec3 beside = v - dot(v, n) * n;
  const Vec3 x = length(beside) > 1e-6 ? normalize(beside) : normalize(cross(n, {0.3, 0.5, 0.8})), y = cross(n, x);
  RgbD sum, white;
  for (int j = 0; j < light.radiance.height(); ++j) {
    for (int i = 0; i < light.radiance.width(); ++i) {
      const Vec3 d = *panorama.texel_direction(i, j), l = {dot(d, x), dot(d, y), dot(d, n)};
      if (l.z <= 0) continue;
      const RgbD weight = l.z * panorama.solid_angle(i, j) * brdf(l, {dot(v, x), 0, dot(v, n)});
      sum += weight * RgbD(light.radiance(i, j));
      white += weight;
    }
  }
  return {sum.r / white.r, sum.g / white.g, sum.b / white.b};
}

// Each texel is the light through the lobe that an eye sees, over that through the lobe of an eye above the surface.
TEST(ReflectionSpace, IsTheSurfacesOwnLobeOverTheSplitSums) {
  const Environment light = two_lamps();
  const Mapping square({Layout::kOctahedral}, {1, 1});
  const Image<Rgb> maps = reflection_space_maps(light, kSmall);
  int compared = 0;
  for (int layer = 0; layer < kLayers; ++layer) {
    const double alpha = alpha_from_roughness(kSmall.roughnesses[static_cast<std::size_t>(layer)]);
    const Brdf brdf = ggx_brdf(alpha);
    const LobeLean lean(alpha);
    for (int row = 0; row < kSide; row += 2) {
      for (int column = 0; column < kSide; ++column) {
        const Vec3 v = *square.direction({column / 7 / 2.0, row / 7 / 2.0});
        const Vec3 m = *square.direction({column % 7 / 6.0, row % 7 / 6.0}), n = lean.normal(v, m);
        if (angle_between(v, n) > 1.4) continue;  // where the eye grazes, texels are too large for the lobe
        const RgbD seen = mean_through(brdf, light, n, v), above = mean_through(brdf, light, m, m);
        const Rgb texel = maps(column, layer * kSide + row);
        EXPECT_NEAR(texel.r, seen.r / above.r, 2e-3 * seen.r / above.r) << column << " " << row << " " << layer;
        EXPECT_NEAR(texel.b, seen.b / above.b, 2e-3 * seen.b / above.b) << column << " " << row << " " << layer;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 500);
}

// The edges of both squares are folded: the same directions are there twice, -Z in all corners.
TEST(ReflectionSpace, FoldsItsEdges) {
  const Image<Rgb> maps = reflection_space_maps(two_lamps(), kSmall);
  for (int layer = 0; layer < kLayers; ++layer) {
    const auto at = [&](int i, int j, int x, int y) { return maps(7 * i + x, layer * kSide + 7 * j + y); };
    for (int k = 0; k < 7; ++k) {
      EXPECT_EQ(at(1, 1, 0, k), at(1, 1, 0, 6 - k));
      EXPECT_EQ(at(1, 1, k, 6), at(1, 1, 6 - k, 6));
      EXPECT_EQ(at(0, 0, k, 2), at(2, 2, k, 2));
    }
    EXPECT_EQ(at(1, 0, 0, 0), at(1, 0, 6, 6));
    EXPECT_FALSE(at(1, 0, 2, 3) == at(1, 0, 4, 3));
  }
}

TEST(ReflectionSpace, ALeanIsBetweenTheMirroredDirectionAndTheNormal) {
  const Image<Rgb> leans = lean_picture();
  const LobeLean half(alpha_from_roughness(0.5));
  int compared = 0;
  for (int x = 0; x < leans.width(); ++x) {
    const double theta = std::acos(x / (leans.width() - 1.0));
    EXPECT_NEAR(leans(x, (leans.height() - 1) / 2).r, half.lean(theta), 1e-6);
    EXPECT_LT(leans(x, 0).r, 0.02);
    EXPECT_LE(leans(x, leans.height() - 1).r, theta + 1e-6);
    ++compared;
  }
  EXPECT_EQ(compared, 64);
}

TEST(ReflectionSpace, RefusesWhatItCannotBe) {
  const Environment light = furnace({Layout::kEquirect}, {32, 16});
  EXPECT_THROW((void)reflection_space_maps(light, {.roughnesses = {0.1, 0.5, 0.7, 1}}), Error);
  EXPECT_THROW((void)reflection_space_maps(light, {.roughnesses = {0.3, 0.7, 0.7, 1}}), Error);
  EXPECT_THROW((void)reflection_space_maps(light, {.views = 1}), Error);
  EXPECT_THROW((void)reflection_space_maps(light, {.map_px = 1}), Error);
}

}  // namespace
}  // namespace zonal
