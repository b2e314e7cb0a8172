#include "zonal/view/view_pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zonal {
namespace {

TEST(ViewPictures, HalvingsKeepTheMean) {
  Image<Rgb> picture(8, 4);
  float next = 0;
  for (Rgb& value : picture.values()) value = {next++, 1, 0};
  const auto levels = halved_pictures(picture);
  ASSERT_EQ(levels.size(), 4u);
  EXPECT_EQ(levels[1].width(), 4);
  EXPECT_EQ(levels[2].height(), 1);
  EXPECT_EQ(levels[3].width(), 1);
  EXPECT_FLOAT_EQ(levels[1](0, 0).r, (0 + 1 + 8 + 9) / 4.0f);
  EXPECT_FLOAT_EQ(levels[3](0, 0).r, 15.5f);
}

// The slope of the heights, by differences over the tile that repeats, is that of the normals.
TEST(ViewPictures, BumpHeightsAndNormalsAreTheSameSurface) {
  constexpr int kPx = 256;
  const Image<Rgb> bumps = bump_picture(kPx);
  int compared = 0;
  for (int y = 0; y < kPx; y += 5) {
    for (int x = 0; x < kPx; x += 5) {
      const auto height = [&](int i, int j) { return bumps((x + i + kPx) % kPx, (y + j + kPx) % kPx).b; };
      const double per_width = kBumpHeight * kPx / 2;
      const double slope_u = per_width * (height(1, 0) - height(-1, 0)),
                   slope_v = per_width * (height(0, 1) - height(0, -1));
      const Vec3 n = normalize(Vec3{-slope_u, -slope_v, 1});
      EXPECT_NEAR(2 * bumps(x, y).r - 1, n.x, 1e-3);
      EXPECT_NEAR(2 * bumps(x, y).g - 1, n.y, 1e-3);
      EXPECT_TRUE(height(0, 0) >= 0 && height(0, 0) <= 1);
      ++compared;
    }
  }
  EXPECT_GT(compared, 2500);
}

TEST(ViewPictures, HighlightsAreOnTheBallAndAtTheirPlace) {
  constexpr int kPx = 64;
  const Image<Rgb> computed = highlight_picture(kPx, {1, 2, 4}), drawn = drawn_highlight(kPx, {1, 2, 4});
  double left_top = 0, total = 0;
  for (int y = 0; y < kPx; ++y) {
    for (int x = 0; x < kPx; ++x) {
      const double nx = 2 * (x + 0.5) / kPx - 1, ny = 1 - 2 * (y + 0.5) / kPx;
      if (nx * nx + ny * ny >= 1) {
        EXPECT_EQ(computed(x, y), Rgb());
        EXPECT_EQ(drawn(x, y), Rgb());
      }
      EXPECT_FLOAT_EQ(drawn(x, y).b, 4 * drawn(x, y).r);
      total += computed(x, y).r + drawn(x, y).r;
      if (nx < 0 && ny > 0) left_top += computed(x, y).r + drawn(x, y).r;
    }
  }
  EXPECT_GT(total, 100);
  EXPECT_GT(left_top, 0.8 * total);
}

}  // namespace
}  // namespace zonal
