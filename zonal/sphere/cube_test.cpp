#include "zonal/sphere/cube.h"

#include <gtest/gtest.h>

#include "zonal/sphere/every_projection.h"

namespace zonal {
namespace {

TEST(Cube, FaceTableIsTheSamplers) {
  // The table of the OpenGL and Direct3D specifications at (u, v) = (¼, ½), written out once more by hand.
  const double u = 0.25, v = 0.5;
  const Vec3 expected[] = {{1, -v, -u}, {-1, -v, u}, {u, 1, v}, {u, -1, -v}, {u, -v, 1}, {-u, -v, -1}};
  for (int face = 0; face < 6; ++face) {
    EXPECT_EQ(sampler_direction({face, u, v}), expected[face]) << face;
    const FacePoint back = face_point(expected[face]);
    EXPECT_EQ(back.face, face);
    EXPECT_EQ(back.u, u);
    EXPECT_EQ(back.v, v);
  }
}

TEST(Cube, SamplerFrameIsTheMirroredWorld) {
  EXPECT_EQ(sampler_from_world({1, 0, 0}), (Vec3{0, 0, 1}));   // the panorama's centre is face +Z
  EXPECT_EQ(sampler_from_world({0, -1, 0}), (Vec3{1, 0, 0}));  // its right is +X
  EXPECT_EQ(sampler_from_world({0, 0, 1}), (Vec3{0, 1, 0}));   // up is +Y
  Spread spread;
  for (int i = 0; i < 10; ++i) {
    const Vec3 d = spread.direction();
    EXPECT_EQ(world_from_sampler(sampler_from_world(d)), d);
  }
  const Vec3 x = sampler_from_world({1, 0, 0}), y = sampler_from_world({0, 1, 0}), z = sampler_from_world({0, 0, 1});
  EXPECT_EQ(dot(x, cross(y, z)), -1);  // left-handed
}

/// The faces' centres, in natural units, in the order +X -X +Y -Y +Z -Z.
TEST(Cube, LayoutsPutTheFacesWhereTheyBelong) {
  struct Row {
    Layout layout;
    PixelPoint centers[6];
  };
  const Row rows[] = {
      {Layout::kCubeStack, {{0.5, 0.5}, {0.5, 1.5}, {0.5, 2.5}, {0.5, 3.5}, {0.5, 4.5}, {0.5, 5.5}}},
      {Layout::kCubeRow, {{0.5, 0.5}, {1.5, 0.5}, {2.5, 0.5}, {3.5, 0.5}, {4.5, 0.5}, {5.5, 0.5}}},
      {Layout::kCubeCross, {{2.5, 1.5}, {0.5, 1.5}, {1.5, 0.5}, {1.5, 2.5}, {1.5, 1.5}, {3.5, 1.5}}},
      {Layout::kCubeCrossVertical, {{2.5, 1.5}, {0.5, 1.5}, {1.5, 0.5}, {1.5, 2.5}, {1.5, 1.5}, {1.5, 3.5}}},
      {Layout::kCubeCrossVerticalUnrotated, {{2.5, 1.5}, {0.5, 1.5}, {1.5, 0.5}, {1.5, 2.5}, {1.5, 1.5}, {1.5, 3.5}}},
  };
  const Vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const int n = 32;
  int checked = 0;
  for (const Row& row : rows) {
    const Mapping mapping({row.layout}, image_size(row.layout, n));
    for (int face = 0; face < 6; ++face) {
      const PixelPoint p{n * row.centers[face].x, n * row.centers[face].y};
      EXPECT_LT(angle_between(*mapping.direction(p), world_from_sampler(axes[face])), 1e-15) << name_of(row.layout);
      EXPECT_EQ(mapping.chart(p), face);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 30);
}

/// Along a border of a cross where two faces touch in the picture, the picture goes on without a jump.
TEST(Cube, CrossesAreContinuous) {
  struct Border {
    Layout layout;
    double x, y;    // a border's middle, in natural units
    bool vertical;  // the border runs from top to bottom
    bool joined;
  };
  const Border borders[] = {
      {Layout::kCubeCross, 1, 1.5, true, true},
      {Layout::kCubeCross, 2, 1.5, true, true},
      {Layout::kCubeCross, 3, 1.5, true, true},
      {Layout::kCubeCross, 1.5, 1, false, true},
      {Layout::kCubeCross, 1.5, 2, false, true},
      {Layout::kCubeCrossVertical, 1.5, 1, false, true},
      {Layout::kCubeCrossVertical, 1.5, 2, false, true},
      {Layout::kCubeCrossVertical, 1.5, 3, false, true},
      {Layout::kCubeCrossVerticalUnrotated, 1.5, 3, false, false},
  };
  const int n = 64;
  int checked = 0;
  for (const Border& border : borders) {
    const Mapping mapping({border.layout}, image_size(border.layout, n));
    for (double along = -0.45; along < 0.46; along += 0.05) {
      const double step = 1e-6;
      const double x = n * (border.x + (border.vertical ? 0 : along)),
                   y = n * (border.y + (border.vertical ? along : 0));
      const double dx = border.vertical ? step : 0, dy = border.vertical ? 0 : step;
      const double jump = angle_between(*mapping.direction({x - dx, y - dy}), *mapping.direction({x + dx, y + dy}));
      EXPECT_EQ(jump < 1e-6, border.joined) << name_of(border.layout) << " " << border.x << ", " << border.y;
      ++checked;
    }
  }
  EXPECT_GT(checked, 150);
}

TEST(Cube, GapsOfACrossShowNothing) {
  const int n = 8;
  const Mapping cross({Layout::kCubeCross}, {4 * n, 3 * n});
  int gaps = 0;
  for (int y = 0; y < 3 * n; ++y) {
    for (int x = 0; x < 4 * n; ++x) {
      if (cross.direction({x + 0.5, y + 0.5})) continue;
      EXPECT_EQ(cross.solid_angle(x, y), 0);
      EXPECT_FALSE(cross.texel_direction(x, y));
      ++gaps;
    }
  }
  EXPECT_EQ(gaps, 6 * n * n);
}

TEST(Cube, TheFourthTexelAtACornerRepeatsANeighbour) {
  const int n = 4;
  const Mapping mapping({Layout::kCubeStack}, {n, 6 * n});
  int checked = 0;
  for (int face = 0; face < 6; ++face) {
    for (int corner = 0; corner < 4; ++corner) {
      const int x = corner % 2 ? n - 1 : 0, y = (corner / 2 ? n - 1 : 0) + face * n;
      const int dx = corner % 2 ? 1 : -1, dy = corner / 2 ? 1 : -1;
      const Texel diagonal = mapping.wrap(face, x + dx, y + dy);
      EXPECT_TRUE(diagonal == mapping.wrap(face, x + dx, y) || diagonal == mapping.wrap(face, x, y + dy));
      ++checked;
    }
  }
  EXPECT_EQ(checked, 24);
}

}  // namespace
}  // namespace zonal
