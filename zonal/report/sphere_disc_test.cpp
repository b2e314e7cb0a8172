#include "zonal/report/sphere_disc.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "zonal/math/sphere_rule.h"
#include "zonal/report/ball.h"

namespace zonal {
namespace {

TEST(SphereDisc, PlacesAndDirectionsAreInverse) {
  int compared = 0;
  for (const Vec3 d : spiral_directions(500)) {
    const DiscPlace place = sphere_disc_place(d);
    EXPECT_LE(std::hypot(2 * place.x - 1, 2 * place.y - 1), 1 + 1e-15);
    EXPECT_LT(length(sphere_disc_direction(place) - d), 1e-14);  // a few roundings
    ++compared;
  }
  EXPECT_EQ(compared, 500);
}

TEST(SphereDisc, TheViewerStandsAtPlusX) {
  const auto expect_at = [](Vec3 d, double x, double y) {
    EXPECT_NEAR(sphere_disc_place(d).x, x, 1e-15);
    EXPECT_NEAR(sphere_disc_place(d).y, y, 1e-15);
  };
  expect_at({1, 0, 0}, 0.5, 0.5);
  expect_at({0, 1, 0}, 0.75, 0.5);   // half way to the rim
  expect_at({0, 0, 1}, 0.5, 0.25);   // up
  expect_at({0, 0, -1}, 0.5, 0.75);  // down
  EXPECT_NEAR(sphere_disc_place({-1, 0, 0}).x, 1, 1e-15);
  EXPECT_LT(length(sphere_disc_direction({0.5, 0.5}) - Vec3{1, 0, 0}), 1e-15);
  EXPECT_LT(length(sphere_disc_direction({0, 0}) - Vec3{-1, 0, 0}), 1e-15);  // outside: the rim
}

TEST(SphereDisc, HasTheLightOnTheSideWhereAMatteBallHasIt) {
  const auto light = [](Vec3 d) { return Rgb{static_cast<float>(d.y), static_cast<float>(d.z), 0}; };
  const Image<Rgb> disc = draw_sphere_disc(light, 64), ball = draw_ball(light, BallKind::kDiffuse, {.size_px = 64});
  int compared = 0;
  for (const auto& [x, y] : {std::pair{45, 20}, {20, 20}, {45, 45}, {20, 45}}) {
    EXPECT_GT(disc(x, y).r * ball(x, y).r, 0);
    EXPECT_GT(disc(x, y).g * ball(x, y).g, 0);
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

TEST(SphereDisc, AveragesInsideAPixel) {
  const Image<double> disc = draw_sphere_disc([](Vec3 d) { return d.z > 0 ? 1.0 : 0.0; }, 3, 4);
  EXPECT_DOUBLE_EQ(disc(1, 0), 1);
  EXPECT_DOUBLE_EQ(disc(1, 1), 0.5);
  EXPECT_DOUBLE_EQ(disc(1, 2), 0);
}

TEST(SphereDisc, RefusesNoSize) {
  const auto one = [](Vec3) { return 1.0; };
  EXPECT_THROW(draw_sphere_disc(one, 0), std::logic_error);
  EXPECT_THROW(draw_sphere_disc(one, 8, 0), std::logic_error);
}

}  // namespace
}  // namespace zonal
