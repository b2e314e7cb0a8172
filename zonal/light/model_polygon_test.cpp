#include "zonal/light/model_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/light/model.h"
#include "zonal/math/quadrature.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

constexpr RgbD kOne = {1, 1, 1};

/// The parallelogram a + u b + v c over `n` x `n` Gauss nodes: dOmega = |a.(b x c)| du dv/r^3. `triangle` takes u + v <
/// 1 only.
Sh<double> by_quadrature(Vec3 a, Vec3 b, Vec3 c, int bands, int n, bool triangle = false) {
  const Quadrature gauss = gauss_legendre(n, 0, 1);
  const double volume = std::abs(dot(a, cross(b, c)));
  Sh<double> sum(bands), y(bands);
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    for (std::size_t j = 0; j < gauss.size(); ++j) {
      const double u = gauss.nodes[i], height = triangle ? 1 - u : 1;
      const Vec3 p = a + u * b + height * gauss.nodes[j] * c;
      const double r = length(p);
      basis(bands, (1 / r) * p, y.values());
      sum += gauss.weights[i] * gauss.weights[j] * height * volume / (r * r * r) * y;
    }
  }
  return sum;
}

int expect_near(const Sh<RgbD>& actual, const Sh<double>& expected, double tolerance) {
  EXPECT_EQ(actual.size(), expected.size());
  int compared = 0;
  for (std::size_t i = 0; i < std::min(actual.size(), expected.size()); ++i, ++compared) {
    EXPECT_NEAR(actual[i].g, expected[i], tolerance) << i;
  }
  return compared;
}

TEST(PolygonLight, RectanglesAgreeWithDenseIntegration) {
  struct Case {
    Vec3 center, half_width, half_height;
  };
  // Overhead, slanted and close, below the horizon, tall and far, through the pole of the basis at a corner.
  const Case cases[] = {{{0, 0, 2}, {1, 0, 0}, {0, 0.5, 0}},
                        {{1, -0.4, 0.3}, {0.2, 0.7, 0.1}, {-0.3, 0.1, 0.8}},
                        {{-1, 2, -3}, {1, 1, 0.2}, {0.5, -1, 0.7}},
                        {{30, 5, 1}, {0, 0.3, 0}, {0, 0, 9}},
                        {{0.5, 0.5, 1}, {0.5, 0, 0}, {0, 0.5, 0}}};
  int compared = 0;
  for (const Case& c : cases) {
    const Vec3 corner = c.center - c.half_width - c.half_height;
    const auto corners = rectangle_corners(c.center, c.half_width, c.half_height);
    const Sh<double> expected = by_quadrature(corner, 2 * c.half_width, 2 * c.half_height, 16, 80);
    compared += expect_near(polygon_sh(corners, kOne, 16), expected, 2e-14);
    EXPECT_NEAR(polygon_solid_angle(corners), expected(0, 0) * std::sqrt(4 * kPi), 2e-14);
  }
  EXPECT_EQ(compared, 5 * 256);
}

TEST(PolygonLight, TrianglesInManyBandsAgreeWithDenseIntegration) {
  const Vec3 a = {0.6, -0.5, 0.4}, b = {-0.5, 1.3, 0.1}, c = {0.2, 0.4, 0.9};
  const Vec3 triangle[] = {a, a + b, a + c};
  EXPECT_EQ(expect_near(polygon_sh(triangle, kOne, 50), by_quadrature(a, b, c, 50, 120, true), 4e-14), 2500);
}

TEST(PolygonLight, EightOctantsMakeAFurnace) {
  Sh<RgbD> sum(12);
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      for (const int z : {-1, 1}) {
        const Vec3 octant[] = {{x * 2.0, 0, 0}, {0, y * 0.5, 0}, {0, 0, z * 1.0}};
        EXPECT_NEAR(polygon_solid_angle(octant), kPi / 2, 1e-15);
        sum += polygon_sh(octant, kOne, 12);
      }
    }
  }
  EXPECT_EQ(expect_near(sum, zonal_toward(constant_zonal(12), {0, 0, 1}), 1e-14), 144);
}

TEST(PolygonLight, BandOneIsLambertsFormula) {
  // The vector irradiance of a polygon is half the sum of its edges' angles times their normals (Lambert 1760).
  const Vec3 v[] = {{1, 0.2, 0.5}, {0.8, 1, 0.4}, {0.3, 0.9, 1.2}, {0.5, -0.3, 0.8}};
  Vec3 vector;
  for (int i = 0; i < 4; ++i) {
    const Vec3 a = normalize(v[i]), b = normalize(v[(i + 1) % 4]);
    vector += angle_between(a, b) / 2 * normalize(cross(a, b));
  }
  const Sh<RgbD> sh = polygon_sh(v, kOne, 2);
  const double scale = std::sqrt(3 / (4 * kPi));
  EXPECT_NEAR(sh(1, 1).r, scale * vector.x, 1e-15);
  EXPECT_NEAR(sh(1, -1).r, scale * vector.y, 1e-15);
  EXPECT_NEAR(sh(1, 0).r, scale * vector.z, 1e-15);
  EXPECT_GT(vector.z, 0.1);
}

