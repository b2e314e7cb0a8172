#pragma once

#include <cmath>

#include "zonal/sphere/projection.h"

namespace zonal {

/// A point of a disc's plane: the rim is the unit circle, x to the right, y down.
struct DiscPoint {
  double x = 0, y = 0;
};
inline double cross(DiscPoint a, DiscPoint b) { return a.x * b.y - a.y * b.x; }
inline double dot(DiscPoint a, DiscPoint b) { return a.x * b.x + a.y * b.y; }
inline double length(DiscPoint a) { return std::sqrt(dot(a, a)); }

/// How an azimuthal map of the sphere to the unit disc turns the angle θ from the disc's centre into the radius r, with
/// r(θ_max) = 1. Four laws make every disc: equidistant r ~ θ (fisheyes; with θ_max = π the angular map), equisolid r ~
/// sin(θ/2) (fisheyes; with θ_max = π the mirror ball), stereographic r ~ tan(θ/2) (fisheyes; with θ_max = π/2 the
/// paraboloid) and orthographic r ~ sin θ (fisheyes).
class RadialLaw {
 public:
  /// `theta_max` in (0, π], under π for stereographic, at most π/2 for orthographic.
  RadialLaw(LensModel model, double theta_max);

  LensModel model() const { return model_; }
  double theta_max() const { return theta_max_; }

  /// r of the angle whose cosine and sine (not negative) are given; over 1, perhaps infinite, where the disc does not
  /// reach.
  double radius(double cosine, double sine) const {
    switch (model_) {
      case LensModel::kEquidistant:
        return std::atan2(sine, cosine) / scale_;
      // Half angles by whichever form does not cancel.
      case LensModel::kEquisolid:
        return (cosine >= 0 ? sine / std::sqrt(2 * (1 + cosine)) : std::sqrt((1 - cosine) / 2)) / scale_;
      case LensModel::kStereographic:
        return (cosine >= 0 ? sine / (1 + cosine) : (1 - cosine) / sine) / scale_;
      case LensModel::kOrthographic:
        return cosine >= 0 ? sine / scale_ : HUGE_VAL;
    }
    return HUGE_VAL;
  }

  /// cos θ and (sin θ)/r of a radius in [0, 1].
  struct Polar {
    double cosine, sine_over_radius;
  };
  Polar polar(double r) const {
    const double k = scale_ * r;
    switch (model_) {
      case LensModel::kEquidistant:
        return {std::cos(k), r > 0 ? std::sin(k) / r : scale_};
      case LensModel::kEquisolid:
        return {1 - 2 * k * k, 2 * scale_ * std::sqrt(std::fmax(0, (1 - k) * (1 + k)))};
      case LensModel::kStereographic:
        return {(1 - k) * (1 + k) / (1 + k * k), 2 * scale_ / (1 + k * k)};
      case LensModel::kOrthographic:
        return {std::sqrt(std::fmax(0, (1 - k) * (1 + k))), scale_};
    }
    return {1, 0};
  }

  /// The signed solid angle between the disc's centre and the straight edge from a to b, both inside the unit circle:
  /// ∫ (1 - cos θ) dφ, positive where the edge runs from +x toward +y. Exact to rounding.
  double fan(DiscPoint a, DiscPoint b) const;
  /// The same along the rim, per radian of φ: 1 - cos θ_max.
  double rim_fan() const;

 private:
  LensModel model_;
  double theta_max_;
  double scale_;  // θ_max, sin(θ_max/2), tan(θ_max/2) or sin θ_max: what a radius of 1 stands for
};

}  // namespace zonal
