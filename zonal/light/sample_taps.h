#pragma once

#include <cmath>

#include "zonal/math/vec.h"

// Interpolation in one smooth chart, the three channels in one vector. Kernels include this too, so everything has
// internal linkage: else the linker could give everybody the copy that was compiled for the strongest instruction set.
namespace zonal {
namespace {

using Float4 = float __attribute__((vector_size(16)));  // r, g, b, and a lane nobody reads

inline Float4 load(const Rgb& c) { return Float4{c.r, c.g, c.b, 0}; }
inline Rgb to_rgb(Float4 v) { return {v[0], v[1], v[2]}; }

template <class V>
inline V absolute(V v) {
  return v < 0 ? -v : v;
}
template <class V>
inline V lesser(V a, V b) {
  return a < b ? a : b;
}
template <class V>
inline V greater(V a, V b) {
  return a > b ? a : b;
}

/// A cubic through b and c (Catmull & Rom 1974), t of the way between them, written as the straight line minus the
/// curvature at both ends: line - t(1-t)/2 ((1-t) C_b + t C_c) with C_b = a - 2b + c, C_c = b - 2c + d. The curvature
/// is limited:
/// - none where C_b and C_c disagree in sign, and neither more than four times the other: a sun's neighbour stays
/// straight;
/// - at most half of the second smallest of |a|, |b|, |c|, |d|.
/// So the curve leaves its texels by at most a sixteenth of that, is never negative where they are not, and a smooth
/// extreme keeps its full height. (A sun, alone among small values, is interpolated by straight lines, whose total
/// energy is its own. The second smallest, because the smallest may just happen to be zero.)
template <class V>
inline V limited_cubic(V a, V b, V c, V d, V t) {
  const V bend_b = a - 2 * b + c, bend_c = b - 2 * c + d;
  const V most_b = absolute(bend_b), most_c = absolute(bend_c);
  const V level_a = absolute(a), level_d = absolute(d), level_b = absolute(b), level_c = absolute(c);
  const V second = lesser(greater(lesser(level_a, level_b), lesser(level_c, level_d)),
                          lesser(greater(level_a, level_b), greater(level_c, level_d)));
  V limit = lesser(4 * lesser(most_b, most_c), 0.5f * second);
  limit = bend_b * bend_c > 0 ? limit : V{};
  const V sum = (1 - t) * lesser(most_b, limit) + t * lesser(most_c, limit);
  const V bend = bend_b < 0 ? -sum : sum;
  return b + t * (c - b) - 0.5f * t * (1 - t) * bend;
}

}  // namespace
}  // namespace zonal
