#pragma once

#include <array>
#include <numbers>

namespace zonal {

/// std::sqrt is not constexpr. Newton in extended precision; within an ulp of the double.
constexpr double constexpr_sqrt(double square) {
  if (square <= 0) return 0;
  long double root = square > 1 ? square : 1;
  for (long double next = (root + square / root) / 2; next < root; next = (root + square / root) / 2) root = next;
  return static_cast<double>(root);
}

/// What the recurrence of the first N bands needs, computed by the compiler. With q_{l,m} the normalised associated
/// function divided by sin(theta)^m (the sqrt(2) of m > 0 included):
///   q_{m,m} = start[m],  q_{l,m} = slope[l][m] z q_{l-1,m} - offset[l][m] q_{l-2,m}.
template <int N>
struct BasisConstants {
  std::array<double, N> start = {};
  std::array<std::array<double, N>, N> slope = {};
  std::array<std::array<double, N>, N> offset = {};

  constexpr BasisConstants() {
    double square = 1 / (4 * std::numbers::pi);
    for (int m = 0; m < N; ++m) {
      if (m > 0) square *= (2.0 * m + 1) / (2.0 * m);
      start[m] = constexpr_sqrt(m > 0 ? 2 * square : square);
      for (int l = m + 1; l < N; ++l) {
        slope[l][m] = constexpr_sqrt(slope_squared(l, m));
        if (l > m + 1) offset[l][m] = constexpr_sqrt(slope_squared(l, m) / slope_squared(l - 1, m));
      }
    }
  }

  static constexpr double slope_squared(int l, int m) { return (4.0 * l * l - 1) / (1.0 * l * l - 1.0 * m * m); }
};

template <int N>
inline constexpr BasisConstants<N> kBasisConstants;

}  // namespace zonal
