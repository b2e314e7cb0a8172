#include "zonal/light/phong_reflectance.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/light/brdf.h"
#include "zonal/math/quadrature.h"

namespace zonal {
namespace {

constexpr int kNodes = 20;  // of each panel

void check_domain(double n_dot_v, double exponent) {
  if (n_dot_v > 0 && n_dot_v <= 1 && exponent >= 0 && exponent <= 1e4) return;
  throw Error(ErrorKind::kUsage,
              "n.v = " + std::to_string(n_dot_v) + " or the exponent " + std::to_string(exponent) + " is out of range",
              "n.v lies in (0, 1], the exponent in [0, 1e4]");
}

/// The integral of f over [0, end], which has kinks at `edges`. Panels halve toward 0, where a sharp lobe is, and
/// toward each kink, where f goes like a root.
template <class F>
double graded_integral(double end, std::vector<double> edges, const F& f) {
  constexpr double kFinest = 1e-3;
  static const Quadrature rule = gauss_legendre(kNodes, 0, 1);
  edges.insert(edges.end(), {0, end});
  std::ranges::sort(edges);
  double sum = 0;
  const auto panel = [&](double from, double to) {
    for (std::size_t i = 0; i < rule.size(); ++i) {
      sum += (to - from) * rule.weights[i] * f(from + (to - from) * rule.nodes[i]);
    }
  };
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double middle = 0.5 * (edges[k] + edges[k + 1]);
    for (double far = middle - edges[k], near = 0; far > 0; far = near) {
      near = far > kFinest ? far / 2 : 0;
      panel(edges[k] + near, edges[k] + far);
      panel(edges[k + 1] - far, edges[k + 1] - near);
    }
  }
  return sum;
}

/// Half of the part of a circle on which a + b cos(phi) is at least `least`.
double half_arc(double a, double b, double least) {
  if (a - b >= least) return kPi;
  return a + b > least ? std::acos((least - a) / b) : 0;
}

}  // namespace

double phong_reflectance(double n_dot_v, double exponent) {
  check_domain(n_dot_v, exponent);
  const double sine = std::sqrt((1 - n_dot_v) * (1 + n_dot_v));
  // Beyond the angle between r and the horizon, circles are cut by it.
  return (exponent + 2) / kPi * graded_integral(kPi / 2, {std::asin(n_dot_v)}, [&](double psi) {
           const double level = n_dot_v * std::cos(psi), rise = sine * std::sin(psi), arc = half_arc(level, rise, 0);
           return std::pow(std::cos(psi), exponent) * std::sin(psi) * (level * arc + rise * std::sin(arc));
         });
}

double blinn_phong_reflectance(double n_dot_v, double exponent) {
  check_domain(n_dot_v, exponent);
  const double sine = std::sqrt((1 - n_dot_v) * (1 + n_dot_v)), below = std::asin(n_dot_v);
  const double scale = blinn_phong_brdf(exponent)({0, 0, 1}, {0, 0, 1}).r;  // where (n.h)^s is 1
  // dl = 4 v.h dh and n.l = 2 (n.h)(v.h) - n.v, so that light is above the surface where v.h > n.v/(2 n.h). With v.h =
  // level + rise cos(phi), the integral of (n.l)(v.h) over the circle of h is that of two powers of v.h.
  return 8 * scale * graded_integral((kPi - below) / 2, {below / 2}, [&](double theta) {
           const double cosine = std::cos(theta), level = n_dot_v * cosine, rise = sine * std::sin(theta);
           const double arc = half_arc(level, rise, n_dot_v / (2 * cosine)), along = rise * std::sin(arc);
           const double first = level * arc + along;
           const double second =
               level * level * arc + 2 * level * along + 0.5 * rise * (rise * arc + along * std::cos(arc));
           return std::pow(cosine, exponent) * std::sin(theta) * (2 * cosine * second - n_dot_v * first);
         });
}

}  // namespace zonal
