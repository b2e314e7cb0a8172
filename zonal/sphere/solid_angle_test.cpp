#include <gtest/gtest.h>

#include "zonal/sphere/every_projection.h"
#include "zonal/sphere/solid_triangle.h"

namespace zonal {
namespace {

double total_solid_angle(const Mapping& mapping) {
  double sum = 0;
  for (int y = 0; y < mapping.size().height; ++y) {
    double row = 0;  // row by row, so that millions of roundings do not add up
    for (int x = 0; x < mapping.size().width; ++x) row += mapping.solid_angle(x, y);
    sum += row;
  }
  return sum;
}

/// What a picture shows of the sphere: all of it, or a cap around a disc's centre.
double shown_solid_angle(const Example& example) {
  if (example.projection.layout != Layout::kFisheye) return 4 * kPi;
  return 2 * kPi * (1 - std::cos(reach(example.projection)));
}

TEST(SolidAngle, SumsToWhatThePictureShows) {
  int summed = 0;
  for (const int natural : {1, 2, 3, 5, 16, 33, 100}) {
    for (const Example& example : every_projection(natural)) {
      const double expected = shown_solid_angle(example);
      EXPECT_NEAR(total_solid_angle(Mapping(example.projection, example.size)), expected, 1e-12 * expected)
          << example.name;
      ++summed;
    }
  }
  for (const ImageSize size : {ImageSize{201, 100}, {1922, 958}, {101, 50}}) {
    EXPECT_NEAR(total_solid_angle(Mapping({Layout::kEquirect}, size)), 4 * kPi, 1e-12 * 4 * kPi);
    ++summed;
  }
  EXPECT_GT(summed, 200);
}

TEST(SolidAngle, IsNeverNegative) {
  int texels = 0, empty = 0;
  for (const Example& example : every_projection(25)) {
    const Mapping mapping(example.projection, example.size);
    for (int y = 0; y < example.size.height; ++y) {
      for (int x = 0; x < example.size.width; ++x) {
        const double omega = mapping.solid_angle(x, y);
        EXPECT_GE(omega, 0) << example.name;
        // Light that a texel holds always comes from somewhere.
        const bool shown = omega > 0 || mapping.direction({x + 0.5, y + 0.5});
        EXPECT_EQ(mapping.texel_direction(x, y).has_value(), shown) << example.name;
        empty += omega == 0;
        ++texels;
      }
    }
  }
  EXPECT_GT(texels, 20000);
  EXPECT_GT(empty, 2000);
}

/// The solid angle of a texel as a mesh of small triangles through direction(); nullopt where a circle cuts it.
std::optional<double> meshed_solid_angle(const Mapping& mapping, int x, int y, int cells) {
  double sum = 0;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      std::array<Vec3, 4> d;
      for (int k = 0; k < 4; ++k) {
        // Just inside, so that a texel's border is not looked up in the next face.
        const double inset = 1e-9;
        const PixelPoint p{x + std::clamp((i + k % 2) / static_cast<double>(cells), inset, 1 - inset),
                           y + std::clamp((j + k / 2) / static_cast<double>(cells), inset, 1 - inset)};
        const auto seen = mapping.direction(p);
        if (!seen) return std::nullopt;
        d[static_cast<std::size_t>(k)] = *seen;
      }
      sum += std::abs(solid_triangle(d[0], d[1], d[3], dot(d[0], cross(d[1] - d[0], d[3] - d[0]))));
      sum += std::abs(solid_triangle(d[0], d[3], d[2], dot(d[0], cross(d[3] - d[0], d[2] - d[0]))));
    }
  }
  return sum;
}

TEST(SolidAngle, AgreesWithAMesh) {
  Spread spread;
  int compared = 0, creased = 0;
  for (const int natural : {9, 16}) {
    for (const Example& example : every_projection(natural)) {
      const Projection& shown = example.projection;
      if (shown.layout == Layout::kDualFisheye && shown.lens.fov_deg > 180)
        continue;  // its overlap is shown but not owned
      const Mapping mapping(shown, example.size);
      for (int i = 0; i < 25; ++i) {
        const int x = spread.index(example.size.width), y = spread.index(example.size.height);
        const int cells = 12;
        const auto mesh = meshed_solid_angle(mapping, x, y, cells);
        const double exact = mapping.solid_angle(x, y);
        if (!mesh) continue;
        // A mesh of chords misses the second order of a cell, most at a flat rim and in the folds' corners.
        EXPECT_NEAR(*mesh, exact, 2e-2 * exact) << example.name << " " << x << ", " << y;
        const auto finer = meshed_solid_angle(mapping, x, y, 4 * cells);
        ASSERT_TRUE(finer);
        const double extrapolated = *finer + (*finer - *mesh) / 15;
        EXPECT_NEAR(extrapolated, exact, 1e-3 * exact) << example.name << " " << x << ", " << y;
        const bool smooth = std::abs(extrapolated - exact) < 1e-7 * exact;
        creased += !smooth;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 900);
  EXPECT_LT(creased, compared / 4);  // only where a crease or a flat rim spoils the extrapolation
}

TEST(SolidAngle, OfAHugePictureKeepsItsDigits) {
  // Neighbouring texels of a very large picture differ little: a difference of large numbers would show as noise.
  int compared = 0;
  for (const Example& example : every_projection(20000)) {
    const Layout layout = example.projection.layout;
    if (layout == Layout::kFisheye || layout == Layout::kDualFisheye) continue;
    const Mapping mapping(example.projection, example.size);
    const int x = example.size.width / 2 + 3000, y = example.size.height / 2 + 3000;
    if (!mapping.direction({x + 0.5, y + 0.5})) continue;
    const double step = mapping.solid_angle(x + 1, y) - mapping.solid_angle(x, y);
    const double next = mapping.solid_angle(x + 2, y) - mapping.solid_angle(x + 1, y);
    // The edges of a disc's texel cancel: 4 roundings of numbers below 1. The others keep their relative digits.
    const double noise = layout < Layout::kMirrorBall ? 1e-13 * mapping.solid_angle(x, y) : 4e-16;
    EXPECT_NEAR(step, next, noise + 0.01 * std::abs(step)) << example.name;
    ++compared;
  }
  EXPECT_GE(compared, 8);
}

TEST(SolidAngle, OfOneTexelAroundACircleIsTheWholeCap) {
  const Mapping picture({Layout::kFisheye, {LensModel::kEquidistant, 220, 0.5, 0.5, 0.5}}, {1, 1});
  EXPECT_NEAR(picture.solid_angle(0, 0), 2 * kPi * (1 - std::cos(radians(110))), 1e-14);
  const Mapping inner({Layout::kFisheye, {LensModel::kOrthographic, 180, 1.5, 1.5, 0.5}}, {3, 3});
  EXPECT_NEAR(inner.solid_angle(1, 1), 2 * kPi, 1e-14);
  EXPECT_EQ(inner.solid_angle(0, 0), 0);
}

TEST(SolidAngle, OfAWideDualFisheyeCountsEveryDirectionOnce) {
  const Mapping wide({Layout::kDualFisheye, {LensModel::kEquidistant, 200}}, {128, 64});
  // The rim column shows 100° from the centre: readable, but the other circle owns it.
  EXPECT_TRUE(wide.direction({0.5, 32}));
  EXPECT_EQ(wide.solid_angle(0, 31), 0);
  EXPECT_NEAR(total_solid_angle(wide), 4 * kPi, 1e-12 * 4 * kPi);
}

}  // namespace
}  // namespace zonal
