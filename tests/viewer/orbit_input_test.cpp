#include "apps/viewer/orbit_input.h"

#include <gtest/gtest.h>

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
  // The eye is at -X and looks along +X. A light ahead (at +X) dragged to the right must come to be at -Y.
  const double yaw = dragged_light_yaw_deg(0, 100, 200);
  EXPECT_NEAR(yaw, -90, 1e-12);
  EXPECT_NEAR(dragged_light_yaw_deg(170, -100, 200), -100, 1e-12) << "wrapped";
}

}  // namespace
}  // namespace zonal
