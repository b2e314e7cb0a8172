#pragma once

#include <array>
#include <span>

#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// The coefficients of a uniform polygon light: `radiance` wherever it is seen from the lit point, which is the origin
/// of `vertices`; zero elsewhere. Planar polygons of any shape that do not cross themselves, either way round; of a
/// loop of directions that is not planar, the smaller side. Nothing is cut off by a receiver's horizon. Exact in every
/// band, by integrals along the edges (docs/notes/polygon.md): absolute error a few eps times the sum of the edges'
/// angles, per unit radiance. A polygon seen edge-on gives zero. O(edges bands^2 (16 + edge angle bands)). Throws
/// Error{kUsage} for fewer than three vertices, a vertex or edge through the lit point, a polygon around it in its own
/// plane, and numbers that are not finite; bands >= 1, or std::logic_error.
Sh<RgbD> polygon_sh(std::span<const Vec3> vertices, RgbD radiance, int bands);

/// The solid angle of such a polygon in steradians, in [0, 2pi); the same domain and errors. Relative error a few eps
/// for triangles (Van Oosterom & Strackee 1983).
double polygon_solid_angle(std::span<const Vec3> vertices);

/// The corners of a rectangle, or of any parallelogram: center +- half_width +- half_height, in order around it.
constexpr std::array<Vec3, 4> rectangle_corners(Vec3 center, Vec3 half_width, Vec3 half_height) {
  return {center - half_width - half_height, center + half_width - half_height, center + half_width + half_height,
          center - half_width + half_height};
}

}  // namespace zonal
