#pragma once

#include <cstddef>
#include <numbers>

#include "zonal/sh/gauss_rings.h"

// The product of two functions on rings of the sphere: from coefficients to the waves cos m phi and sin m phi on each
// ring, there the product of two waves is a wave of the sum and one of the difference of their m, and back. For the
// kernels that do so, as constants of the compiler.
namespace zonal {

/// The rings of GaussRings<N> as pairs that mirror each other at the equator: the northern one, and the southern one
/// where y_{l,m} is the same times (-1)^(l-m). A ring at the equator counts as two of half its weight.
template <int N>
struct RingTables {
  static constexpr int kPairs = static_cast<int>((GaussRings<N>::kRings + 1) / 2);
  /// [pair][l][m]: coefficients times `synthesis` are half the amplitudes of the waves (whole ones for m = 0).
  double synthesis[kPairs][N][N] = {};
  /// Such amplitudes times `analysis`, summed over both rings of each pair, are coefficients.
  double analysis[kPairs][N][N] = {};

  constexpr RingTables() {
    constexpr const GaussRings<N>& rings = kGaussRings<N>;
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
      const double weight = rings.weight[pair] / (2 * pair + 1 == rings.kRings ? 2 : 1);
      for (std::size_t l = 0; l < N; ++l) {
        for (std::size_t m = 0; m <= l; ++m) {
          synthesis[pair][l][m] = rings.q[pair][l][m] / (m == 0 ? 1 : 2);
          analysis[pair][l][m] = 2 * std::numbers::pi * weight * rings.q[pair][l][m];
        }
      }
    }
  }
};

}  // namespace zonal
