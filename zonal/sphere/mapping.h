#pragma once

#include <optional>
#include <variant>

#include "zonal/math/vec.h"
#include "zonal/sphere/projection.h"

namespace zonal {

/// A point of a picture in pixels: (0, 0) is the outer corner of the top left texel, texel (i, j) is centred at (i+½, j+½).
struct PixelPoint {
  double x = 0, y = 0;
};

/// The geometry of one picture: a projection and a size. The one place where texels and directions meet.
class Mapping {
 public:
  /// Throws Error{kInput} when the size does not fit the projection (the hint names the sizes that would).
  Mapping(const Projection&, ImageSize);

  /// The unit direction that a point of the picture shows; nullopt where it shows nothing (outside a circle, in a cross's gap).
  std::optional<Vec3> direction(PixelPoint) const;
  /// Where the picture shows a unit direction; nullopt where it does not. direction(*position(d)) == d to rounding.
  std::optional<PixelPoint> position(Vec3 toward) const;
  /// The solid angle of texel (x, y) in steradians, exact to rounding; over a full picture they sum to 4π. Texels cut by a circle's
  /// rim count with the part inside.
  double solid_angle(int x, int y) const;
};

}  // namespace zonal
