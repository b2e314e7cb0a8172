#pragma once

#include <cmath>

#include "zonal/base/check.h"
#include "zonal/math/vec.h"

namespace zonal {

/// A rotation that takes +Z to `toward`, a unit direction to 1e-6; its turn about that axis is left open, except that
/// the identity belongs to +Z. Stable next to -Z too (Duff et al. 2017, after Frisvad 2012).
inline Rotation turn_z_to(Vec3 toward) {
  const double size = length(toward);
  check(std::abs(size - 1) <= 1e-6, "turn_z_to needs a unit direction");  // false for NaN as well
  const auto [x, y, z] = (1 / size) * toward;
  const double sign = std::copysign(1.0, z), a = -1 / (sign + z), b = x * y * a;
  const Vec3 tangent = {1 + sign * x * x * a, sign * b, -sign * x}, other = {b, sign + y * y * a, -y};
  return transpose({{tangent, other, Vec3{x, y, z}}});
}

}  // namespace zonal
