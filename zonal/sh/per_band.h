#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "zonal/sh/sh.h"

namespace zonal {

/// One value for each band l = 0..bands-1; on static bands without the heap.
template <class T, int N>
using PerBand =
    std::conditional_t<N == kDynamic, std::vector<T>, std::array<T, static_cast<std::size_t>(N == kDynamic ? 0 : N)>>;

template <class T, int N>
constexpr PerBand<T, N> per_band(int bands) {
  PerBand<T, N> values = {};
  if constexpr (N == kDynamic) values.resize(static_cast<std::size_t>(bands));
  return values;
}

}  // namespace zonal
