#pragma once

#include <cmath>

#include "zonal/math/vec.h"

namespace zonal {

/// The solid angle of the triangle with corners a, b, c (any lengths) seen from the origin, given its determinant
/// dot(a, cross(b, c)) (van Oosterom & Strackee 1983, eq. 8). For small triangles the determinant must come from where
/// it does not cancel: in a plane at distance 1 it is twice the triangle's area. Signed like the determinant.
inline double solid_triangle(Vec3 a, Vec3 b, Vec3 c, double determinant) {
  const double la = length(a), lb = length(b), lc = length(c);
  return 2 * std::atan2(determinant, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

}  // namespace zonal
