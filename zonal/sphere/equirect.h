#pragma once

#include <cmath>
#include <optional>

#include "zonal/math/vec.h"
#include "zonal/sphere/pixel.h"
#include "zonal/sphere/projection.h"

namespace zonal {

/// Latitude-longitude: x is the azimuth from the +X centre toward -Y, y the angle from +Z. The members are those of
/// Mapping.
class Equirect {
 public:
  explicit Equirect(ImageSize size) : size_(size) {}

  std::optional<Vec3> direction(PixelPoint p) const {
    if (!(p.x >= 0 && p.x <= size_.width && p.y >= 0 && p.y <= size_.height)) return std::nullopt;
    const double azimuth = 2 * kPi * (0.5 - p.x / size_.width);
    const double polar = kPi * (p.y / size_.height);
    const double s = std::sin(polar);
    return Vec3{s * std::cos(azimuth), s * std::sin(azimuth), std::cos(polar)};
  }

  std::optional<PixelPoint> position(Vec3 d) const {
    // atan2 rather than acos: acos loses half the digits at the poles.
    const double azimuth = std::atan2(d.y, d.x);
    const double polar = std::atan2(std::sqrt(d.x * d.x + d.y * d.y), d.z);
    return PixelPoint{size_.width * (0.5 - azimuth / (2 * kPi)), size_.height * (polar / kPi)};
  }

  double solid_angle(int x, int y) const;
  std::optional<Vec3> texel_direction(int x, int y) const { return direction(center_of({x, y})); }
  Texel nearest(Vec3 toward) const;
  bool covers_sphere() const { return true; }

  int chart(PixelPoint) const { return 0; }
  Texel wrap(int chart, int x, int y) const;
  bool regular(int chart, int x, int y, int size) const;

 private:
  ImageSize size_;
};

}  // namespace zonal
