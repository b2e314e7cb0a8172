#include "zonal/sphere/mapping.h"

#include <gtest/gtest.h>

#include "zonal/base/error.h"
#include "zonal/sphere/every_projection.h"

namespace zonal {
namespace {

TEST(Mapping, DirectionOfPositionIsTheDirection) {
  Spread spread;
  int compared = 0, hidden = 0;
  for (const Example& example : every_projection(37)) {
    const Mapping mapping(example.projection, example.size);
    // A few roundings of a coordinate, times the radians a texel spans; the flat rims keep the square root of that.
    const double tolerance = flat_at_rim(example.projection) ? 1e-7 : 1e-13;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 d = spread.direction();
      const auto p = mapping.position(d);
      if (!p) {
        EXPECT_FALSE(mapping.covers_sphere()) << example.name;
        ++hidden;
        continue;
      }
      const auto back = mapping.direction(*p);
      ASSERT_TRUE(back) << example.name;
      EXPECT_LT(angle_between(*back, d), tolerance) << example.name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 80000);
  EXPECT_GT(hidden, 10000);
}

TEST(Mapping, PositionOfDirectionIsThePoint) {
  Spread spread;
  int compared = 0, gaps = 0, overlaps = 0;
  for (const Example& example : every_projection(37)) {
    const Mapping mapping(example.projection, example.size);
    for (int i = 0; i < 4000; ++i) {
      const PixelPoint p = spread.point(example.size);
      const auto d = mapping.direction(p);
      if (!d) {
        ++gaps;
        continue;
      }
      EXPECT_NEAR(length(*d), 1, 1e-12) << example.name;  // the slack with which a rim is accepted
      const auto back = mapping.position(*d);
      ASSERT_TRUE(back) << example.name;
      if (mapping.chart(*back) != mapping.chart(p)) {
        // The other circle of a wide dual fisheye shows it too, and nearer to its centre.
        EXPECT_EQ(example.projection.layout, Layout::kDualFisheye) << example.name;
        EXPECT_LT(angle_between(*mapping.direction(*back), *d), 1e-12);
        ++overlaps;
        continue;
      }
      // Pixels. A point within a millionth of a texel of a pole loses as much of its azimuth as this allows.
      EXPECT_NEAR(back->x, p.x, 1e-9) << example.name;
      EXPECT_NEAR(back->y, p.y, 1e-9) << example.name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 90000);
  EXPECT_GT(gaps, 10000);
  EXPECT_GT(overlaps, 1000);
}

TEST(Mapping, SpecialDirectionsSurvive) {
  int compared = 0;
  for (const int natural : {1, 2, 5, 64}) {
    for (const Example& example : every_projection(natural)) {
      const Mapping mapping(example.projection, example.size);
      for (int code = 0; code < 27; ++code) {  // axes, edges and corners of a cube
        const Vec3 corner{code % 3 - 1.0, code / 3 % 3 - 1.0, code / 9 - 1.0};
        if (corner == Vec3{}) continue;
        const Vec3 d = normalize(corner);
        const auto p = mapping.position(d);
        if (!p) {
          EXPECT_FALSE(mapping.covers_sphere()) << example.name;
          continue;
        }
        EXPECT_GE(p->x, 0) << example.name;
        EXPECT_GE(p->y, 0) << example.name;
        EXPECT_LE(p->x, example.size.width) << example.name;
        EXPECT_LE(p->y, example.size.height) << example.name;
        const auto back = mapping.direction(*p);
        ASSERT_TRUE(back) << example.name << " " << code;
        EXPECT_LT(angle_between(*back, d), flat_at_rim(example.projection) ? 1e-7 : 1e-13)
            << example.name << " " << code;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 2000);
}

TEST(Mapping, PicturesAreNotMirrored) {
  Spread spread;
  int seen_from_inside = 0, mirrored = 0;
  for (const Example& example : every_projection(37)) {
    const Layout layout = example.projection.layout;
    const Mapping mapping(example.projection, example.size);
    int checked = 0;
    while (checked < 200) {
      const PixelPoint p = spread.point(example.size);
      const double h = 1e-5;
      const auto d = mapping.direction(p), right = mapping.direction({p.x + h, p.y}),
                 down = mapping.direction({p.x, p.y + h});
      if (!d || !right || !down || mapping.chart(p) != mapping.chart({p.x + h, p.y + h})) continue;
      // right x down points the way the eye looks.
      const double turn = dot(*d, cross(*right - *d, *down - *d));
      const bool is_mirror = layout == Layout::kMirrorBall || layout == Layout::kSphereMap ||
                             (layout == Layout::kDualParaboloid && p.x > example.size.width / 2.0);
      EXPECT_GT(is_mirror ? -turn : turn, 0) << example.name << " at " << p.x << ", " << p.y;
      ++(is_mirror ? mirrored : seen_from_inside);
      ++checked;
    }
  }
  EXPECT_GT(seen_from_inside, 5000);
  EXPECT_GT(mirrored, 300);
}

/// The table of frame.h, from the pictures themselves.
TEST(Mapping, CentreRightAndUpAreAsDocumented) {
  struct Row {
    Layout layout;
    double x, y;  // the centre, in natural units
    Vec3 centre, right, up;
  };
  const Vec3 px{1, 0, 0}, py{0, 1, 0}, pz{0, 0, 1};
  const Row rows[] = {
      {Layout::kEquirect, 1, 0.5, px, -py, pz},
      {Layout::kCubeStack, 0.5, 4.5, px, -py, pz},
      {Layout::kCubeRow, 4.5, 0.5, px, -py, pz},
      {Layout::kCubeCross, 1.5, 1.5, px, -py, pz},
      {Layout::kCubeCrossVertical, 1.5, 1.5, px, -py, pz},
      {Layout::kCubeCrossVerticalUnrotated, 1.5, 1.5, px, -py, pz},
      {Layout::kOctahedral, 0.5, 0.5, pz, px, -py},
      {Layout::kOctahedralEqualArea, 0.5, 0.5, pz, px, -py},
      {Layout::kMirrorBall, 0.5, 0.5, -px, -py, pz},
      {Layout::kSphereMap, 0.5, 0.5, -px, -py, pz},
      {Layout::kAngular, 0.5, 0.5, px, -py, pz},
      {Layout::kDualParaboloid, 0.5, 0.5, px, -py, pz},
      {Layout::kDualParaboloid, 1.5, 0.5, -px, -py, pz},
      {Layout::kFisheye, 0.5, 0.5, pz, py, px},
      {Layout::kDualFisheye, 0.5, 0.5, px, -py, pz},
      {Layout::kDualFisheye, 1.5, 0.5, -px, py, pz},
  };
  const int n = 64;
  int checked = 0;
  for (const Row& row : rows) {
    const Mapping mapping({row.layout}, image_size(row.layout, n));
    const double x = row.x * n, y = row.y * n, step = 1e-3;
    const auto centre = mapping.direction({x, y}), right = mapping.direction({x + step, y}),
               up = mapping.direction({x, y - step});
    ASSERT_TRUE(centre && right && up) << name_of(row.layout);
    EXPECT_LT(angle_between(*centre, row.centre), 1e-14) << name_of(row.layout);  // exact numbers, one rounding of π
    // A small step turns into its direction to first order.
    EXPECT_LT(angle_between(normalize(*right - *centre), row.right), 1e-3) << name_of(row.layout);
    EXPECT_LT(angle_between(normalize(*up - *centre), row.up), 1e-3) << name_of(row.layout);
    ++checked;
  }
  EXPECT_EQ(checked, 16);
}

TEST(Mapping, AReflectingBallShowsWhatItReflects) {
  // The camera looks along +X with +Z up; its sensor's right is -Y. Reflection by the normal, not by our radial law.
  const int n = 200;
  const Mapping ball({Layout::kMirrorBall}, {n, n});
  int checked = 0;
  for (int y = 0; y < n; y += 7) {
    for (int x = 0; x < n; x += 7) {
      const double right = (x + 0.5) / (n / 2) - 1, up = 1 - (y + 0.5) / (n / 2);
      const double rest = 1 - right * right - up * up;
      if (rest <= 0) continue;
      const Vec3 normal{-std::sqrt(rest), -right, up}, incident{1, 0, 0};
      const Vec3 reflected = incident - 2 * dot(incident, normal) * normal;
      EXPECT_LT(angle_between(*ball.direction({x + 0.5, y + 0.5}), reflected), 1e-13);
      ++checked;
    }
  }
  EXPECT_GT(checked, 600);
}

TEST(Mapping, NearestIsTheTexelThatHoldsTheDirection) {
  Spread spread;
  int inside = 0, outside = 0;
  for (const Example& example : every_projection(24)) {
    const Mapping mapping(example.projection, example.size);
    for (int i = 0; i < 500; ++i) {
      const Vec3 d = spread.direction();
      const Texel t = mapping.nearest(d);
      const auto there = mapping.direction(center_of(t));
      ASSERT_TRUE(there) << example.name;
      if (const auto p = mapping.position(d)) {
        // Where the holding texel's centre is outside a circle, the next one toward the centre.
        EXPECT_LE(std::hypot(t.x + 0.5 - p->x, t.y + 0.5 - p->y), 1.8) << example.name;
        ++inside;
      } else {
        // A cap's nearest point to a direction outside is on its rim: no other texel is much nearer.
        const Texel other = mapping.nearest(spread.direction());
        const double texel = 2 * reach(example.projection) / 17;  // the widest: off centre, radius 0.38 * 24
        EXPECT_LT(angle_between(*there, d), angle_between(*mapping.direction(center_of(other)), d) + 2 * texel)
            << example.name;
        ++outside;
      }
    }
  }
  EXPECT_GT(inside, 8000);
  EXPECT_GT(outside, 1000);
}

TEST(Mapping, RefusesWrongShapesWithAHint) {
  int refused = 0;
  for (const Layout layout : all_layouts()) {
    if (layout == Layout::kFisheye) continue;  // any shape
    try {
      Mapping({layout}, {641, 479});
      ADD_FAILURE() << name_of(layout) << " accepted 641x479";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_NE(std::string(error.what()).find("641x479"), std::string::npos);
      EXPECT_NE(error.hint().find("nearest"), std::string::npos) << error.hint();
      ++refused;
    }
  }
  EXPECT_EQ(refused, 13);
  EXPECT_THROW(Mapping({Layout::kFisheye}, {0, 10}), Error);
  EXPECT_THROW(Mapping({Layout::kEquirect}, {-4, -2}), Error);
}

TEST(Mapping, RefusesImpossibleLenses) {
  const auto kind_of = [](Lens lens) -> std::optional<ErrorKind> {
    try {
      Mapping({Layout::kFisheye, lens}, {100, 80});
      return std::nullopt;
    } catch (const Error& error) {
      EXPECT_FALSE(error.hint().empty());
      return error.kind();
    }
  };
  EXPECT_EQ(kind_of({}), std::nullopt);
  EXPECT_EQ(kind_of({LensModel::kEquidistant, 360}), std::nullopt);
  EXPECT_EQ(kind_of({LensModel::kEquidistant, 0}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of({LensModel::kEquidistant, 361}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of({LensModel::kEquidistant, std::nan("")}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of({LensModel::kStereographic, 360}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of({LensModel::kStereographic, 359}), std::nullopt);
  EXPECT_EQ(kind_of({LensModel::kOrthographic, 181}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of({LensModel::kEquidistant, 180, 120, 40}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of({LensModel::kEquidistant, 180, 50, 40, -3}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of({LensModel::kEquidistant, 180, 50, 40, 0.1}), ErrorKind::kUsage);
  EXPECT_EQ(kind_of({LensModel::kEquidistant, 180, 50, 40, 300}), std::nullopt);  // a cropped circle
}

TEST(Mapping, VisitGivesTheConcreteMap) {
  const Mapping mapping({Layout::kCubeCross}, {64, 48});
  const double by_visit = mapping.visit([](const auto& map) { return map.solid_angle(20, 20); });
  EXPECT_EQ(by_visit, mapping.solid_angle(20, 20));
  EXPECT_GT(by_visit, 0);
  EXPECT_EQ(mapping.size(), (ImageSize{64, 48}));
  EXPECT_EQ(mapping.projection(), Projection{Layout::kCubeCross});
}

}  // namespace
}  // namespace zonal
