#pragma once

#include <array>
#include <span>
#include <vector>

#include "zonal/sh/sh.h"

namespace zonal {

/// A function on the sphere at a unit direction d, to first order.
struct ValueAndGradient {
  double value = 0;
  Vec3 gradient;  ///< with respect to angle, per radian; tangent to the sphere
};

/// And to second order.
struct Jet {
  double value = 0;
  Vec3 gradient;
  std::array<Vec3, 3> hessian_rows;  ///< u.(H v) for tangents u, v is the second derivative along the sphere
};

/// Value and gradient of the function with these bands^2 coefficients at a unit direction, as JetEvaluator has them.
/// O(bands^2), no heap.
ValueAndGradient value_and_gradient(std::span<const double> sh, int bands, Vec3 direction);

/// Evaluates a function of any number of bands with its first two derivatives; exact to rounding, which grows l times
/// in band l with each derivative. Everything that depends on the function alone is done once. No angles are used, so
/// the poles are like any other place.
class JetEvaluator {
 public:
  explicit JetEvaluator(const Sh<double>&);
  /// At a unit direction. O(bands^2), no heap.
  Jet operator()(Vec3 direction) const;

 private:
  struct Term {
    double slope, offset;  // of the recurrence that leads to the next l
    double cosine, sine;   // the coefficients of m and -m
  };
  int bands_;
  std::vector<double> starts_;  // q_{m,m}
  std::vector<Term> terms_;     // by m, then l = m..bands-1
};

/// The least and the greatest second derivative at d among the tangent directions, and those directions.
struct PrincipalCurvatures {
  double lower = 0, upper = 0;
  Vec3 lower_direction, upper_direction;
};
PrincipalCurvatures principal_curvatures(const Jet&, Vec3 d);

/// No derivative of this order (0 to 3) along a great circle, per radian, exceeds this in size; for order 0: no value
/// differs from the mean by more. The sum over l >= 1 of the norm of the band times the norm of the derivative in it
/// (Cauchy-Schwarz), whose square is (2l+1)/4pi times the derivative of order 2*order of P_l(cos theta) at 0. Attained
/// by a suitable function of each band alone.
double derivative_bound(const Sh<double>&, int order);

}  // namespace zonal