TEST(PolygonLight, AManySidedPolygonIsADisc) {
  constexpr int kSides = 20000;
  std::vector<Vec3> rim;
  for (int i = 0; i < kSides; ++i) {
    const double phi = 2 * kPi * i / kSides;
    rim.push_back({std::cos(phi), std::sin(phi), 1});
  }
  // An inscribed polygon lacks (2pi/n)^2/6 of the disc's area.
  EXPECT_EQ(expect_near(polygon_sh(rim, kOne, 5), zonal_toward(cone_zonal(kPi / 4, 5), {0, 0, 1}), 4e-8), 25);
}

TEST(PolygonLight, PartsAddUpAndTheWayRoundDoesNotMatter) {
  // An L, not convex; its fan from the first corner leaves it.
  const Vec3 whole[] = {{0, 2, 1}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}};
  const Vec3 tall[] = {{0, 0, 1}, {1, 0, 1}, {1, 2, 1}, {0, 2, 1}},
             wide[] = {{1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}};
  const Sh<RgbD> all = polygon_sh(whole, kOne, 8), parts = polygon_sh(tall, kOne, 8) + polygon_sh(wide, kOne, 8);
  std::vector<Vec3> back(std::rbegin(whole), std::rend(whole));
  back.push_back(back.back());  // a corner twice changes nothing
  const Sh<RgbD> reversed = polygon_sh(back, kOne, 8);
  int compared = 0;
  for (std::size_t i = 0; i < all.size(); ++i, ++compared) {
    EXPECT_NEAR(all[i].r, parts[i].r, 4e-15);
    EXPECT_NEAR(all[i].r, reversed[i].r, 4e-15);
  }
  EXPECT_EQ(compared, 64);
}

TEST(PolygonLight, SmallAndFarIsADirectionalLight) {
  const Vec3 toward = normalize({1, 2, -3});
  const Vec3 right = normalize(cross(toward, {0, 0, 1})), up = cross(right, toward);
  constexpr double kHalf = 1e-4;
  const auto corners = rectangle_corners(toward, kHalf * right, kHalf * up);
  // Bands lose l(l+1) size^2/6 of their share, 3e-7 here, and the edges' rounding is eps/size = 2e-12 of it.
  const double solid_angle = polygon_solid_angle(corners);
  EXPECT_NEAR(solid_angle / (4 * kHalf * kHalf), 1, 3 * kHalf * kHalf);
  const Sh<RgbD> expected = directional_sh(toward, kOne, 6), sh = (1 / solid_angle) * polygon_sh(corners, kOne, 6);
  int compared = 0;
  for (std::size_t i = 0; i < sh.size(); ++i, ++compared) EXPECT_NEAR(sh[i].b, expected[i].b, 3e-7);
  EXPECT_EQ(compared, 36);
}

TEST(PolygonLight, TheUnitOfLengthDoesNotMatter) {
  const Sh<RgbD> sh = polygon_sh(rectangle_corners({1, 2, 3}, {1, 0, 0}, {0, 1, 0}), kOne, 5);
  int compared = 0;
  for (const double unit : {1e-200, 1e200}) {
    const Sh<RgbD> other = polygon_sh(rectangle_corners(unit * Vec3{1, 2, 3}, {unit, 0, 0}, {0, unit, 0}), kOne, 5);
    for (std::size_t i = 0; i < sh.size(); ++i, ++compared) EXPECT_NEAR(other[i].r, sh[i].r, 1e-15);
  }
  EXPECT_EQ(compared, 50);
}

TEST(PolygonLight, EdgeOnItGivesNothing) {
  const auto corners = rectangle_corners({2, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0});
  EXPECT_EQ(expect_near(polygon_sh(corners, kOne, 6), Sh<double>(6), 1e-15), 36);
}

TEST(PolygonLight, RefusesWhatHasNoMeaning) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vec3 two[] = {{1, 0, 0}, {0, 1, 0}}, bad[] = {{1, 0, 0}, {0, nan, 0}, {0, 0, 1}};
  const Vec3 at_vertex[] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, on_edge[] = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  EXPECT_THROW(polygon_sh(two, kOne, 3), Error);
  EXPECT_THROW(polygon_sh(bad, kOne, 3), Error);
  EXPECT_THROW(polygon_sh(at_vertex, kOne, 3), Error);
  EXPECT_THROW(polygon_sh(on_edge, kOne, 3), Error);
  EXPECT_THROW(polygon_sh(rectangle_corners({0.1, 0.2, 0}, {1, 0, 0}, {0, 1, 0}), kOne, 3), Error);
  EXPECT_THROW(polygon_sh(rectangle_corners({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), {nan, 1, 1}, 3), Error);
  EXPECT_THROW(polygon_sh(rectangle_corners({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), kOne, 0), std::logic_error);
}

}  // namespace
}  // namespace zonal
