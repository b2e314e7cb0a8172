#pragma once

#include <span>

namespace zonal {

/// P_0(x) .. P_{n-1}(x), n = values.size(), x in [-1, 1]. Absolute error a few 1e-15 up to n in the thousands. O(n).
void legendre(double x, std::span<double> values);

/// The same at x = 1 - versine, versine in [0, 2]: keeps all digits next to x = 1, where 1 - x would be rounded.
void legendre_from_versine(double versine, std::span<double> values);

/// P_l'(x) for every l, given the P_l(x). Exact at x = +-1 too.
void legendre_derivatives(std::span<const double> values, std::span<double> derivatives);

/// The associated functions, fully normalised for the real harmonics and without the Condon-Shortley sign: values[k]
/// belongs to l = m + k, and with it y_{l,m} = value cos(m phi), y_{l,-m} = value sin(m phi); the sqrt(2) of m > 0 is
/// included. cos_theta^2 + sin_theta^2 = 1, sin_theta >= 0. Recurrence in l (Holmes & Featherstone 2002, eq. 11).
/// sin_theta^m underflows to zero near the poles, which costs accuracy only from l = 1800 on.
void associated_legendre(int m, double cos_theta, double sin_theta, std::span<double> values);

}  // namespace zonal
