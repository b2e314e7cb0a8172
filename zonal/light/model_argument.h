#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/base/error.h"
#include "zonal/math/vec.h"

namespace zonal {

/// The unit direction of a vector of any length. Throws Error{kUsage}, naming `what`, when it has none: zero, infinite
/// or not a number.
inline Vec3 direction_of(Vec3 v, const char* what) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!std::isfinite(v.x + v.y + v.z) || largest == 0) {
    throw Error(ErrorKind::kUsage, std::string(what) + " has no direction",
                "give a vector that is finite and not zero");
  }
  return normalize((1 / largest) * v);  // first to a size whose square neither overflows nor vanishes
}

/// Throws Error{kUsage}, naming `what`, where a colour is infinite or not a number. Negative light is allowed: all of
/// this is linear.
inline RgbD finite(RgbD color, const char* what) {
  if (!std::isfinite(color.r) || !std::isfinite(color.g) || !std::isfinite(color.b)) {
    throw Error(ErrorKind::kUsage, std::string(what) + " must be finite");
  }
  return color;
}

}  // namespace zonal
