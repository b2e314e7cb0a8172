#include "zonal/report/unfolded_cube.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr int kFace = 32;
constexpr Rgb kPaper = {0.25f, 0.5f, 0.125f};
const Mapping kCross({Layout::kCubeCross}, image_size(Layout::kCubeCross, kFace));

bool is_white(Rgb c) { return c.r > 0.95f && c.g > 0.95f && c.b > 0.95f; }

TEST(UnfoldedCube, RedIsPositiveBlueNegativeGreenZero) {
  const Rgb positive = signed_color(1), zero = signed_color(0), negative = signed_color(-1);
  EXPECT_GT(positive.r, 5 * std::max(positive.g, positive.b));
  EXPECT_GT(zero.g, 5 * std::max(zero.r, zero.b));
  EXPECT_GT(negative.b, 5 * std::max(negative.r, negative.g));
  EXPECT_EQ(signed_color(7), positive);
  EXPECT_EQ(signed_color(-7), negative);
}

TEST(UnfoldedCube, EveryTexelHasTheColourOfItsDirection) {
  // Steps of one: the only line is at zero, which z + 2 never reaches.
  const auto f = [](Vec3 d) { return d.z + 2; };
  const Image<Rgb> picture = unfolded_cube(f, {.face_px = kFace, .full_scale = 3, .steps = 1, .paper = kPaper});
  ASSERT_EQ(picture.width(), 4 * kFace);
  ASSERT_EQ(picture.height(), 3 * kFace);
  int compared = 0, paper = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const std::optional<Vec3> toward = kCross.texel_direction(x, y);
      if (!toward) {
        EXPECT_EQ(picture(x, y), kPaper);
        ++paper;
        continue;
      }
      // A pixel is the mean of its corners, which is off by a curvature over a pixel's square.
      EXPECT_NEAR(picture(x, y).r, signed_color(f(*toward) / 3).r, 1e-3);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6 * kFace * kFace);
  EXPECT_EQ(paper, 6 * kFace * kFace);
}

TEST(UnfoldedCube, LinesStandAtEvenSteps) {
  const Image<Rgb> picture = unfolded_cube([](Vec3 d) { return d.z; }, {.face_px = kFace, .full_scale = 1, .steps = 4});
  int lines = 0, compared = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const std::optional<Vec3> toward = kCross.texel_direction(x, y);
      if (!toward) continue;
      const double level = 4 * toward->z, off = std::abs(level - std::round(level));
      ++compared;
      // A pixel changes z by at most 2/kFace: farther from a level than that there is no line.
      if (off > 4 * 2.0 / kFace) {
        EXPECT_FALSE(is_white(picture(x, y))) << x << ' ' << y;
      }
      if (is_white(picture(x, y))) ++lines;
    }
  }
  EXPECT_EQ(compared, 6 * kFace * kFace);
  EXPECT_GT(lines, 4 * kFace);  // at least one around the four sides
}

TEST(UnfoldedCube, AConstantHasNoLines) {
  for (const double value : {0.0, 0.5, 1.0, -1.0}) {
    const Image<Rgb> picture =
        unfolded_cube([=](Vec3) { return value; }, {.face_px = 8, .full_scale = 1, .steps = 2, .paper = kPaper});
    int compared = 0;
    for (const Rgb texel : picture.values()) {
      if (texel == kPaper) continue;
      EXPECT_EQ(texel, signed_color(value));
      ++compared;
    }
    EXPECT_EQ(compared, 6 * 8 * 8);
  }
}

TEST(UnfoldedCube, RefusesWhatIsNotFinite) {
  EXPECT_THROW(unfolded_cube([](Vec3 d) { return std::sqrt(d.z); }), std::logic_error);
  EXPECT_THROW(unfolded_cube([](Vec3) { return 1.0; }, {.face_px = 0}), std::logic_error);
  EXPECT_THROW(unfolded_cube([](Vec3) { return 1.0; }, {.steps = 0}), std::logic_error);
}

}  // namespace
}  // namespace zonal
