#include "zonal/sh/jet.h"

#include <cmath>

namespace zonal {
namespace {

constexpr int kMaxBands = 300;

/// The square of the recurrence's slope: see basis_constants.h.
double slope_squared(int l, int m) { return (4.0 * l * l - 1) / (1.0 * l * l - 1.0 * m * m); }

double band_norm(const Sh<double>& sh, int l) {
  double norm = 0;
  for (const double value : sh.band(l)) norm = std::hypot(norm, value);
  return norm;
}

}  // namespace

JetEvaluator::JetEvaluator(const Sh<double>& sh) : bands_(sh.bands()) {
  check(bands_ >= 1 && bands_ <= kMaxBands, "derivatives are for 1 to 300 bands");
  double square = 1 / (4 * kPi);
  for (int m = 0; m < bands_; ++m) {
    if (m > 0) square *= (2.0 * m + 1) / (2.0 * m);
    starts_.push_back(std::sqrt(m > 0 ? 2 * square : square));
    for (int l = m; l < bands_; ++l) {
      const double next = slope_squared(l + 1, m);
      terms_.push_back({.slope = std::sqrt(next),
                        .offset = l > m ? std::sqrt(next / slope_squared(l, m)) : 0,
                        .cosine = sh(l, m),
                        .sine = m > 0 ? sh(l, -m) : 0});
    }
  }
}

Jet JetEvaluator::operator()(Vec3 d) const {
  // The harmonics as polynomials of x, y and z: with q_{l,m}(z) as in basis_unrolled and (x + iy)^m = C_m + i S_m, the
  // column of m is A(z) C_m + B(z) S_m. Off the sphere any extension of the function will do.
  double value = 0, fx = 0, fy = 0, fz = 0, fxx = 0, fxy = 0, fxz = 0, fyz = 0, fzz = 0;
  double c0 = 1, s0 = 0, c1 = 0, s1 = 0, c2 = 0, s2 = 0;  // the powers m, m-1 and m-2
  const Term* term = terms_.data();
  for (int m = 0; m < bands_; ++m) {
    double a = 0, a1 = 0, a2 = 0, b = 0, b1 = 0, b2 = 0;
    double q = starts_[static_cast<std::size_t>(m)], q1 = 0, q2 = 0, before = 0, before1 = 0, before2 = 0;
    for (int l = m; l < bands_; ++l, ++term) {
      a += term->cosine * q, a1 += term->cosine * q1, a2 += term->cosine * q2;
      b += term->sine * q, b1 += term->sine * q1, b2 += term->sine * q2;
      const double next = term->slope * d.z * q - term->offset * before;
      const double next1 = term->slope * (q + d.z * q1) - term->offset * before1;
      const double next2 = term->slope * (2 * q1 + d.z * q2) - term->offset * before2;
      before = q, before1 = q1, before2 = q2;
      q = next, q1 = next1, q2 = next2;
    }
    value += a * c0 + b * s0;
    fz += a1 * c0 + b1 * s0;
    fzz += a2 * c0 + b2 * s0;
    fx += m * (a * c1 + b * s1);
    fy += m * (b * c1 - a * s1);
    fxz += m * (a1 * c1 + b1 * s1);
    fyz += m * (b1 * c1 - a1 * s1);
    fxx += m * (m - 1) * (a * c2 + b * s2);
    fxy += m * (m - 1) * (b * c2 - a * s2);
    c2 = c1, s2 = s1, c1 = c0, s1 = s0;
    c0 = d.x * c1 - d.y * s1;
    s0 = d.x * s1 + d.y * c1;
  }
  const double radial = fx * d.x + fy * d.y + fz * d.z;
  // Walking along the sphere bends toward its centre: the radial slope comes off the second derivative.
  return {.value = value,
          .gradient = Vec3{fx, fy, fz} - radial * d,
          .hessian_rows = {Vec3{fxx - radial, fxy, fxz}, Vec3{fxy, -fxx - radial, fyz}, Vec3{fxz, fyz, fzz - radial}}};
}

PrincipalCurvatures principal_curvatures(const Jet& jet, Vec3 d) {
  const Vec3 e = normalize(std::abs(d.z) < 0.7 ? cross(d, {0, 0, 1}) : cross(d, {1, 0, 0})), f = cross(d, e);
  const auto second = [&](Vec3 u, Vec3 v) {
    return dot(u, {dot(jet.hessian_rows[0], v), dot(jet.hessian_rows[1], v), dot(jet.hessian_rows[2], v)});
  };
  const double ee = second(e, e), ef = second(e, f), ff = second(f, f);
  const double mean = (ee + ff) / 2, difference = (ee - ff) / 2, radius = std::hypot(difference, ef);
  const double angle = std::atan2(ef, difference) / 2, c = std::cos(angle), s = std::sin(angle);
  return {mean - radius, mean + radius, c * f - s * e, c * e + s * f};
}

double derivative_bound(const Sh<double>& sh, int order) {
  check(order >= 0 && order <= 3, "bounds of derivatives up to the third");
  double sum = 0;
  for (int l = 1; l < sh.bands(); ++l) {
    // From P_l(x) = 1 + a (x-1)/2 + a (a-2) (x-1)^2/16 + a (a-2) (a-6) (x-1)^3/288 + ...
    const double a = 1.0 * l * (l + 1);
    const std::array squares = {1.0, a / 2, (3 * a - 2) * a / 8, ((5 * a - 10) * a + 8) * a / 16};
    sum += band_norm(sh, l) * std::sqrt((2 * l + 1) / (4 * kPi) * squares[static_cast<std::size_t>(order)]);
  }
  return sum;
}

}  // namespace zonal
