#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/sh.h"

namespace zonal {

// The complex basis of physics: Y_lm = (-1)^((m+|m|)/2) K_l|m| P_l^|m|(cos theta) e^(i m phi) with P without
// Condon-Shortley sign, K = sqrt((2l+1)(l-|m|)!/(4pi (l+|m|)!)): the factor carries that sign for m > 0, and none may
// be in P. Orthonormal with a conjugate: the integral of Y_a conj(Y_b) is 1 for a = b and 0 otherwise, and the
// coefficient of f is the integral of f conj(Y). From ours, for m > 0:
//   Y_{l,m} = (-1)^m (y_{l,m} + i y_{l,-m})/sqrt(2),   Y_{l,-m} = (y_{l,m} - i y_{l,-m})/sqrt(2).

/// The bands^2 complex basis functions at a unit direction.
inline void complex_basis(int bands, Vec3 direction, std::span<std::complex<double>> out) {
  std::vector<double> y(out.size());
  basis(bands, direction, std::span(y));
  for (int l = 0; l < bands; ++l) {
    out[static_cast<std::size_t>(coefficient_index(l, 0))] = y[static_cast<std::size_t>(coefficient_index(l, 0))];
    for (int m = 1; m <= l; ++m) {
      const auto plus = static_cast<std::size_t>(coefficient_index(l, m));
      const auto minus = static_cast<std::size_t>(coefficient_index(l, -m));
      const std::complex<double> wave = std::complex(y[plus], y[minus]) / std::numbers::sqrt2;
      out[plus] = m % 2 == 0 ? wave : -wave;
      out[minus] = std::conj(wave);
    }
  }
}

/// The coefficients of the same real function for the complex basis.
template <class T, int N>
Sh<std::complex<double>, N> to_complex_basis(const Sh<T, N>& sh) {
  Sh<std::complex<double>, N> result(sh.bands());
  for (int l = 0; l < sh.bands(); ++l) {
    result(l, 0) = sh(l, 0);
    for (int m = 1; m <= l; ++m) {
      const std::complex<double> half = std::complex<double>(sh(l, m), -sh(l, -m)) / std::numbers::sqrt2;
      result(l, m) = m % 2 == 0 ? half : -half;
      result(l, -m) = std::conj(half);
    }
  }
  return result;
}

/// The coefficients of a real function from those for the complex basis. Throws Error (kInput) where the function is
/// not real: where c_{l,-m} is not (-1)^m conj(c_{l,m}) to 1e-6 of the largest coefficient, or is not a number.
template <int N>
Sh<double, N> from_complex_basis(const Sh<std::complex<double>, N>& complex) {
  double largest = 0;
  for (const std::complex<double>& c : complex.values()) largest = std::max(largest, std::abs(c));
  const auto near = [&](std::complex<double> a, std::complex<double> b) { return std::abs(a - b) <= 1e-6 * largest; };
  bool real = true;
  Sh<double, N> result(complex.bands());
  for (int l = 0; l < complex.bands(); ++l) {
    result(l, 0) = complex(l, 0).real();
    real = real && near(complex(l, 0), complex(l, 0).real());
    for (int m = 1; m <= l; ++m) {
      const std::complex<double> plus = m % 2 == 0 ? complex(l, m) : -complex(l, m), minus = complex(l, -m);
      real = real && near(minus, std::conj(plus));
      result(l, m) = (plus + minus).real() / std::numbers::sqrt2;
      result(l, -m) = (minus - plus).imag() / std::numbers::sqrt2;
    }
  }
  if (!real) {
    throw Error(ErrorKind::kInput, "these complex coefficients belong to no real function",
                "c(l,-m) must be (-1)^m times the conjugate of c(l,m)");
  }
  return result;
}

}  // namespace zonal
