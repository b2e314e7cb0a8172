#include "zonal/light/rearrange.h"

#include <gtest/gtest.h>

#include "zonal/light/orient.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

/// Texels that all differ.
Environment numbered(Layout layout, int size_px) {
  const ImageSize size = image_size(layout, size_px);
  Environment map{Image<Rgb>(size.width, size.height), {layout}};
  float next = 1;
  for (Rgb& texel : map.radiance.values()) texel = {next, -next, 2 * next}, next += 1;
  return map;
}

TEST(Rearrange, EveryTexelShowsWhatTheSourceShowsThere) {
  const Environment source = numbered(Layout::kCubeStack, 5);
  const Mapping from(source.projection, {5, 30});
  const Rotation mirror = {{Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}}};
  int compared = 0;
  for (const Layout layout : {Layout::kCubeStack, Layout::kCubeRow, Layout::kCubeCross, Layout::kCubeCrossVertical}) {
    const ImageSize size = image_size(layout, 5);
    const std::optional<Environment> result = rearranged(source, {layout}, size, mirror);
    ASSERT_TRUE(result.has_value());
    const Mapping to({layout}, size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto toward = to.texel_direction(x, y);
        if (!toward) continue;
        const Texel there = from.nearest(transpose(mirror) * *toward);
        EXPECT_EQ(result->radiance(x, y), source.radiance(there.x, there.y));
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 4 * 150);
}

TEST(Rearrange, YawOfWholeTexelsRollsAPanorama) {
  const Environment source = numbered(Layout::kEquirect, 4);
  const std::optional<Environment> result = rearranged(source, source.projection, {8, 4}, turned(45));
  ASSERT_TRUE(result.has_value());
  // To the left, so the texel that was in column 1 is in column 0.
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) EXPECT_EQ(result->radiance(x, y), source.radiance((x + 1) % 8, y));
  }
}

TEST(Rearrange, RefusesWhatWouldNeedNewValues) {
  const Environment panorama = numbered(Layout::kEquirect, 4);
  EXPECT_FALSE(rearranged(panorama, panorama.projection, {8, 4}, turned(10)));
  EXPECT_FALSE(rearranged(panorama, panorama.projection, {8, 4}, turned(0, 45)));
  EXPECT_FALSE(rearranged(panorama, {Layout::kCubeRow}, {24, 4}));
  EXPECT_FALSE(rearranged(numbered(Layout::kCubeRow, 4), {Layout::kCubeRow}, {12, 2}));
}

}  // namespace
}  // namespace zonal
