#include "zonal/light/lobe_lean.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/base/error.h"
#include "zonal/math/quadrature.h"

namespace zonal {
namespace {

constexpr int kSteps = 64;                      // of the table
constexpr int kRadialNodes = 40, kAngles = 40;  // of an integral, in half a circle

/// With the eye at (sin, 0, cos) of theta: half vectors h as D spreads them, u being the part of D nearer the normal
/// (Walter et al. 2007, eq. 35), so that what is left of D V n.l dl = 4 D V n.l v.h dh is V n.l v.h / n.h.
double lean_at(double theta, double alpha) {
  static const Quadrature parts = gauss_legendre(kRadialNodes, 0, 1);
  const double sin_v = std::sin(theta), cos_v = std::cos(theta), a2 = alpha * alpha;
  const double masked_v = std::sqrt(cos_v * cos_v * (1 - a2) + a2);
  double x = 0, z = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double u = parts.nodes[i], tan2 = a2 * u / (1 - u), cos_h = 1 / std::sqrt(1 + tan2),
                 sin_h = std::sqrt(tan2) * cos_h;
    for (int k = 0; k < kAngles; ++k) {
      const double cos_phi = std::cos(kPi * (k + 0.5) / kAngles);
      const double v_dot_h = sin_v * sin_h * cos_phi + cos_v * cos_h, n_dot_l = 2 * v_dot_h * cos_h - cos_v;
      if (v_dot_h <= 0 || n_dot_l <= 0) continue;
      const double masked_l = std::sqrt(n_dot_l * n_dot_l * (1 - a2) + a2);
      const double weight = parts.weights[i] * n_dot_l * v_dot_h / (cos_h * (n_dot_l * masked_v + cos_v * masked_l));
      x += weight * (2 * v_dot_h * sin_h * cos_phi - sin_v);
      z += weight * n_dot_l;
    }
  }
  // Where alpha is 1 it is theta, and the rule a rounding off.
  return std::clamp(theta - std::atan2(-x, z), 0.0, theta);
}

/// `from` turned by an angle in the plane of both; `from` itself where there is no such plane.
Vec3 turned_toward(Vec3 from, Vec3 to, double angle) {
  const Vec3 across = to - dot(to, from) * from;
  const double size = length(across);
  return size > 1e-9 ? std::cos(angle) * from + (std::sin(angle) / size) * across : from;
}

}  // namespace

LobeLean::LobeLean(double alpha) {
  if (!(alpha >= 1e-4 && alpha <= 1)) {
    throw Error(ErrorKind::kUsage, "alpha is out of its range: " + std::to_string(alpha), "it lies in [1e-4, 1]");
  }
  leans_ = {0};  // by symmetry
  for (int i = 1; i <= kSteps; ++i) leans_.push_back(lean_at(kSteepest * i / kSteps, alpha));
}

double LobeLean::lean(double theta) const {
  const double place = std::clamp(theta / kSteepest, 0.0, 1.0) * kSteps;
  const auto i = static_cast<std::size_t>(std::min(place, kSteps - 1.0));
  return leans_[i] + (place - static_cast<double>(i)) * (leans_[i + 1] - leans_[i]);
}

Vec3 LobeLean::mean(Vec3 view, Vec3 normal) const {
  const double theta = angle_between(view, normal);
  return turned_toward(normal, -view, theta - lean(theta));
}

Vec3 LobeLean::normal(Vec3 view, Vec3 mean) const {
  // The mean is 2 theta - lean(theta) from the eye, more the greater theta is.
  const double wanted = angle_between(view, mean);
  double least = 0, most = kSteepest;
  for (int step = 0; step < 30; ++step) {
    const double theta = 0.5 * (least + most);
    (2 * theta - lean(theta) < wanted ? least : most) = theta;
  }
  Vec3 toward = mean;
  if (length(cross(view, mean)) < 1e-9) toward = std::abs(view.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  return turned_toward(view, toward, least);
}

}  // namespace zonal
