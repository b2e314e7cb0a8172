#include "zonal/sphere/radial_law.h"

#include "zonal/base/check.h"
#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"

namespace zonal {
namespace {

double scale_of(LensModel model, double theta_max) {
  switch (model) {
    case LensModel::kEquidistant:
      return theta_max;
    case LensModel::kEquisolid:
      return std::sin(theta_max / 2);
    case LensModel::kStereographic:
      return std::tan(theta_max / 2);
    case LensModel::kOrthographic:
      return std::sin(theta_max);
  }
  return 1;
}

double theta_limit(LensModel model) { return model == LensModel::kOrthographic ? kPi / 2 : kPi; }

/// Nodes enough for full double precision of a function that is smooth on the scale of 1, over an interval of this
/// length.
const Quadrature& rule_for(double length) {
  static const Quadrature kTiny = gauss_legendre(3), kShort = gauss_legendre(5), kMedium = gauss_legendre(8),
                          kLong = gauss_legendre(24);
  return length <= 1.0 / 128 ? kTiny : length <= 1.0 / 16 ? kShort : length <= 0.5 ? kMedium : kLong;
}

template <class F>
double integrate(double from, double to, F f) {
  const Quadrature& rule = rule_for(std::abs(to - from));
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < rule.size(); ++i) sum += rule.weights[i] * f(middle + half * rule.nodes[i]);
  return half * sum;
}

}  // namespace

RadialLaw::RadialLaw(LensModel model, double theta_max)
    : model_(model), theta_max_(theta_max), scale_(scale_of(model, theta_max)) {
  check(theta_max > 0 && theta_max <= theta_limit(model), "a disc's widest angle is out of its law's domain");
  check(model != LensModel::kStereographic || theta_max < kPi, "a stereographic disc cannot reach the whole sphere");
}

double RadialLaw::fan(DiscPoint a, DiscPoint b) const {
  const double twice_area = cross(a, b);
  if (model_ == LensModel::kEquisolid)
    return 2 * scale_ * scale_ * twice_area;  // 1 - cos θ = 2 sin²(θ/2) = 2 (scale r)²

  const double edge = length(DiscPoint{b.x - a.x, b.y - a.y});
  if (edge == 0) return 0;
  // Along the edge: r² = h² + s², dφ = h ds / r².
  const DiscPoint along{(b.x - a.x) / edge, (b.y - a.y) / edge};
  const double h = twice_area / edge;
  const double s0 = dot(a, along), s1 = dot(b, along);

  if (model_ == LensModel::kStereographic) {
    // ∫ 2 t² h / (1 + t² r²) ds is an arctangent; the difference of two, as one.
    const double t = scale_, w = std::sqrt(1 + t * h * t * h);
    return 2 * t * h / w * std::atan2(t * (s1 - s0) * w, w * w + t * t * s0 * s1);
  }
  if (model_ == LensModel::kEquidistant) {
    return h * integrate(s0, s1, [&](double s) {
             const double r = length(DiscPoint{h, s});
             const double q = r > 0 ? std::sin(scale_ * r / 2) / r : scale_ / 2;
             return 2 * q * q;
           });
  }
  // Orthographic: cos θ = sqrt(1 - scale² r²) has a root at the rim of a half sphere. With scale s = c sin ψ, where c =
  // cos θ at the foot of the edge, cos θ = c cos ψ, and (1 - cos θ) dφ = scale h cos θ / (1 + cos θ) dψ is smooth.
  const auto cosine = [&](DiscPoint p) { return polar(length(p)).cosine; };
  const double c = std::sqrt(std::fmax(0, (1 - scale_ * h) * (1 + scale_ * h)));
  const double psi0 = std::atan2(scale_ * s0, cosine(a)), psi1 = std::atan2(scale_ * s1, cosine(b));
  return scale_ * h * integrate(psi0, psi1, [&](double psi) {
           const double cos_theta = c * std::cos(psi);
           return cos_theta / (1 + cos_theta);
         });
}

double RadialLaw::rim_fan() const {
  const double s = std::sin(theta_max_ / 2);
  return 2 * s * s;
}

}  // namespace zonal
