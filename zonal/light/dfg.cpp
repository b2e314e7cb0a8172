#include "zonal/light/dfg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/light/lobe.h"
#include "zonal/math/quadrature.h"

// Both integrals are taken over the half vector h = (theta, phi) about n. For a given theta, light comes from above the
// surface (n.l > 0) exactly while |phi| < phi_max(theta), so the integrand's kink lies on the rule's edge. Derivation:
// docs/notes/dfg.md.

namespace zonal {
namespace {

constexpr int kRadialNodes = 12;   // of each radial panel
constexpr int kAzimuthNodes = 16;  // of half a circle

/// The rules shared by all texels, on [0, 1].
struct Rules {
  Quadrature radial = gauss_legendre(kRadialNodes, 0, 1);
  Quadrature azimuth = gauss_legendre(kAzimuthNodes, 0, 1);
  std::array<double, kAzimuthNodes> circle = {};  // cosines at the middles of equal parts of half a circle

  Rules() {
    for (int i = 0; i < kAzimuthNodes; ++i) circle[i] = std::cos(kPi * (i + 0.5) / kAzimuthNodes);
  }
};

/// What the view direction makes of the half vectors.
class HalfVectors {
 public:
  HalfVectors(const Rules& rules, double n_dot_v) : rules_(rules), cos_v_(n_dot_v) {
    sin_v_ = std::sqrt((1 - n_dot_v) * (1 + n_dot_v));
    const double below = std::asin(n_dot_v);  // pi/2 - theta_v
    full_ = below / 2;
    limit_ = kPi / 2 - below / 2;
  }

  /// Up to this theta every phi has light above the surface.
  double full() const { return full_; }
  /// From this theta on none has.
  double limit() const { return limit_; }

  /// Sum of weight f(n.l, v.h), the integral over phi in [0, pi] at theta, where n.l > 0. f returns a std::array.
  template <class F>
  auto around(double theta, const F& f) const {
    const double cos_h = std::cos(theta), sin_h = std::sin(theta);
    const double rise = sin_v_ * 2 * sin_h * cos_h, level = cos_v_ * (cos_h - sin_h) * (cos_h + sin_h);
    decltype(f(0.0, 0.0)) sum = {};
    const auto add = [&](double weight, double cos_phi, double n_dot_l) {
      const auto value = f(n_dot_l, cos_v_ * cos_h + sin_v_ * sin_h * cos_phi);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * value[i];
    };
    if (theta <= full_) {
      // Periodic and smooth: equal steps converge geometrically.
      for (const double cos_phi : rules_.circle) add(kPi / kAzimuthNodes, cos_phi, level + rise * cos_phi);
    } else {
      const double phi_max = std::acos(std::clamp(-level / rise, -1.0, 1.0));
      for (std::size_t i = 0; i < rules_.azimuth.size(); ++i) {
        // Denser towards phi_max: where v grazes, shadowing sets in over a small part of the circle.
        const double t = rules_.azimuth.nodes[i], cos_phi = std::cos(phi_max * (1 - t * t));
        add(rules_.azimuth.weights[i] * 2 * t * phi_max, cos_phi, std::max(0.0, level + rise * cos_phi));
      }
    }
    return sum;
  }

 private:
  const Rules& rules_;
  double cos_v_, sin_v_, full_, limit_;
};

/// Calls visit(x, weight) on panels no longer than `longest`.
template <class Visit>
void along(const Quadrature& unit, double from, double to, double longest, const Visit& visit) {
  const int panels = std::max(1, static_cast<int>(std::ceil((to - from) / longest)));
  const double length = (to - from) / panels;
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t i = 0; i < unit.size(); ++i) {
      visit(from + (panel + unit.nodes[i]) * length, unit.weights[i] * length);
    }
  }
}

/// The same with square-root ends: the integral over phi behaves like (theta - end)^(3/2) at both ends of the partial
/// circles, and like a polynomial in b under x = middle - half cos(b).
template <class Visit>
void along_rounded(const Quadrature& unit, double from, double to, double longest, const Visit& visit) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  if (half <= 0) return;
  along(unit, 0, kPi, std::min(kPi, kPi * longest / (to - from)),
        [&](double b, double weight) { visit(middle - half * std::cos(b), weight * half * std::sin(b)); });
}

