#include "zonal/light/orient.h"

#include <cmath>

namespace zonal {
namespace {

/// Right-hand rule about an axis of the frame; quarter turns without rounding.
Rotation turn(Vec3 axis, double angle_deg) {
  const double quarters = angle_deg / 90;
  if (quarters != std::round(quarters)) return Rotation::about(axis, radians(angle_deg));
  static constexpr double kCosine[] = {1, 0, -1, 0}, kSine[] = {0, 1, 0, -1};
  const int quarter = static_cast<int>(std::fmod(std::fmod(quarters, 4) + 4, 4));
  const double c = kCosine[quarter], s = kSine[quarter];
  Rotation r;
  const Vec3 units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 3; ++i) {
    // v -> c v + s axis x v + (1 - c)(axis · v) axis, transposed row by row.
    const Vec3 e = units[i];
    r.rows[i] = c * e - s * cross(axis, e) + (1 - c) * dot(axis, e) * axis;
  }
  return r;
}

}  // namespace

Rotation turned(double yaw_deg, double pitch_deg, double roll_deg) {
  // Up is a negative turn about +Y (which points left of a viewer along +X).
  return turn({0, 0, 1}, yaw_deg) * turn({0, 1, 0}, -pitch_deg) * turn({1, 0, 0}, roll_deg);
}

Turn turn_of(const Rotation& rotation) {
  const auto& [x, y, z] = rotation.rows;
  // The last row is (sin pitch, cos pitch sin roll, cos pitch cos roll), the first column (cos pitch cos yaw,
  // cos pitch sin yaw, sin pitch).
  const double level = std::hypot(z.y, z.z), pitch_deg = degrees(std::atan2(z.x, level));
  constexpr double kUpright = 1e-9;  // beyond the square root of roundings, roll and yaw are none of their own
  if (level < kUpright) return {degrees(std::atan2(-x.y, y.y)), pitch_deg, 0};
  return {degrees(std::atan2(y.x, x.x)), pitch_deg, degrees(std::atan2(z.y, z.z))};
}

}  // namespace zonal
