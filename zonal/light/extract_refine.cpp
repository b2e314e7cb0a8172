#include "zonal/light/extract_refine.h"

#include <cmath>
#include <functional>

#include "zonal/light/quasi_newton.h"

namespace zonal {
namespace {

/// A disc that starts as a point would remain one: residual^2 is even in u.
constexpr double kLeastStartAngle = 0.02;

}  // namespace

ShapeObjective::ShapeObjective(const LightFitter& fitter, FreeShapes free, const std::vector<LightShape>& shapes)
    // The first step of the minimiser has length 1: make that a quarter of a lobe's width.
    : fitter_(fitter), free_(free), origin_(shapes), scale_(4.0 * fitter.bands()) {}

std::vector<double> ShapeObjective::start() const {
  std::vector<double> parameters;
  for (const LightShape& shape : origin_) {
    if (free_.directions) {
      for (const double c : {shape.direction.x, shape.direction.y, shape.direction.z}) parameters.push_back(scale_ * c);
    }
    if (free_.angles) {
      parameters.push_back(scale_ * std::max(std::asin(std::sqrt(std::min(shape.versine, 1.0))), kLeastStartAngle));
    }
  }
  return parameters;
}

std::vector<LightShape> ShapeObjective::shapes(std::span<const double> parameters) const {
  std::vector<LightShape> shapes = origin_;
  std::size_t next = 0;
  for (LightShape& shape : shapes) {
    if (free_.directions) {
      shape.direction = normalize({parameters[next], parameters[next + 1], parameters[next + 2]});
      next += 3;
    }
    if (free_.angles) {
      const double sine = std::sin(parameters[next++] / scale_);
      shape.versine = sine * sine;
    }
  }
  return shapes;
}

double ShapeObjective::operator()(std::span<const double> parameters, std::span<double> slopes) const {
  const LightFit fit = fitter_.fit(shapes(parameters));
  std::size_t next = 0;
  for (const ShapeSlope& slope : fitter_.slopes(fit)) {
    if (free_.directions) {
      // The slope is tangent, so the Jacobian of v/|v| is 1/|v| (Sloan 2008, corrected).
      const double size = length({parameters[next], parameters[next + 1], parameters[next + 2]});
      for (const double c : {slope.direction.x, slope.direction.y, slope.direction.z}) slopes[next++] = c / size;
    }
    if (free_.angles) {
      slopes[next] = slope.versine * std::sin(2 * parameters[next] / scale_) / scale_;
      ++next;
    }
  }
  return fit.residual * fit.residual;
}

LightFit refine_lights(const LightFitter& fitter, std::vector<LightShape> shapes, FreeShapes free) {
  const ShapeObjective objective(fitter, free, shapes);
  std::vector<double> parameters = objective.start();
  LightFit before = fitter.fit(std::move(shapes));
  if (parameters.empty() || before.residual == 0) return before;

  minimise(std::cref(objective), parameters);
  LightFit after = fitter.fit(objective.shapes(parameters));
  return after.residual < before.residual ? after : before;
}

}  // namespace zonal
