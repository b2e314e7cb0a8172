#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "zonal/math/vec.h"
#include "zonal/sphere/pixel.h"

namespace zonal {

/// What both octahedral maps share: a square of n x n texels with +Z in the centre, the equator on the diamond |u| +
/// |v| = 1 and -Z in all four corners, u to the right and v down over [-1, 1]. One chart whose border is folded: (1, v)
/// is the place (1, -v).
class OctahedralSquare {
 public:
  explicit OctahedralSquare(int side) : side_(side) {}

  bool covers_sphere() const { return true; }
  int chart(PixelPoint) const { return 0; }
  Texel wrap(int chart, int x, int y) const;
  bool regular(int chart, int x, int y, int size) const;

 protected:
  bool contains(PixelPoint p) const { return p.x >= 0 && p.x <= side_ && p.y >= 0 && p.y <= side_; }
  double to_unit(double pixels) const { return 2 * pixels / side_ - 1; }
  /// Clamped, since a direction's length is 1 only to rounding.
  PixelPoint to_pixels(double u, double v) const {
    return {(0.5 * std::clamp(u, -1.0, 1.0) + 0.5) * side_, (0.5 * std::clamp(v, -1.0, 1.0) + 0.5) * side_};
  }
  Texel texel_at(PixelPoint p) const {
    return {std::min(static_cast<int>(p.x), side_ - 1), std::min(static_cast<int>(p.y), side_ - 1)};
  }

  int side_;
};

/// The octahedron itself unfolded: p = d / (|x| + |y| + |z|) (Meyer et al. 2010). Members as in Mapping.
class Octahedral : public OctahedralSquare {
 public:
  using OctahedralSquare::OctahedralSquare;

  std::optional<Vec3> direction(PixelPoint p) const {
    if (!contains(p)) return std::nullopt;
    const double u = to_unit(p.x), v = to_unit(p.y);
    const double z = 1 - std::abs(u) - std::abs(v);
    if (z >= 0) return normalize({u, v, z});
    return normalize({std::copysign(1 - std::abs(v), u), std::copysign(1 - std::abs(u), v), z});
  }

  std::optional<PixelPoint> position(Vec3 d) const {
    const double scale = 1 / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    const double u = d.x * scale, v = d.y * scale;
    if (d.z >= 0) return to_pixels(u, v);
    return to_pixels(std::copysign(1 - std::abs(v), u), std::copysign(1 - std::abs(u), v));
  }

  double solid_angle(int x, int y) const;
  std::optional<Vec3> texel_direction(int x, int y) const { return direction(center_of({x, y})); }
  Texel nearest(Vec3 toward) const { return texel_at(*position(toward)); }
};

/// The same folding with equal areas (Clarberg 2008): with r the distance from the nearer pole in the diamond's norm,
/// |z| = 1 - r², and the azimuth is linear along the diamond r = const. Members as in Mapping.
class EqualAreaOctahedral : public OctahedralSquare {
 public:
  using OctahedralSquare::OctahedralSquare;

  std::optional<Vec3> direction(PixelPoint p) const {
    if (!contains(p)) return std::nullopt;
    const double u = to_unit(p.x), v = to_unit(p.y);
    const double au = std::abs(u), av = std::abs(v);
    const bool upper = au + av <= 1;
    const double r = upper ? au + av : (1 - au) + (1 - av);
    const double z = (1 - r) * (1 + r);
    if (r <= 0) return Vec3{0, 0, upper ? 1.0 : -1.0};
    // v/r from 0 to 1 over a quadrant of azimuth; in the lower half the fold has exchanged u with 1 - v.
    const double azimuth = (kPi / 2) * ((upper ? av : 1 - au) / r);
    const double s = r * std::sqrt(1 + (1 - r) * (1 + r));  // sin of the polar angle: sqrt(1 - z²) = r sqrt(2 - r²)
    return Vec3{std::copysign(s * std::cos(azimuth), u), std::copysign(s * std::sin(azimuth), v), upper ? z : -z};
  }

  std::optional<PixelPoint> position(Vec3 d) const {
    const double ax = std::abs(d.x), ay = std::abs(d.y);
    const double r = std::sqrt((ax * ax + ay * ay) / (1 + std::abs(d.z)));  // sqrt(1 - |z|) without cancelling
    const double along = std::atan2(ay, ax) * (2 / kPi);
    const double av = r * along, au = r * (1 - along);
    if (d.z >= 0) return to_pixels(std::copysign(au, d.x), std::copysign(av, d.y));
    return to_pixels(std::copysign(1 - av, d.x), std::copysign(1 - au, d.y));
  }

  double solid_angle(int, int) const { return 4 * kPi / (static_cast<double>(side_) * side_); }
  std::optional<Vec3> texel_direction(int x, int y) const { return direction(center_of({x, y})); }
  Texel nearest(Vec3 toward) const { return texel_at(*position(toward)); }
};

}  // namespace zonal
