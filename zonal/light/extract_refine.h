#pragma once

#include "zonal/light/extract_fit.h"

namespace zonal {

/// Which unknowns of the shapes are free. The intensities always are.
struct FreeShapes {
  bool directions = false;
  bool angles = false;
};

/// residual^2 as a function of free parameters, with its gradient: per light a vector along its direction, of any
/// length (Sloan 2008: so that a step may leave the sphere), then an angle u with versine = sin^2 u, which keeps discs
/// between a point and half the sky.
class ShapeObjective {
 public:
  /// The parameters of these shapes.
  ShapeObjective(const LightFitter&, FreeShapes, const std::vector<LightShape>&);
  std::vector<double> start() const;
  std::vector<LightShape> shapes(std::span<const double> parameters) const;
  /// residual^2; its gradient into `slopes`.
  double operator()(std::span<const double> parameters, std::span<double> slopes) const;

 private:
  const LightFitter& fitter_;
  FreeShapes free_;
  std::vector<LightShape> origin_;
  double scale_;
};

/// The lights at the minimum of residual^2 near `shapes`; never worse than those themselves.
LightFit refine_lights(const LightFitter&, std::vector<LightShape> shapes, FreeShapes);

}  // namespace zonal
