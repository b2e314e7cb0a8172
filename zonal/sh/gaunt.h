#pragma once

#include <cstdint>
#include <span>

#include "zonal/sh/sh.h"

namespace zonal {

/// The integral of y_i y_j y_k over the sphere, i <= j <= k; the same for every order of i, j, k (Gaunt 1929, in the
/// real basis without Condon-Shortley sign).
struct GauntIntegral {
  std::uint8_t i, j, k;
  double value;
};

/// Every integral of `bands` bands that is not zero, 1 <= bands <= 6, sorted by k, j, i: 1, 4, 25, 77, 238, 549 of
/// them. Computed by the compiler, to a few roundings (gaunt_list.h).
std::span<const GauntIntegral> gaunt_integrals(int bands);

}  // namespace zonal
