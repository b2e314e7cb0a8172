#include "apps/viewer/orbit_input.h"

#include <algorithm>
#include <cmath>

namespace zonal {

double wrapped_deg(double angle_deg) { return std::remainder(angle_deg, 360); }

void orbit(OrbitCamera& camera, double dx_px, double dy_px, int height_px) {
  if (height_px < 1) return;
  const double degrees_a_pixel = 180.0 / height_px;
  camera.yaw_deg = wrapped_deg(camera.yaw_deg - degrees_a_pixel * dx_px);
  camera.pitch_deg = std::clamp(camera.pitch_deg + degrees_a_pixel * dy_px, -89.0, 89.0);
}

void zoom(OrbitCamera& camera, double steps) {
  camera.distance = std::clamp(camera.distance * std::pow(0.9, steps), 1.2, 20.0);
}

Turn dragged_light(const Turn& turn, const OrbitCamera& camera, double dx_px, double dy_px, ImageSize size) {
  if (size.width < 1 || size.height < 1) return turn;
  Turn dragged = turn;
  // What is in front of the eye goes to the right as the yaw falls, and down by a negative turn about the eye's right.
  dragged.yaw_deg = wrapped_deg(turn.yaw_deg - 180.0 * dx_px / size.width);
  if (dy_px == 0) return dragged;
  const double eye_yaw = radians(camera.yaw_deg);
  const Vec3 right = {-std::sin(eye_yaw), std::cos(eye_yaw), 0};
  dragged = turn_of(Rotation::about(right, radians(-180.0 * dy_px / size.height)) * turned(dragged));
  const auto rounded = [](double angle_deg) { return std::round(1000 * angle_deg) / 1000; };
  return {rounded(dragged.yaw_deg), rounded(dragged.pitch_deg), rounded(dragged.roll_deg)};
}

}  // namespace zonal
