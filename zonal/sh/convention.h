#pragma once

#include "zonal/sh/sh.h"

namespace zonal {

/// The Condon-Shortley sign (-1)^m is its own inverse; to_ and from_ say at the place of the call which way it is
/// meant.
template <class T, int N>
constexpr Sh<T, N> to_condon_shortley(Sh<T, N> plain) {
  for (int l = 1; l < plain.bands(); ++l) {
    for (int m = -l; m <= l; ++m) {
      if (m % 2 != 0) plain(l, m) = ScalarOf<T>(-1) * plain(l, m);
    }
  }
  return plain;
}

/// Coefficients of a basis with the Condon-Shortley sign (DirectXMath, the SH-tricks paper) to ours.
template <class T, int N>
constexpr Sh<T, N> from_condon_shortley(const Sh<T, N>& signed_coefficients) {
  return to_condon_shortley(signed_coefficients);
}

}  // namespace zonal
