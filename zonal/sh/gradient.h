#pragma once

#include <type_traits>

#include "zonal/math/vec.h"
#include "zonal/sh/jet.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// Value and gradient of a function of any number of bands at a unit direction, poles included. In double; no heap on
/// static bands. JetEvaluator (jet.h) for many directions, or for second derivatives.
template <class T, int N>
ValueAndGradient evaluate_with_gradient(const Sh<T, N>& sh, Vec3 direction) {
  static_assert(std::is_floating_point_v<T>, "each channel of a colour has a gradient of its own");
  const Sh<double, N> wide = cast<double>(sh);
  return value_and_gradient(wide.values(), sh.bands(), direction);
}

/// The gradient alone.
template <class T, int N>
Vec3 gradient(const Sh<T, N>& sh, Vec3 direction) {
  return evaluate_with_gradient(sh, direction).gradient;
}

}  // namespace zonal
