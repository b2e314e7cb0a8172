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

double dragged_light_yaw_deg(double yaw_deg, double dx_px, int width_px) {
  if (width_px < 1) return yaw_deg;
  // What is in front of the eye goes to the right as its yaw falls.
  return wrapped_deg(yaw_deg - 180.0 * dx_px / width_px);
}

}  // namespace zonal
