#pragma once

#include "zonal/math/vec.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// The mean of f(toward) over the n x n points of texel (x, y) that the picture shows; at the texel's own direction
/// when n is 1 or none of them is shown; T{} where the texel shows nothing. `map` is a Mapping or what its visit()
/// gives.
template <class T, class Map, class F>
T texel_mean(const Map& map, int x, int y, int n, const F& f) {
  T sum{};
  int shown = 0;
  for (int part = 0; n > 1 && part < n * n; ++part) {
    const auto toward = map.direction({x + (part % n + 0.5) / n, y + (part / n + 0.5) / n});
    if (!toward) continue;
    sum += f(*toward);
    ++shown;
  }
  if (shown > 0) return (1.0 / shown) * sum;
  const auto toward = map.texel_direction(x, y);
  return toward ? f(*toward) : T{};
}

}  // namespace zonal
