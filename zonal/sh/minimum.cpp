#include "zonal/sh/minimum.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/sh/jet.h"
#include "zonal/sh/peaks.h"

namespace zonal {
namespace {

/// A square of one of the six faces of the cube |x|, |y|, |z| <= 1, seen from its centre: a convex polygon of arcs.
struct Cell {
  double bound = 0;  // no value in it is below
  int face = 0;
  double u = 0, v = 0, half = 1;
};

struct HigherBound {
  bool operator()(const Cell& a, const Cell& b) const { return a.bound > b.bound; }
};

Vec3 toward(int face, double u, double v) {
  const double sign = face % 2 == 0 ? 1 : -1;
  if (face / 2 == 0) return normalize({sign, u, v});
  if (face / 2 == 1) return normalize({u, sign, v});
  return normalize({u, v, sign});
}

/// The farthest point of a convex polygon from a point in it is a corner.
double radius(const Cell& cell, Vec3 centre) {
  double farthest = 0;
  for (const double du : {-1, 1}) {
    for (const double dv : {-1, 1}) {
      farthest = std::max(farthest,
                          angle_between(centre, toward(cell.face, cell.u + du * cell.half, cell.v + dv * cell.half)));
    }
  }
  return farthest;
}

/// The least value of the jet's linear and quadratic part within r of its centre, or less: a square is searched, not
/// the disc in it.
double deepest(const Jet& jet, Vec3 centre, double r) {
  const PrincipalCurvatures curvatures = principal_curvatures(jet, centre);
  double sum = 0;
  for (const auto& [curvature, axis] : {std::pair(curvatures.lower, curvatures.lower_direction),
                                        std::pair(curvatures.upper, curvatures.upper_direction)}) {
    const double slope = std::abs(dot(jet.gradient, axis));
    const bool bottom_inside = curvature > 0 && slope < curvature * r;
    sum -= bottom_inside ? slope * slope / (2 * curvature) : (slope - curvature * r / 2) * r;
  }
  return sum;
}

}  // namespace

Minimum certified_minimum(const Sh<double>& sh, const MinimumOptions& options) {
  check(sh.bands() >= 1, "the minimum of a function of at least one band");
  check(options.tolerance > 0, "the tolerance of a minimum is above 0");
  const double mean = sh[0] / std::sqrt(4 * kPi), variation = derivative_bound(sh, 0), third = derivative_bound(sh, 3);
  if (!std::isfinite(mean) || !std::isfinite(third)) {
    throw Error(ErrorKind::kInput, "a coefficient of the function is not finite");
  }
  Minimum result = {.direction = {0, 0, 1}, .found = mean, .guaranteed = mean};
  if (variation == 0) return result;

  const JetEvaluator jet_at(sh);
  // The recurrences round at each of their bands^2 terms by at most the size of the values.
  const double rounding = 4e-16 * coefficient_count(sh.bands()) * (std::abs(mean) + variation);
  result.found = std::numeric_limits<double>::infinity();
  std::priority_queue<Cell, std::vector<Cell>, HigherBound> cells;
  const auto add = [&](Cell cell) {
    const Vec3 centre = toward(cell.face, cell.u, cell.v);
    const Jet jet = jet_at(centre);
    ++result.evaluations;
    if (jet.value < result.found) {
      result.found = jet.value;
      result.direction = centre;
    }
    const double r = radius(cell, centre);
    // What held for the whole holds for its quarter.
    cell.bound = std::max(cell.bound, jet.value + deepest(jet, centre, r) - third * r * r * r / 6 - rounding);
    cells.push(cell);
  };
  for (int face = 0; face < 6; ++face) add({.bound = mean - variation - rounding, .face = face});
  while (result.found - cells.top().bound > options.tolerance && result.found >= options.enough &&
         result.evaluations < options.max_evaluations) {
    const Cell cell = cells.top();
    cells.pop();
    const double half = cell.half / 2;
    for (const double du : {-half, half}) {
      for (const double dv : {-half, half}) add({cell.bound, cell.face, cell.u + du, cell.v + dv, half});
    }
  }
  result.guaranteed = std::min(cells.top().bound, result.found);
  const Peak bottom = descend(sh, result.direction);
  if (bottom.value < result.found) {
    result.found = bottom.value;
    result.direction = bottom.direction;
  }
  result.guaranteed = std::min(result.guaranteed, result.found);
  return result;
}

}  // namespace zonal
