#pragma once

#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/math/legendre.h"
#include "zonal/math/quadrature.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// What project_function() makes of a function with this value: double, or RgbD of a colour.
template <class F>
using ProjectedValue = WideOf<std::decay_t<std::invoke_result_t<F&, Vec3>>>;

namespace project_function_detail {

inline bool is_finite(double value) { return std::isfinite(value); }
inline bool is_finite(RgbD value) { return std::isfinite(value.r) && std::isfinite(value.g) && std::isfinite(value.b); }

[[noreturn]] inline void fail(Vec3 d, const std::string& what) {
  const std::string at = std::to_string(d.x) + ", " + std::to_string(d.y) + ", " + std::to_string(d.z);
  throw Error(ErrorKind::kInput, "the function to be projected " + what + " at (" + at + ")",
              "it must have a finite value in every direction");
}

template <class F>
ProjectedValue<F> value_at(F& f, Vec3 direction) {
  try {
    const auto value = static_cast<ProjectedValue<F>>(std::invoke(f, direction));
    if (!is_finite(value)) fail(direction, "is not finite");
    return value;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    fail(direction, std::string("failed (") + e.what() + ")");
  } catch (...) {
    fail(direction, "failed");
  }
}

}  // namespace project_function_detail

/// The coefficients of f(Vec3 unit direction) -> real number or colour: integrals of f y_lm over the sphere. Exact but
/// for rounding where f is a polynomial in x, y, z of at most this `degree` (a function of N bands has degree N-1); for
/// any other f the answer converges as `degree` grows, as fast as polynomials approach f. The rule: n rows of
/// Gauss-Legendre in z, 2n equal steps in phi, n = ceil((degree + bands)/2); it never looks at a pole. f is called once
/// for each of the 2n^2 directions, in the same order always. O(n^2 bands + n bands^2). bands >= 1, degree >= 0, both
/// at most 1800. Throws Error{kInput} that names the direction where f throws (an Error of its own passes as it is) or
/// is not finite.
template <class F>
Sh<ProjectedValue<F>> project_function(F&& f, int bands, int degree) {
  using Value = ProjectedValue<F>;
  check(bands >= 1 && bands <= 1800, "project_function: 1 to 1800 bands");
  check(degree >= 0 && degree <= 1800, "project_function: a degree from 0 to 1800");
  const int rows = (degree + bands + 1) / 2, steps = 2 * rows;
  const Quadrature gauss = gauss_legendre(rows);
  const auto count = static_cast<std::size_t>(steps);
  std::vector<double> cosines(count), sines(count);
  for (std::size_t k = 0; k < count; ++k) {
    cosines[k] = std::cos(2 * kPi * static_cast<double>(k) / steps);
    sines[k] = std::sin(2 * kPi * static_cast<double>(k) / steps);
  }

  Sh<Value> sh(bands);
  std::vector<Value> ring(count);
  std::vector<double> column(static_cast<std::size_t>(bands));
  for (std::size_t row = 0; row < gauss.size(); ++row) {
    const double z = gauss.nodes[row], r = std::sqrt((1 - z) * (1 + z)), weight = gauss.weights[row] * 2 * kPi / steps;
    for (std::size_t k = 0; k < count; ++k) {
      ring[k] = project_function_detail::value_at(f, Vec3{r * cosines[k], r * sines[k], z});
    }
    for (int m = 0; m < bands; ++m) {
      Value even = {}, odd = {};  // of the ring, times cos(m phi) and sin(m phi)
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t turn = static_cast<std::size_t>(m) * k % count;
        even += cosines[turn] * ring[k];
        odd += sines[turn] * ring[k];
      }
      associated_legendre(m, z, r, std::span(column).first(static_cast<std::size_t>(bands - m)));
      for (int l = m; l < bands; ++l) {
        const double factor = weight * column[static_cast<std::size_t>(l - m)];
        sh(l, m) += factor * even;
        if (m > 0) sh(l, -m) += factor * odd;
      }
    }
  }
  return sh;
}

}  // namespace zonal
