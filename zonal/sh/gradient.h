#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// A function's value at a direction and its gradient there: a tangent vector, in units of the value per radian, whose
/// dot product with a unit tangent is the derivative along it.
struct ValueAndGradient {
  double value = 0;
  Vec3 gradient;
};

/// The same for the bands^2 coefficients `sh`; `column` is room for one number a band.
ValueAndGradient value_and_gradient(std::span<const double> sh, int bands, Vec3 direction, std::span<double> column);

/// Value and gradient of a function of any number of bands at a unit direction, poles included; exact to rounding,
/// l times larger in band l. In double. O(bands^2); no heap up to 6 static bands.
template <class T, int N>
ValueAndGradient evaluate_with_gradient(const Sh<T, N>& sh, Vec3 direction) {
  static_assert(std::is_floating_point_v<T>, "each channel of a colour has a gradient of its own");
  if constexpr (N != kDynamic && N <= kMaxStaticBands) {
    const Sh<double, N> wide = cast<double>(sh);
    std::array<double, static_cast<std::size_t>(N)> column;
    return value_and_gradient(wide.values(), N, direction, column);
  } else {
    const Sh<double, N> wide = cast<double>(sh);
    std::vector<double> column(static_cast<std::size_t>(sh.bands()));
    return value_and_gradient(wide.values(), sh.bands(), direction, column);
  }
}

/// The gradient alone.
template <class T, int N>
Vec3 gradient(const Sh<T, N>& sh, Vec3 direction) {
  return evaluate_with_gradient(sh, direction).gradient;
}

}  // namespace zonal
