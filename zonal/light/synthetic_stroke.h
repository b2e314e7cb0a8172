#pragma once

#include <string_view>
#include <vector>

#include "zonal/math/vec.h"

namespace zonal {

/// A word drawn on the sphere as great-circle strokes, so that it looks the same in every projection.
class SphereText {
 public:
  /// The word stands upright for a viewer at the origin, centred at `center` (unit) with `up` (unit, orthogonal) above.
  /// `height` is the size of a capital as a tangent of the angle. Knows 0-9, X, Y, Z, + and -; throws std::logic_error
  /// for anything else.
  SphereText(std::string_view word, Vec3 center, Vec3 up, double height);

  /// Whether a direction lies on a stroke.
  bool covers(Vec3 toward) const;

 private:
  struct Stroke {
    Vec3 from, to;
  };

  Vec3 center_;
  double cos_reach_;  // of the circle around the centre that holds all strokes
  double cos_half_pen_, sin_half_pen_;
  std::vector<Stroke> strokes_;
};

}  // namespace zonal
