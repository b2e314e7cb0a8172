#include "apps/viewer/orbit_input.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zonal {
namespace {

TEST(OrbitInput, ADragOverTheWindowIsHalfATurn) {
  OrbitCamera camera;
  camera.yaw_deg = 0, camera.pitch_deg = 0;
  orbit(camera, -720, 0, 720);
  EXPECT_NEAR(std::abs(camera.yaw_deg), 180, 1e-12);
  orbit(camera, 0, 10'000, 720);
  EXPECT_EQ(camera.pitch_deg, 89);
  orbit(camera, 0, -10'000, 720);
  EXPECT_EQ(camera.pitch_deg, -89);
}

TEST(OrbitInput, TheCameraStaysWithinWhatAnAddressTakes) {
  OrbitCamera camera;
  for (int i = 0; i < 100; ++i) {
    orbit(camera, 333, 17, 100);
    zoom(camera, i < 50 ? 5 : -5);
    ViewState state;
    state.camera = camera;
    const ViewState read = parse_state(state_text(state));
    EXPECT_EQ(read.camera.yaw_deg, camera.yaw_deg);
    EXPECT_EQ(read.camera.distance, camera.distance);
  }
}

TEST(OrbitInput, TheLightFollowsTheHand) {
  constexpr ImageSize kPicture = {200, 100};
  OrbitCamera camera;  // at -X, looking along +X
  camera.yaw_deg = 180, camera.pitch_deg = 0;
  // A light ahead (at +X) dragged to the right must come to be at -Y.
  EXPECT_NEAR(dragged_light({}, camera, 100, 0, kPicture).yaw_deg, -90, 1e-12);
  EXPECT_NEAR(dragged_light({.yaw_deg = 170}, camera, -100, 0, kPicture).yaw_deg, -100, 1e-12) << "wrapped";
  // Dragged up, it comes to be above.
  const Turn up = dragged_light({}, camera, 0, -25, kPicture);
  EXPECT_LT(length(turned(up) * Vec3{1, 0, 0} - normalize(Vec3{1, 0, 1})), 1e-6);
}

// Wherever the eye is and however the light is turned already, what is ahead goes where the hand goes.
TEST(OrbitInput, WhatIsAheadGoesUpWithTheHand) {
  int checked = 0;
  for (const double eye_yaw : {-100.0, 0.0, 65.0}) {
    for (const Turn& before : {Turn(), Turn{30, 50, -70}, Turn{-120, -88, 10}, Turn{0, 90, 0}}) {
      OrbitCamera camera;
      camera.yaw_deg = eye_yaw, camera.pitch_deg = 0;
      const Vec3 ahead = -1.0 * camera_matrices(camera, 1).eye, up = {0, 0, 1};
      const Vec3 there = transpose(turned(before)) * normalize(ahead);  // as the light knows it
      const Turn after = dragged_light(before, camera, 0, -10, {200, 100});
      const Vec3 now = turned(after) * there;
      EXPECT_NEAR(degrees(std::asin(dot(now, up))), 18, 1e-2) << eye_yaw;
      EXPECT_NEAR(dot(now, normalize(ahead)), std::cos(radians(18)), 1e-3) << "and not aside";
      ++checked;
    }
  }
  EXPECT_EQ(checked, 12);
}

}  // namespace
}  // namespace zonal
