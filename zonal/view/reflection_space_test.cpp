#include "zonal/view/reflection_space.h"

#include <gtest/gtest.h>

#include <cmath>

#include "zonal/base/error.h"
#include "zonal/light/brdf.h"
#include "zonal/light/lobe.h"
#include "zonal/light/synthetic.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr ReflectionSpaceOptions kSmall = {.roughness = 0.6, .views = 3, .map_px = 7, .environment_rows = 16};

Environment two_lamps() {
  return paint({Layout::kEquirect}, image_size(Layout::kEquirect, 16), [](Vec3 d) {
    return dot(d, normalize({0.5, 0.6, 0.4})) > 0.8 ? Rgb{5, 1, 0}
           : dot(d, {0, -1, 0}) > 0.9               ? Rgb{0, 1, 8}
                                                    : Rgb{0.1f, 0.1f, 0.1f};
  });
}

TEST(ReflectionSpace, KeepsAConstantSky) {
  const Image<Rgb> maps = reflection_space_maps(furnace({Layout::kEquirect}, {32, 16}, {2, 3, 4}), kSmall);
  ASSERT_EQ(maps.width(), 21);
  for (const Rgb& value : maps.values()) {
    EXPECT_NEAR(value.r, 2, 1e-5);
    EXPECT_NEAR(value.g, 3, 1e-5);
    EXPECT_NEAR(value.b, 4, 1e-5);
  }
}

// Each texel is the mean of the light through the BRDF of the library, where the eye does not graze.
TEST(ReflectionSpace, IsTheMeanThroughTheSurfacesOwnLobe) {
  const Environment light = two_lamps();
  const Mapping panorama(light.projection, {32, 16}), square({Layout::kOctahedral}, {1, 1});
  const Image<Rgb> maps = reflection_space_maps(light, kSmall);
  const Brdf brdf = ggx_brdf(alpha_from_roughness(kSmall.roughness));
  int compared = 0;
  for (int row = 0; row < 21; ++row) {
    for (int column = 0; column < 21; ++column) {
      const Vec3 v = *square.direction({column / 7 / 2.0, row / 7 / 2.0});
      const Vec3 r = *square.direction({column % 7 / 6.0, row % 7 / 6.0});
      if (length(v + r) < 0.2) continue;
      const Vec3 n = normalize(v + r);
      const Vec3 beside = v - dot(v, n) * n;
      const Vec3 x = length(beside) > 1e-6 ? normalize(beside) : normalize(cross(n, {0.3, 0.5, 0.8})), y = cross(n, x);
      RgbD sum, white;
      for (int j = 0; j < 16; ++j) {
        for (int i = 0; i < 32; ++i) {
          const Vec3 d = *panorama.texel_direction(i, j), l = {dot(d, x), dot(d, y), dot(d, n)};
          if (l.z <= 0) continue;
          const RgbD weight = l.z * panorama.solid_angle(i, j) * brdf(l, {dot(v, x), 0, dot(v, n)});
          sum += weight * RgbD(light.radiance(i, j));
          white += weight;
        }
      }
      EXPECT_NEAR(maps(column, row).r, sum.r / white.r, 1e-3) << column << " " << row;
      EXPECT_NEAR(maps(column, row).b, sum.b / white.b, 1e-3) << column << " " << row;
      ++compared;
    }
  }
  EXPECT_GT(compared, 400);
}

// The edges of both squares are folded: the same directions are there twice, -Z in all corners.
TEST(ReflectionSpace, FoldsItsEdges) {
  const Image<Rgb> maps = reflection_space_maps(two_lamps(), kSmall);
  const auto at = [&](int i, int j, int x, int y) { return maps(7 * i + x, 7 * j + y); };
  for (int k = 0; k < 7; ++k) {
    EXPECT_EQ(at(1, 1, 0, k), at(1, 1, 0, 6 - k));
    EXPECT_EQ(at(1, 1, k, 6), at(1, 1, 6 - k, 6));
    EXPECT_EQ(at(0, 0, k, 2), at(2, 2, k, 2));
  }
  EXPECT_EQ(at(1, 0, 0, 0), at(1, 0, 6, 6));
  EXPECT_FALSE(at(1, 1, 2, 3) == at(1, 1, 4, 3));
}

TEST(ReflectionSpace, RefusesWhatItCannotBe) {
  const Environment light = furnace({Layout::kEquirect}, {32, 16});
  EXPECT_THROW((void)reflection_space_maps(light, {.roughness = 0.1}), Error);
  EXPECT_THROW((void)reflection_space_maps(light, {.views = 1}), Error);
  EXPECT_THROW((void)reflection_space_maps(light, {.map_px = 1}), Error);
}

}  // namespace
}  // namespace zonal
