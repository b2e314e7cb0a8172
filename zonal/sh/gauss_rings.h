#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "zonal/sh/basis_constants.h"

namespace zonal {

/// Rings of the sphere on which the product of any three functions of N bands is integrated exactly (a polynomial of
/// degree 3 (N-1) in z after the integral over phi), computed by the compiler. math/quadrature.h has more digits for
/// many nodes, but not at compile time.
template <int N>
struct GaussRings {
  static constexpr std::size_t kRings = 3 * (N - 1) / 2 + 1;
  std::array<double, kRings> z = {};  ///< from the north down
  std::array<double, kRings> weight = {};
  /// q[ring][l][m], m >= 0: y_{l,m} without the cosine of m phi, y_{l,-m} without the sine.
  std::array<std::array<std::array<double, N>, N>, kRings> q = {};

  constexpr GaussRings() {
    for (std::size_t ring = 0; ring < kRings; ++ring) {
      find_node(ring);
      fill_basis(ring);
    }
  }

 private:
  /// The largest zero of P_n below the rings found so far: Newton with those divided out (Maehly 1954), from the right,
  /// where it cannot overshoot.
  constexpr void find_node(std::size_t ring) {
    constexpr int kMaxSteps = 100;  // each step at least takes 1/n of the way, near the end it squares the error
    constexpr int n = static_cast<int>(kRings);
    double x = 1, slope = 0;
    for (int step = 0; step < kMaxSteps; ++step) {
      double before = 0, now = 1;
      for (int l = 0; l < n; ++l) {
        const double next = ((2 * l + 1) * x * now - l * before) / (l + 1);
        before = now;
        now = next;
      }
      slope = x == 1 ? n * (n + 1) / 2.0 : n * (before - x * now) / (1 - x * x);
      if (now == 0) break;
      double rate = slope / now;
      for (std::size_t i = 0; i < ring; ++i) rate -= 1 / (x - z[i]);
      const double next = x - 1 / rate;
      if (next == x) break;
      x = next;
    }
    z[ring] = x;
    weight[ring] = 2 / ((1 - x * x) * slope * slope);
  }

  constexpr void fill_basis(std::size_t ring) {
    constexpr const BasisConstants<N>& k = kBasisConstants<N>;
    const double x = z[ring], sine = constexpr_sqrt(1 - x * x);
    double power = 1;
    for (std::size_t m = 0; m < N; ++m, power *= sine) {
      q[ring][m][m] = k.start[m] * power;
      for (std::size_t l = m + 1; l < N; ++l) {
        const double before = l >= m + 2 ? q[ring][l - 2][m] : 0;
        q[ring][l][m] = k.slope[l][m] * x * q[ring][l - 1][m] - k.offset[l][m] * before;
      }
    }
  }
};

template <int N>
inline constexpr GaussRings<N> kGaussRings;

}  // namespace zonal
