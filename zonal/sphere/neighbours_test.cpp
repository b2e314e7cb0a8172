#include <gtest/gtest.h>

#include "zonal/sphere/every_projection.h"

namespace zonal {
namespace {

/// The four neighbours of a texel of a chart.
std::array<Texel, 4> beside(const Mapping& mapping, int chart, Texel t) {
  return {mapping.wrap(chart, t.x - 1, t.y), mapping.wrap(chart, t.x + 1, t.y), mapping.wrap(chart, t.x, t.y - 1),
          mapping.wrap(chart, t.x, t.y + 1)};
}

TEST(Neighbours, InsideAChartATexelIsItself) {
  int checked = 0;
  for (const Example& example : every_projection(9)) {
    const Mapping mapping(example.projection, example.size);
    for (int y = 0; y < example.size.height; ++y) {
      for (int x = 0; x < example.size.width; ++x) {
        if (!mapping.direction({x + 0.5, y + 0.5})) continue;
        EXPECT_EQ(mapping.wrap(mapping.chart({x + 0.5, y + 0.5}), x, y), (Texel{x, y})) << example.name;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 2000);
}

TEST(Neighbours, AreMutual) {
  int checked = 0, crossings = 0;
  for (const int natural : {1, 2, 3, 8}) {
    for (const Layout layout : all_layouts()) {
      const bool folded =
          layout <= Layout::kOctahedralEqualArea;  // discs' rims are only near, not matched texel by texel
      if (!folded) continue;
      const ImageSize size = image_size(layout, natural);
      const Mapping mapping({layout}, size);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          if (!mapping.direction({x + 0.5, y + 0.5})) continue;
          const int chart = mapping.chart({x + 0.5, y + 0.5});
          for (const Texel t : beside(mapping, chart, {x, y})) {
            const int there = mapping.chart(center_of(t));
            const auto back = beside(mapping, there, t);
            EXPECT_NE(std::find(back.begin(), back.end(), Texel{x, y}), back.end())
                << name_of(layout) << " " << natural << ": " << x << ", " << y << " has " << t.x << ", " << t.y;
            ++checked;
            crossings += there != chart;
          }
        }
      }
    }
  }
  EXPECT_EQ(checked, 4 * (5 * 6 + 2 + 2) * (1 + 4 + 9 + 64));  // beside each texel: cubes, octahedral, equirect
  EXPECT_EQ(crossings, 5 * 24 * (1 + 2 + 3 + 8));              // five cube layouts, 24 face borders
}

TEST(Neighbours, AtCubeEdgesAreTheNearestTexelsOfTheOtherFace) {
  int checked = 0;
  for (const Layout layout : {Layout::kCubeStack, Layout::kCubeCross, Layout::kCubeCrossVertical}) {
    const int n = 6;
    const ImageSize size = image_size(layout, n);
    const Mapping mapping({layout}, size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto home = mapping.direction({x + 0.5, y + 0.5});
        if (!home) continue;
        const int chart = mapping.chart({x + 0.5, y + 0.5});
        for (const Texel t : beside(mapping, chart, {x, y})) {
          const int there = mapping.chart(center_of(t));
          if (there == chart) continue;
          const double distance = angle_between(*home, *mapping.direction(center_of(t)));
          for (int v = 0; v < size.height; ++v) {
            for (int u = 0; u < size.width; ++u) {
              const auto other = mapping.direction({u + 0.5, v + 0.5});
              if (!other || mapping.chart({u + 0.5, v + 0.5}) != there) continue;
              EXPECT_GE(angle_between(*home, *other), distance - 1e-12);
              ++checked;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(checked, 3 * 24 * 6 * 36);  // layouts, borders, texels of a border, texels of the other face
}

/// The second row beyond an edge, which 4x4 interpolation reads, lies behind the first.
TEST(Neighbours, SecondTexelBeyondAnEdgeFollowsTheFirst) {
  int checked = 0;
  for (const Layout layout : {Layout::kCubeStack, Layout::kCubeCrossVertical, Layout::kOctahedral, Layout::kEquirect}) {
    const int n = 8;
    const Mapping mapping({layout}, image_size(layout, n));
    for (int y = 0; y < mapping.size().height; ++y) {
      for (int x = 0; x < mapping.size().width; ++x) {
        const auto home = mapping.direction({x + 0.5, y + 0.5});
        if (!home) continue;
        const int chart = mapping.chart({x + 0.5, y + 0.5});
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          const Texel one = mapping.wrap(chart, x + dx, y + dy), two = mapping.wrap(chart, x + 2 * dx, y + 2 * dy);
          EXPECT_NE(one, two);
          const auto next = beside(mapping, mapping.chart(center_of(one)), one);
          const bool crossed_once = mapping.chart(center_of(one)) == mapping.chart(center_of(two));
          if (crossed_once) {
            EXPECT_NE(std::find(next.begin(), next.end(), two), next.end());
          }
          ++checked;
        }
      }
    }
  }
  EXPECT_EQ(checked, 4 * (2 * 6 * 64 + 64 + 128));
}

TEST(Neighbours, OfAnyPointAreShownAndNear) {
  Spread spread;
  int checked = 0, beyond = 0;
  for (const Example& example : every_projection(20)) {
    const Mapping mapping(example.projection, example.size);
    if (example.projection.lens.fov_deg == 340) continue;  // its middle texels show a quarter of the sphere each
    // A texel's extent at its widest; at a flat rim that is where r = sin θ or sin(θ/2) turns over.
    const double in_radius = 2 / (0.76 * 20);  // of the elliptic example, the smallest circle
    const double flat = std::acos(1 - in_radius) * (reach(example.projection) > 2 ? 2 : 1);
    const double texel = flat_at_rim(example.projection) ? flat : reach(example.projection) * in_radius;
    for (int i = 0; i < 1000; ++i) {
      const auto p = mapping.position(spread.direction());
      if (!p) continue;
      const int chart = mapping.chart(*p);
      const int x = static_cast<int>(std::floor(p->x - 0.5)), y = static_cast<int>(std::floor(p->y - 0.5));
      for (const Texel raw : {Texel{x, y}, Texel{x + 1, y}, Texel{x, y + 1}, Texel{x + 1, y + 1}}) {
        const Texel t = mapping.wrap(chart, raw.x, raw.y);
        const auto d = mapping.direction(center_of(t));
        ASSERT_TRUE(d) << example.name;
        EXPECT_LT(angle_between(*d, *mapping.direction(*p)), 2 * texel) << example.name;
        ++checked;
        beyond += t != raw;
      }
    }
  }
  EXPECT_GT(checked, 50000);
  EXPECT_GT(beyond, 2000);
}

TEST(Neighbours, OfAFullDiscsRimLieOnTheOtherSide) {
  const int n = 64;
  const Mapping angular({Layout::kAngular}, {n, n});
  int checked = 0;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const double dx = x + 0.5 - n / 2, dy = y + 0.5 - n / 2;
      const double r = std::hypot(dx, dy);
      if (r <= n / 2 || r > n / 2 + 1.5) continue;
      const Texel t = angular.wrap(0, x, y);
      const double tx = t.x + 0.5 - n / 2, ty = t.y + 0.5 - n / 2;
      EXPECT_LT(tx * dx + ty * dy, 0);
      EXPECT_GT(std::hypot(tx, ty), n / 2 - 3);
      ++checked;
    }
  }
  EXPECT_GT(checked, 100);
}

/// Independent of the integers that decide it: a block is regular when no coordinate plane (octahedral) or cube edge
/// separates its texels' directions.
TEST(Regular, OctahedralBlocksStayInAnOctant) {
  int regular = 0, creased = 0;
  for (const int n : {7, 8}) {
    for (const Layout layout : {Layout::kOctahedral, Layout::kOctahedralEqualArea}) {
      const Mapping mapping({layout}, {n, n});
      for (int y = -1; y < n; ++y) {
        for (int x = -1; x < n; ++x) {
          bool crosses = x < 0 || y < 0 || x + 1 >= n || y + 1 >= n;
          Vec3 low{1, 1, 1}, high{-1, -1, -1};
          for (int k = 0; k < 4 && !crosses; ++k) {
            const Vec3 d = *mapping.direction({x + k % 2 + 0.5, y + k / 2 + 0.5});
            low = {std::min(low.x, d.x), std::min(low.y, d.y), std::min(low.z, d.z)};
            high = {std::max(high.x, d.x), std::max(high.y, d.y), std::max(high.z, d.z)};
          }
          const double zero = 1e-12;  // a centre on a crease, to rounding
          crosses = crosses || (low.x < -zero && high.x > zero) || (low.y < -zero && high.y > zero) ||
                    (low.z < -zero && high.z > zero);
          EXPECT_EQ(mapping.regular(0, x, y), !crosses) << name_of(layout) << n << ": " << x << ", " << y;
          ++(crosses ? creased : regular);
        }
      }
    }
  }
  EXPECT_GE(regular, 80);
  EXPECT_GT(creased, 100);
}

TEST(Regular, CubeBlocksStayOnAFace) {
  const int n = 5;
  const Mapping mapping({Layout::kCubeCross}, {4 * n, 3 * n});
  int regular = 0, split = 0;
  for (int face = 0; face < 6; ++face) {
    for (int y = -1; y < 3 * n; ++y) {
      for (int x = -1; x < 4 * n; ++x) {
        bool inside = true;
        for (int k = 0; k < 4; ++k) {
          const PixelPoint p{x + k % 2 + 0.5, y + k / 2 + 0.5};
          const auto d = mapping.direction(p);
          inside = inside && d && face_point(sampler_from_world(*d)).face == face;
        }
        EXPECT_EQ(mapping.regular(face, x, y), inside);
        ++(inside ? regular : split);
      }
    }
  }
  EXPECT_EQ(regular, 6 * (n - 1) * (n - 1));
  EXPECT_GT(split, 100);
}

TEST(Regular, PanoramasAreRegularAcrossTheSeamAndEvenPoles) {
  const Mapping even({Layout::kEquirect}, {16, 8}), odd({Layout::kEquirect}, {201, 100});
  EXPECT_TRUE(even.regular(0, -1, 3));
  EXPECT_TRUE(even.regular(0, 15, 3));
  EXPECT_TRUE(even.regular(0, 2, -1));
  EXPECT_TRUE(even.regular(0, 2, 7));
  EXPECT_TRUE(odd.regular(0, 200, 3));
  EXPECT_FALSE(odd.regular(0, 2, -1));
  EXPECT_FALSE(odd.regular(0, 2, 99));
}

TEST(Regular, DiscBlocksStayInTheCircle) {
  const int n = 16;
  const Mapping mapping({Layout::kDualParaboloid}, {2 * n, n});
  int regular = 0, cut = 0;
  for (int y = -1; y < n; ++y) {
    for (int x = -1; x < 2 * n; ++x) {
      for (int chart = 0; chart < 2; ++chart) {
        bool inside = true;
        for (int k = 0; k < 4; ++k) {
          const double px = x + k % 2 + 0.5, py = y + k / 2 + 0.5;
          inside = inside && std::hypot(px - (chart + 0.5) * n, py - 0.5 * n) <= 0.5 * n;
        }
        EXPECT_EQ(mapping.regular(chart, x, y), inside);
        ++(inside ? regular : cut);
      }
    }
  }
  EXPECT_GT(regular, 200);
  EXPECT_GT(cut, 200);
}

}  // namespace
}  // namespace zonal