SplitSum ggx_split_sum(const Rules& rules, double n_dot_v, double alpha) {
  const HalfVectors half_vectors(rules, n_dot_v);
  const double a2 = alpha * alpha, smith_v = std::sqrt(a2 + (1 - a2) * n_dot_v * n_dot_v);
  double total = 0, bias = 0;
  // tan(theta) = alpha sinh(u): the peak and its long tail take equal shares of u. D n.h d(omega_h) = 2 sinh/cosh^3 du
  // dphi/2pi.
  const auto visit = [&](double u, double weight) {
    const double sinh_u = std::sinh(u), cosh_u = std::cosh(u), theta = std::atan(alpha * sinh_u);
    const auto sum = half_vectors.around(theta, [&](double n_dot_l, double v_dot_h) {
      const double smith_l = std::sqrt(a2 + (1 - a2) * n_dot_l * n_dot_l);
      const double value = 2 * n_dot_l * v_dot_h / (n_dot_l * smith_v + n_dot_v * smith_l);
      const double away = 1 - v_dot_h, square = away * away;
      return std::array{value, value * square * square * away};  // Schlick 1994
    });
    const double share = weight * 2 * sinh_u / (cosh_u * cosh_u * cosh_u) / (kPi * std::cos(theta));
    total += share * sum[0];
    bias += share * sum[1];
  };
  constexpr double kLongest = 2;  // the poles of 1/cosh^3 lie pi/2 off the axis
  const double u_full = std::asinh(std::tan(half_vectors.full()) / alpha);
  const double u_limit = std::asinh(std::tan(half_vectors.limit()) / alpha);
  along(rules.radial, 0, u_full, kLongest, visit);
  along_rounded(rules.radial, u_full, u_limit, kLongest, visit);
  return {total - bias, bias};
}

double charlie_albedo(const Rules& rules, double n_dot_v, double alpha) {
  const HalfVectors half_vectors(rules, n_dot_v);
  const double power = 1 / alpha;
  double albedo = 0;
  // theta = atan(e^t): where v grazes, light comes from above the surface within n.v of both ends of [0, pi/2], which
  // this spreads.
  const auto visit = [&](double t, double weight) {
    const double theta = std::atan(std::exp(t)), sine = std::sin(theta);
    const auto sum = half_vectors.around(theta, [&](double n_dot_l, double v_dot_h) {
      return std::array{n_dot_l * v_dot_h / (n_dot_l + n_dot_v - n_dot_l * n_dot_v)};
    });
    albedo += weight * std::pow(sine, power + 2) * std::cos(theta) * (2 + power) / kPi * sum[0];
  };
  // D lives near the horizon, more so the smaller alpha: leave out where it is below e^-30 of its greatest value.
  const double sine_cut = std::sin(half_vectors.limit()) * std::exp(-30 / (power + 2));
  const double cut = std::log(std::tan(std::asin(sine_cut)));
  const double full = std::log(std::tan(half_vectors.full())), limit = std::log(std::tan(half_vectors.limit()));
  const double longest = std::min(2.0, (limit - cut) / 4);
  if (cut < full) along(rules.radial, cut, full, longest, visit);
  along_rounded(rules.radial, std::max(cut, full), limit, longest, visit);
  return albedo;
}

void check_domain(double n_dot_v, double alpha) {
  check(n_dot_v > 0 && n_dot_v <= 1, "n_dot_v must lie in (0, 1]");
  check(alpha > 0 && alpha <= 1, "alpha must lie in (0, 1]");
}

}  // namespace

SplitSum ggx_split_sum(double n_dot_v, double alpha) {
  check_domain(n_dot_v, alpha);
  return ggx_split_sum(Rules(), n_dot_v, alpha);
}

double charlie_albedo(double n_dot_v, double alpha) {
  check_domain(n_dot_v, alpha);
  return charlie_albedo(Rules(), n_dot_v, alpha);
}

Image<Rgb> dfg_table(int size, DfgVariant variant, const Run& run) {
  if (size < 1 || size > 1024) {
    throw Error(ErrorKind::kUsage, "the size of the split-sum table is out of range: " + std::to_string(size),
                "give a size from 1 to 1024; 128 is usual");
  }
  const Rules rules;
  Image<Rgb> table(size, size);
  for_each_block(run, "dfg", size, 1, [&](Block row) {
    const double alpha = alpha_from_roughness((row.begin + 0.5) / size);
    for (int x = 0; x < size; ++x) {
      const double n_dot_v = (x + 0.5) / size;
      const auto [scale, bias] = ggx_split_sum(rules, n_dot_v, alpha);
      const RgbD texel = variant == DfgVariant::kStandard
                             ? RgbD(scale, bias, charlie_albedo(rules, n_dot_v, alpha))
                             : RgbD(bias, scale + bias, charlie_albedo(rules, n_dot_v, alpha));
      table(x, row.begin) = Rgb(texel);
    }
  });
  return table;
}

}  // namespace zonal
