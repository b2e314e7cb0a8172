#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/math/legendre.h"
#include "zonal/sh/basis_constants.h"
#include "zonal/sh/sh.h"

namespace zonal {

namespace basis_detail {

/// The functions of order m from band l on: sin^m cos(m phi) and sin^m sin(m phi) times a polynomial in z. `now` and
/// `before` are the polynomials of the two bands below l.
template <int N, int m, int l, class Scalar, class T, class Out>
[[gnu::always_inline]] constexpr void column(T z, T before, T now, T cosine, T sine, Out out) {
  constexpr double start = kBasisConstants<N>.start[m], slope = kBasisConstants<N>.slope[l][m],
                   offset = kBasisConstants<N>.offset[l][m];
  T next = {};
  if constexpr (l == m) {
    next = T{} + static_cast<Scalar>(start);
  } else if constexpr (l == m + 1) {
    next = static_cast<Scalar>(slope * start) * z;
  } else if constexpr (l == m + 2) {
    next = static_cast<Scalar>(slope) * z * now - static_cast<Scalar>(offset * start);
  } else {
    next = static_cast<Scalar>(slope) * z * now - static_cast<Scalar>(offset) * before;
  }
  if constexpr (m == 0) {
    out[coefficient_index(l, 0)] = next;
  } else {
    out[coefficient_index(l, m)] = next * cosine;
    out[coefficient_index(l, -m)] = next * sine;
  }
  if constexpr (l + 1 < N) column<N, m, l + 1, Scalar>(z, now, next, cosine, sine, out);
}

/// The functions of order m and above.
template <int N, int m, class Scalar, class T, class Out>
[[gnu::always_inline]] constexpr void columns(T x, T y, T z, T cosine, T sine, Out out) {
  column<N, m, m, Scalar>(z, T{}, T{}, cosine, sine, out);
  if constexpr (m + 1 < N && m == 0) columns<N, 1, Scalar>(x, y, z, x, y, out);
  if constexpr (m + 1 < N && m > 0) {
    columns<N, m + 1, Scalar>(x, y, z, x * cosine - y * sine, x * sine + y * cosine, out);
  }
}

}  // namespace basis_detail

/// The N^2 basis functions at the unit direction (x, y, z) into out, unrolled by the compiler: no loop, no branch, no
/// table in memory. T may be a SIMD vector of Scalars, and `out` anything with an operator[]. (Neither lambda nor
/// library call: kernels use it, which must not share code.)
template <int N, class T, class Scalar = T, class Out = T*>
[[gnu::always_inline]] constexpr void basis_unrolled(T x, T y, T z, Out out) {
  basis_detail::columns<N, 0, Scalar>(x, y, z, T{} + Scalar(1), T{}, out);
}

/// Calls visit(i, y_i(direction)) for each basis function of any number of bands, in order of |m|. In double.
/// O(bands^2). The addition theorem holds to 2e-11 for 1000 bands; not for more than 1800.
template <class Visit>
void visit_basis(int bands, Vec3 direction, Visit&& visit) {
  const double sin_theta = std::hypot(direction.x, direction.y);
  // At the poles phi is anything: the sine's powers are zero there.
  const double cos_phi = sin_theta > 0 ? direction.x / sin_theta : 1,
               sin_phi = sin_theta > 0 ? direction.y / sin_theta : 0;
  std::vector<double> column(static_cast<std::size_t>(bands));
  double cosine = 1, sine = 0;
  for (int m = 0; m < bands; ++m) {
    associated_legendre(m, direction.z, sin_theta, std::span(column).first(static_cast<std::size_t>(bands - m)));
    for (int l = m; l < bands; ++l) {
      const double value = column[static_cast<std::size_t>(l - m)];
      visit(coefficient_index(l, m), value * cosine);
      if (m > 0) visit(coefficient_index(l, -m), value * sine);
    }
    const double next = cosine * cos_phi - sine * sin_phi;
    sine = sine * cos_phi + cosine * sin_phi;
    cosine = next;
  }
}

/// The bands^2 basis functions at a unit direction. T is float or double; up to 6 bands are computed in it, more in
/// double.
template <class T>
void basis(int bands, Vec3 direction, std::span<T> out) {
  check(bands >= 1 && out.size() == static_cast<std::size_t>(coefficient_count(bands)),
        "one value for each basis function");
  with_static_bands(bands, [&]<int N>() {
    if constexpr (N == kDynamic) {
      visit_basis(bands, direction,
                  [&](int i, double value) { out[static_cast<std::size_t>(i)] = static_cast<T>(value); });
    } else {
      basis_unrolled<N, T>(static_cast<T>(direction.x), static_cast<T>(direction.y), static_cast<T>(direction.z),
                           out.data());
    }
  });
}

/// The value of the function at a unit direction. Up to 6 bands in T's own precision, more in double.
template <class T, int N>
T evaluate(const Sh<T, N>& sh, Vec3 direction) {
  if constexpr (N != kDynamic && N <= kMaxStaticBands) {
    using Scalar = ScalarOf<T>;
    std::array<Scalar, static_cast<std::size_t>(coefficient_count(N))> y;
    basis_unrolled<N, Scalar>(static_cast<Scalar>(direction.x), static_cast<Scalar>(direction.y),
                              static_cast<Scalar>(direction.z), y.data());
    T sum = {};
    for (std::size_t i = 0; i < y.size(); ++i) sum += y[i] * sh[i];
    return sum;
  } else {
    WideOf<T> sum = {};
    visit_basis(sh.bands(), direction,
                [&](int i, double value) { sum += value * static_cast<WideOf<T>>(sh[static_cast<std::size_t>(i)]); });
    return static_cast<T>(sum);
  }
}

}  // namespace zonal
