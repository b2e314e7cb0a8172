#include "zonal/sh/jet.h"

#include <algorithm>
#include <cmath>

namespace zonal {
namespace {

/// The square of the recurrence's slope: see basis_constants.h.
double slope_squared(int l, int m) { return (4.0 * l * l - 1) / (1.0 * l * l - 1.0 * m * m); }

/// From q_{m-1,m-1} to q_{m,m}.
double next_start(double start, int m) {
  return m == 0 ? std::sqrt(1 / (4 * kPi)) : start * std::sqrt((2.0 * m + 1) / (m == 1 ? 1 : 2.0 * m));
}

struct Step {
  double slope, offset;
};
/// The step of the recurrence from q_{l,m} to q_{l+1,m}.
Step step_after(int l, int m) {
  const double next = slope_squared(l + 1, m);
  return {std::sqrt(next), l > m ? std::sqrt(next / slope_squared(l, m)) : 0};
}

/// The harmonics as polynomials of x, y and z: with q_{l,m}(z) as in basis_unrolled and (x + iy)^m = C_m + i S_m, the
/// column of m is A(z) C_m + B(z) S_m. Off the sphere any extension of the function will do. start_of(m) is q_{m,m};
/// term_of(l, m) has the step from there and the coefficients of m and -m. Without `kSecond` the Hessian is left empty.
template <bool kSecond, class StartOf, class TermOf>
Jet walk(int bands, Vec3 d, StartOf start_of, TermOf term_of) {
  // Far more bands than this, and the q near a pole are no longer numbers; then they are kept as q r^m, with (x +
  // iy)/r.
  constexpr int kUnscaledBands = 300;
  const double r = bands <= kUnscaledBands ? 1 : std::max(std::hypot(d.x, d.y), 1.0 / bands);
  const double x = d.x / r, y = d.y / r;

  double value = 0, fx = 0, fy = 0, fz = 0, fxx = 0, fxy = 0, fxz = 0, fyz = 0, fzz = 0;
  double c0 = 1, s0 = 0, c1 = 0, s1 = 0, c2 = 0, s2 = 0;  // the powers m, m-1 and m-2
  double power = 1;                                       // r^m
  for (int m = 0; m < bands; ++m, power *= r) {
    double a = 0, a1 = 0, a2 = 0, b = 0, b1 = 0, b2 = 0;
    double q = start_of(m) * power, q1 = 0, q2 = 0, before = 0, before1 = 0, before2 = 0;
    for (int l = m; l < bands; ++l) {
      const auto [slope, offset, cosine, sine] = term_of(l, m);
      a += cosine * q, a1 += cosine * q1;
      b += sine * q, b1 += sine * q1;
      const double next = slope * d.z * q - offset * before;
      const double next1 = slope * (q + d.z * q1) - offset * before1;
      if constexpr (kSecond) {
        a2 += cosine * q2, b2 += sine * q2;
        const double next2 = slope * (2 * q1 + d.z * q2) - offset * before2;
        before2 = q2, q2 = next2;
      }
      before = q, before1 = q1;
      q = next, q1 = next1;
    }
    value += a * c0 + b * s0;
    fz += a1 * c0 + b1 * s0;
    fx += m * (a * c1 + b * s1);
    fy += m * (b * c1 - a * s1);
    if constexpr (kSecond) {
      fzz += a2 * c0 + b2 * s0;
      fxz += m * (a1 * c1 + b1 * s1);
      fyz += m * (b1 * c1 - a1 * s1);
      fxx += m * (m - 1) * (a * c2 + b * s2);
      fxy += m * (m - 1) * (b * c2 - a * s2);
    }
    c2 = c1, s2 = s1, c1 = c0, s1 = s0;
    c0 = x * c1 - y * s1;
    s0 = x * s1 + y * c1;
  }
  fx /= r, fy /= r;
  const double radial = fx * d.x + fy * d.y + fz * d.z;
  Jet jet = {.value = value, .gradient = Vec3{fx, fy, fz} - radial * d, .hessian_rows = {}};
  if constexpr (kSecond) {
    fxz /= r, fyz /= r, fxx /= r * r, fxy /= r * r;
    // Walking along the sphere bends toward its centre: the radial slope comes off the second derivative.
    jet.hessian_rows = {Vec3{fxx - radial, fxy, fxz}, Vec3{fxy, -fxx - radial, fyz}, Vec3{fxz, fyz, fzz - radial}};
  }
  return jet;
}

double band_norm(const Sh<double>& sh, int l) {
  double norm = 0;
  for (const double value : sh.band(l)) norm = std::hypot(norm, value);
  return norm;
}

}  // namespace

ValueAndGradient value_and_gradient(std::span<const double> sh, int bands, Vec3 direction) {
  check(bands >= 1 && sh.size() == static_cast<std::size_t>(coefficient_count(bands)),
        "a gradient needs at least one band");
  check(std::abs(length(direction) - 1) <= 1e-6, "a gradient is taken at a unit direction");  // false for NaN as well
  struct Term {
    double slope, offset, cosine, sine;
  };
  const auto coefficient = [&](int l, int m) { return sh[static_cast<std::size_t>(coefficient_index(l, m))]; };
  double start = 0;
  const auto start_of = [&](int m) { return start = next_start(start, m); };
  const auto term_of = [&](int l, int m) {
    const auto [slope, offset] = step_after(l, m);
    return Term{slope, offset, coefficient(l, m), m > 0 ? coefficient(l, -m) : 0};
  };
  const Jet jet = walk<false>(bands, direction, start_of, term_of);
  return {jet.value, jet.gradient};
}

JetEvaluator::JetEvaluator(const Sh<double>& sh) : bands_(sh.bands()) {
  check(bands_ >= 1, "derivatives of a function of at least one band");
  double start = 0;
  for (int m = 0; m < bands_; ++m) {
    starts_.push_back(start = next_start(start, m));
    for (int l = m; l < bands_; ++l) {
      const auto [slope, offset] = step_after(l, m);
      terms_.push_back({.slope = slope, .offset = offset, .cosine = sh(l, m), .sine = m > 0 ? sh(l, -m) : 0});
    }
  }
}

Jet JetEvaluator::operator()(Vec3 d) const {
  const Term* term = terms_.data();
  return walk<true>(
      bands_, d, [&](int m) { return starts_[static_cast<std::size_t>(m)]; },
      [&](int, int) -> const Term& { return *term++; });
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
