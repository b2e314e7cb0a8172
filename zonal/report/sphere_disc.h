#pragma once

#include <cmath>
#include <type_traits>

#include "zonal/base/check.h"
#include "zonal/image/image.h"
#include "zonal/math/vec.h"

namespace zonal {

// The whole sphere as one disc, like a ball whose far side has been pulled round to its rim: the distance from the
// middle is the angle from the viewer. As with draw_ball(), the viewer stands on the +X side, with +Z up and +Y to the
// right, so that a disc of radiance and a matte ball beside it have the same light on the same side.

/// A place in a square picture: 0..1 from the left and from the top.
struct DiscPlace {
  double x = 0, y = 0;
};

/// Where the disc shows a unit direction; -X, which is all of the rim, at its right.
inline DiscPlace sphere_disc_place(Vec3 toward) {
  const double sine = std::hypot(toward.y, toward.z);
  const double radius = std::atan2(sine, toward.x) / kPi;
  const double right = sine > 0 ? toward.y / sine : 1, up = sine > 0 ? toward.z / sine : 0;
  return {0.5 + 0.5 * radius * right, 0.5 - 0.5 * radius * up};
}

/// The unit direction that the disc shows at a place. Places outside the disc count as on its rim.
inline Vec3 sphere_disc_direction(DiscPlace place) {
  const double right = 2 * place.x - 1, up = 1 - 2 * place.y, radius = std::hypot(right, up);
  if (radius == 0) return {1, 0, 0};
  const double angle = kPi * (radius < 1 ? radius : 1), sine = std::sin(angle);
  return {std::cos(angle), sine * right / radius, sine * up / radius};
}

/// The disc of a function of unit directions whose values are Rgb or double: means over supersample^2 points of each
/// pixel. The whole square is filled: outside the disc the rim goes on.
template <class Function>
auto draw_sphere_disc(Function&& value, int size_px, int supersample = 1) {
  using Value = std::decay_t<decltype(value(Vec3{}))>;
  using Sum = std::conditional_t<std::is_same_v<Value, Rgb>, RgbD, Value>;
  check(size_px > 0 && supersample > 0, "a disc needs a positive size and at least one sample");
  Image<Value> disc(size_px, size_px);
  for (int y = 0; y < size_px; ++y) {
    for (int x = 0; x < size_px; ++x) {
      Sum sum = {};
      for (int j = 0; j < supersample; ++j) {
        for (int i = 0; i < supersample; ++i) {
          const DiscPlace place = {(x + (i + 0.5) / supersample) / size_px, (y + (j + 0.5) / supersample) / size_px};
          sum += static_cast<Sum>(value(sphere_disc_direction(place)));
        }
      }
      disc(x, y) = static_cast<Value>((1.0 / (supersample * supersample)) * sum);
    }
  }
  return disc;
}

}  // namespace zonal
