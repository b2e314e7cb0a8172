#include "zonal/light/sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "zonal/light/sample_taps.h"
#include "zonal/light/synthetic.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr Layout kFullSphere[] = {Layout::kEquirect,          Layout::kCubeStack,
                                  Layout::kCubeRow,           Layout::kCubeCross,
                                  Layout::kCubeCrossVertical, Layout::kCubeCrossVerticalUnrotated,
                                  Layout::kOctahedral,        Layout::kOctahedralEqualArea,
                                  Layout::kMirrorBall,        Layout::kSphereMap,
                                  Layout::kAngular,           Layout::kDualParaboloid};

std::vector<Vec3> directions(int count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Vec3> all;
  for (int i = 0; i < count; ++i) all.push_back(normalize({normal(random), normal(random), normal(random)}));
  for (const double x : {-1.0, 0.0, 1.0}) {  // axes, edges and corners of cubes and octahedra
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        if (x != 0 || y != 0 || z != 0) all.push_back(normalize({x, y, z}));
      }
    }
  }
  return all;
}

double linear_sky(Vec3 d) { return 1 + d.x + 0.5 * d.y; }

TEST(Sample, ConstantIsConstantEverywhere) {
  int compared = 0;
  for (const Layout layout : kFullSphere) {
    const Environment e = furnace({layout}, image_size(layout, 32), {0.7f, 1.3f, 2.1f});
    const Sampler sampler(e);
    for (const Vec3& d : directions(2000)) {
      const Rgb c = sampler(d);
      ASSERT_NEAR(c.r, 0.7f, 1e-6f) << name_of(layout);
      ASSERT_NEAR(c.g, 1.3f, 1e-6f) << name_of(layout);
      ASSERT_NEAR(c.b, 2.1f, 1e-6f) << name_of(layout);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12 * 2026);
}

TEST(Sample, LinearSkyIsExactAcrossEverySeam) {
  int compared = 0;
  for (const Layout layout : kFullSphere) {
    const Environment e = gradient({layout}, image_size(layout, 256));
    const Sampler sampler(e);
    double worst = 0;
    for (const Vec3& d : directions(20000)) {
      worst = std::max(worst, std::abs(sampler(d).r - linear_sky(d)));
      ++compared;
    }
    // A limited cubic falls back to straight lines where the function bends the other way or passes zero: spacing²/8,
    // at 4/256 radians in the middle of a ball.
    EXPECT_LT(worst, 3.1e-5) << name_of(layout);
  }
  EXPECT_EQ(compared, 12 * 20026);
}

TEST(Sample, ReturnsTexelsAtTheirCentres) {
  int compared = 0;
  for (const Layout layout : kFullSphere) {
    Environment e = furnace({layout}, image_size(layout, 16));
    std::mt19937 random(3);
    for (Rgb& c : e.radiance.values()) c.r = std::uniform_real_distribution<float>(0, 9)(random);
    const Mapping mapping(e.projection, {e.radiance.width(), e.radiance.height()});
    const Sampler sampler(e);
    const bool ball = layout == Layout::kMirrorBall || layout == Layout::kSphereMap;
    for (int y = 0; y < e.radiance.height(); ++y) {
      for (int x = 0; x < e.radiance.width(); ++x) {
        const auto d = mapping.direction(center_of({x, y}));
        if (!d || (ball && d->x > 0.5)) continue;  // behind a ball a fit speaks for the rim
        ASSERT_NEAR(sampler(*d).r, e.radiance(x, y).r, 1e-4f) << name_of(layout) << " " << x << " " << y;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 8000);
}

TEST(Sample, NeverNegativeNorAboveASun) {
  int compared = 0;
  for (const Layout layout : kFullSphere) {
    std::mt19937 random(5);
    Environment e = furnace({layout}, image_size(layout, 24), {0, 0, 0});
    for (Rgb& c : e.radiance.values()) {  // a sky of spikes
      if (random() % 5 == 0) c = {1e6f, 3, 1};
    }
    const Sampler sampler(e);
    for (const Vec3& d : directions(5000)) {
      const Rgb c = sampler(d);
      ASSERT_GE(std::min({c.r, c.g, c.b}), 0) << name_of(layout);
      ASSERT_LE(c.r, 1.7e6f) << name_of(layout);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12 * 5026);
}

TEST(Sample, NoRingBesideASun) {
  Environment e = furnace({}, {64, 32}, {1, 1, 1});
  e.radiance(40, 16) = {1e6f, 1e6f, 1e6f};
  const Mapping mapping({}, {64, 32});
  const Sampler sampler(e);
  int beside = 0;
  for (double x = 37; x <= 44; x += 0.1) {
    for (double y = 13; y <= 20; y += 0.1) {
      const float v = sampler(*mapping.direction({x, y})).r;
      const bool near_sun = std::abs(x - 40.5) < 1 && std::abs(y - 16.5) < 1;
      if (near_sun) {
        ASSERT_LE(v, 1e6f);
      } else {
        ASSERT_NEAR(v, 1, 1e-5f) << x << " " << y;
        ++beside;
      }
    }
  }
  EXPECT_GT(beside, 4000);
}

TEST(Sample, UncoveredDirectionsGiveTheNearestTexel) {
  const Projection fisheye{Layout::kFisheye, {}};
  Environment e = furnace(fisheye, image_size(Layout::kFisheye, 32), {2, 2, 2});
  const Sampler sampler(e);
  EXPECT_EQ(sampler({0, 0, -1}), (Rgb{2, 2, 2}));
}

TEST(LimitedCubic, KeepsSmoothExtremesAndLinesThroughSpikes) {
  // A parabola is followed exactly.
  const auto parabola = [](float x) { return 10 - x * x; };
  for (float t = 0; t <= 1; t += 0.125f) {
    const auto v = limited_cubic(Float4{} + parabola(-1.5f), Float4{} + parabola(-0.5f), Float4{} + parabola(0.5f),
                                 Float4{} + parabola(1.5f), Float4{} + t);
    EXPECT_NEAR(v[0], parabola(t - 0.5f), 1e-5f);
  }
  const auto value = [](float a, float b, float c, float d, float t) {
    return limited_cubic(Float4{} + a, Float4{} + b, Float4{} + c, Float4{} + d, Float4{} + t)[0];
  };
  EXPECT_EQ(value(1, 1, 1, 1e6f, 0.5f), 1);
  EXPECT_FLOAT_EQ(value(1, 1, 1e6f, 1, 0.25f), 0.75f + 0.25e6f);
  EXPECT_NEAR(value(1, 1e6f, 1e6f, 1, 0.5f), 1e6f, 1);  // two bright texels do not swell
}

}  // namespace
}  // namespace zonal
