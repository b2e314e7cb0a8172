#pragma once

#include "zonal/sh/axial_product.h"

namespace zonal {

// Products with two functions of infinitely many bands, projected exactly on the bands of the result (Sloan 2008, A8,
// lists both matrices for 6 bands): 1 on the half space of an axis and 0 behind it, and the clamped cosine
// max(d.axis, 0). Multiplying by their truncated coefficients would be wrong by what is cut.

/// H_ij = integral of y_i y_j over z > 0.
template <int N = kDynamic>
AxialProduct<N> half_space(int bands = N) {
  check(bands >= 1, "half_space needs at least one band");
  // Polynomials of degree 2 (bands-1) on [0, 1].
  return AxialProduct<N>(
      gauss_legendre(bands, 0, 1), [](double) { return 1.0; }, bands);
}

/// C_ij = integral of y_i y_j max(z, 0).
template <int N = kDynamic>
AxialProduct<N> clamped_cosine(int bands = N) {
  check(bands >= 1, "clamped_cosine needs at least one band");
  return AxialProduct<N>(
      gauss_legendre(bands, 0, 1), [](double z) { return z; }, bands);
}

/// f where d.axis > 0, zero elsewhere, with the bands of f. `axis` is a unit vector. O(bands^3). Up to 6 static bands
/// the matrix is made by the first call of the program; later ones take no heap.
template <class T, int N>
Sh<T, N> multiply_by_half_space(const Sh<T, N>& f, Vec3 axis = {0, 0, 1}) {
  if constexpr (N != kDynamic && N <= kMaxStaticBands) {
    static const AxialProduct<N> matrix = half_space<N>();
    return matrix.apply(f, axis);
  } else {
    return half_space(f.bands()).apply(f, axis);
  }
}

/// f times max(d.axis, 0), with the bands of f: radiance becomes what it brings to a surface of that normal. As above.
template <class T, int N>
Sh<T, N> multiply_by_clamped_cosine(const Sh<T, N>& f, Vec3 axis = {0, 0, 1}) {
  if constexpr (N != kDynamic && N <= kMaxStaticBands) {
    static const AxialProduct<N> matrix = clamped_cosine<N>();
    return matrix.apply(f, axis);
  } else {
    return clamped_cosine(f.bands()).apply(f, axis);
  }
}

}  // namespace zonal
