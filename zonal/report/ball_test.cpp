#include "zonal/report/ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace zonal {
namespace {

/// A map whose value is its direction.
Rgb as_color(Vec3 toward) {
  return {static_cast<float>(toward.x), static_cast<float>(toward.y), static_cast<float>(toward.z)};
}

void expect_near(Rgb got, Vec3 expected, double tolerance) {
  EXPECT_NEAR(got.r, expected.x, tolerance);
  EXPECT_NEAR(got.g, expected.y, tolerance);
  EXPECT_NEAR(got.b, expected.z, tolerance);
}

constexpr int kSize = 201;  // odd: a pixel is centred
constexpr int kMiddle = kSize / 2;
// A pixel is 1/100 of the radius; at the rim, half a pixel inside it, the normal is still acos(0.995) = 5.7 degrees
// from the edge.
constexpr double kAtRim = 0.1, kAtRimOfMirror = 0.2;

TEST(Ball, DiffuseShowsNormals) {
  const Image<Rgb> ball = draw_ball(as_color, BallKind::kDiffuse, {.size_px = kSize});
  expect_near(ball(kMiddle, kMiddle), {1, 0, 0}, 1e-7);
  expect_near(ball(kSize - 1, kMiddle), {0, 1, 0}, kAtRim);
  expect_near(ball(0, kMiddle), {0, -1, 0}, kAtRim);
  expect_near(ball(kMiddle, 0), {0, 0, 1}, kAtRim);
  expect_near(ball(kMiddle, kSize - 1), {0, 0, -1}, kAtRim);
}

TEST(Ball, MirrorShowsReflections) {
  const Image<Rgb> ball = draw_ball(as_color, BallKind::kMirror, {.size_px = kSize});
  expect_near(ball(kMiddle, kMiddle), {1, 0, 0}, 1e-7);
  expect_near(ball(kSize - 1, kMiddle), {-1, 0, 0}, kAtRimOfMirror);
  // Half way in angle the normal is 45 degrees up and the reflection straight up: at sin 45 degrees of the radius.
  const int up = kMiddle - static_cast<int>(std::lround(std::sqrt(0.5) * kSize / 2));
  expect_near(ball(kMiddle, up), {0, 0, 1}, 0.03);  // two pixels' worth of angle
}

TEST(Ball, EveryDirectionIsAUnitVector) {
  int compared = 0;
  for (const BallKind kind : {BallKind::kDiffuse, BallKind::kMirror}) {
    draw_ball(
        [&](Vec3 toward) {
          EXPECT_NEAR(length(toward), 1, 1e-12);  // a few roundings
          ++compared;
          return Rgb{};
        },
        kind, {.size_px = 20, .supersample = 2});
  }
  EXPECT_GT(compared, 2 * 4 * 300);  // two balls of at least 20² π/4 pixels, four samples each
}

TEST(Ball, TheRimGoesOnJustOutsideTheDisc) {
  const int size = 64;
  const Image<Rgb> ball = draw_ball([](Vec3) { return Rgb{1, 1, 1}; }, BallKind::kDiffuse, {.size_px = size});
  int white = 0, black = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double outside_px = std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0) - size / 2.0;
      EXPECT_EQ(ball(x, y), outside_px <= 2 ? (Rgb{1, 1, 1}) : Rgb{});
      ++(outside_px <= 2 ? white : black);
    }
  }
  EXPECT_GT(white, 3217);  // the disc's area
  EXPECT_GT(black, 100);
}

TEST(Ball, RefusesNoSize) {
  EXPECT_THROW(draw_ball(as_color, BallKind::kMirror, {.size_px = 0}), std::logic_error);
  EXPECT_THROW(draw_ball(as_color, BallKind::kMirror, {.size_px = 8, .supersample = 0}), std::logic_error);
}

}  // namespace
}  // namespace zonal
