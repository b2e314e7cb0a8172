#pragma once

#include <optional>

#include "zonal/image/image.h"
#include "zonal/math/vec.h"

namespace zonal {

/// A soft disc of linear light.
struct Brush {
  double radius = 0.12;   ///< in widths of the picture, above 0
  Rgb light = {1, 1, 1};  ///< what it leaves in its middle, as bright as it is; black erases
};

/// How much a brush covers at a distance from its middle: (1 - (distance/radius)^2)^2 within the radius, nothing
/// outside. Smooth at both ends, so that no edge of a disc is seen.
double brush_cover(double distance, double radius);

/// One stroke over a square picture. A texel is covered as much as the nearest point of the whole stroke covers it, and
/// what was there before shows through the rest: slow and fast hands leave the same, however many points they are
/// reported in along a straight line. The script of the page does the same (page/paint.js).
class Stroke {
 public:
  /// std::logic_error for a picture that is not square or a radius that is not above 0.
  Stroke(Image<Rgb> before, const Brush&);

  /// Straight on to a point, (0, 0) the top left corner and (1, 1) the opposite one; the first one is a dab. Points
  /// outside are fine. O(texels near the line).
  void move_to(double u, double v);
  const Image<Rgb>& picture() const { return picture_; }

 private:
  struct Point {
    double u, v;
  };
  Image<Rgb> before_, picture_;
  Image<float> covered_;
  Brush brush_;
  std::optional<Point> last_;
};

}  // namespace zonal
