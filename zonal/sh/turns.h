#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "zonal/sh/rotation_recurrence.h"
#include "zonal/sh/sh.h"

// Rotation of up to 6 bands as turns about Z and swaps of y and z: R = Z(a) Y(b) Z(c), and Y(b) is Z(-b) between two
// swaps (Pinchon & Hoggan 2007). A turn about Z mixes only m and -m; the swap is a constant matrix of which three
// quarters are zero. All unrolled, on coefficients V (a number, a colour or a SIMD vector) at angles of type S.
// (Neither lambdas nor library calls: kernels use this, which must not share code.)
namespace zonal::turns {

/// The swap of y and z on each band.
inline constexpr auto kSwap = [] {
  std::array<double, static_cast<std::size_t>(rotation_entries(kMaxStaticBands))> blocks = {};
  blocks[0] = 1;
  // Band 1 is the vector (y, z, x).
  blocks[1 + 1] = blocks[1 + 3] = blocks[1 + 8] = 1;
  rotation_detail::grow_few(blocks, kMaxStaticBands);
  return blocks;
}();

constexpr double swap_entry(int l, int m, int n) {
  const double entry = kSwap[static_cast<std::size_t>(rotation_entries(l) + (l + m) * (2 * l + 1) + l + n)];
  return -1e-9 < entry && entry < 1e-9 ? 0 : entry;  // the smallest that is not zero is 0.08, rounding leaves 1e-16
}

/// The first n' >= n with a part in row m; l + 1 where there is none.
constexpr int next_in_row(int l, int m, int n) {
  while (n <= l && swap_entry(l, m, n) == 0) ++n;
  return n;
}

/// The sum of row m from column n on, which is one with a part; band points at m = 0.
template <int l, int m, int n, class Scalar, class V>
[[gnu::always_inline]] inline V row_from(const V* band) {
  constexpr double entry = swap_entry(l, m, n);
  constexpr int next = next_in_row(l, m, n + 1);
  if constexpr (next > l) {
    if constexpr (entry > 1 - 1e-9) return band[n];
    return static_cast<Scalar>(entry) * band[n];
  } else {
    return static_cast<Scalar>(entry) * band[n] + row_from<l, m, next, Scalar>(band);
  }
}

template <class Scalar, int l, class V, int... m>
[[gnu::always_inline]] inline void swap_band(V* sh, std::integer_sequence<int, m...>) {
  const V* band = sh + coefficient_index(l, 0);
  const V swapped[] = {row_from<l, m - l, next_in_row(l, m - l, -l), Scalar>(band)...};
  ((sh[l * l + m] = swapped[m]), ...);
}

/// f(x, z, y) in place of f(x, y, z).
template <int N, class Scalar, int l = 1, class V>
[[gnu::always_inline]] inline void swap_yz(V* sh) {
  if constexpr (l < N) {
    swap_band<Scalar, l>(sh, std::make_integer_sequence<int, 2 * l + 1>());
    swap_yz<N, Scalar, l + 1>(sh);
  }
}

template <int l, int m, class V, class S>
[[gnu::always_inline]] inline void turn_pair(V* sh, S cosine, S sine) {
  V& even = sh[coefficient_index(l, m)];
  V& odd = sh[coefficient_index(l, -m)];
  const V before = even;
  even = cosine * before - sine * odd;
  odd = sine * before + cosine * odd;
}

template <int m, class V, class S, int... i>
[[gnu::always_inline]] inline void turn_order(V* sh, S cosine, S sine, std::integer_sequence<int, i...>) {
  (turn_pair<m + i, m>(sh, cosine, sine), ...);
}

/// Turns the orders m, 2m and 2m+1 and from there on, so that no angle is more than three steps from the first.
template <int N, int m = 1, class V, class S>
[[gnu::always_inline]] inline void turn_about_z(V* sh, S cosine, S sine, S cosine_m, S sine_m) {
  if constexpr (m < N) {
    turn_order<m>(sh, cosine_m, sine_m, std::make_integer_sequence<int, N - m>());
    if constexpr (2 * m < N) {
      const S twice = cosine_m * cosine_m - sine_m * sine_m, sine_twice = (sine_m + sine_m) * cosine_m;
      turn_about_z<N, 2 * m>(sh, cosine, sine, twice, sine_twice);
      if constexpr (2 * m + 1 < N) {
        turn_about_z<N, 2 * m + 1>(sh, cosine, sine, twice * cosine - sine_twice * sine,
                                   sine_twice * cosine + twice * sine);
      }
    }
  }
}

/// From f(d) to f(Z^T d), Z the turn about Z by the angle of this cosine and sine, x towards y.
template <int N, class V, class S>
[[gnu::always_inline]] inline void turn_about_z(V* sh, S cosine, S sine) {
  turn_about_z<N, 1>(sh, cosine, sine, cosine, sine);
}

/// Angles as cosines and sines.
template <class S>
struct Angles {
  S cos_a, sin_a, cos_b, sin_b, cos_c, sin_c;
};

/// Z(a) Y(b) Z(c).
template <int N, class Scalar, class V, class S>
[[gnu::always_inline]] inline void turn(V* sh, const Angles<S>& angles) {
  turn_about_z<N>(sh, angles.cos_c, angles.sin_c);
  swap_yz<N, Scalar>(sh);
  turn_about_z<N>(sh, angles.cos_b, -angles.sin_b);
  swap_yz<N, Scalar>(sh);
  turn_about_z<N>(sh, angles.cos_a, angles.sin_a);
}

}  // namespace zonal::turns
