#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/math/legendre.h"
#include "zonal/sh/basis_constants.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// The N^2 basis functions at the unit direction (x, y, z) into out, unrolled by the compiler: no loop, no branch, no
/// table in memory.
template <int N, class T>
constexpr void basis_unrolled(T x, T y, T z, T* out) {
  constexpr const BasisConstants<N>& k = kBasisConstants<N>;
  // One column of equal m: sin^m cos(m phi) and sin^m sin(m phi) times a polynomial in z.
  const auto column = [&]<int m>(T cosine, T sine) {
    T before = 0, now = static_cast<T>(k.start[m]);
    const auto step = [&]<int l>() {
      if constexpr (l > m) {
        const T next = static_cast<T>(k.slope[l][m]) * z * now - static_cast<T>(k.offset[l][m]) * before;
        before = now;
        now = next;
      }
      if constexpr (m == 0) {
        out[coefficient_index(l, 0)] = now;
      } else {
        out[coefficient_index(l, m)] = now * cosine;
        out[coefficient_index(l, -m)] = now * sine;
      }
    };
    [&]<int... i>(std::integer_sequence<int, i...>) { (step.template operator()<m + i>(), ...); }
    (std::make_integer_sequence<int, N - m>());
  };
  T cosine = 1, sine = 0;
  [&]<int... m>(std::integer_sequence<int, m...>) {
    (
        [&] {
          column.template operator()<m>(cosine, sine);
          const T next = x * cosine - y * sine;
          sine = x * sine + y * cosine;
          cosine = next;
        }(),
        ...);
  }
  (std::make_integer_sequence<int, N>());
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
