#pragma once

#include <cmath>
#include <vector>

#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"

namespace zonal {

/// `count` unit directions spread evenly over the sphere, none on an axis (Fibonacci spiral: Gonzalez 2010).
inline std::vector<Vec3> spiral_directions(int count) {
  const double golden_angle = kPi * (3 - std::sqrt(5.0));
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), phi = golden_angle * i + 0.5;
    directions.push_back({r * std::cos(phi), r * std::sin(phi), z});
  }
  return directions;
}

struct WeightedDirection {
  Vec3 direction;
  double weight;  ///< in steradians
};

/// A rule on the sphere that integrates products of two functions of `bands` bands exactly: Gauss-Legendre in z, equal
/// steps in phi.
inline std::vector<WeightedDirection> sphere_rule(int bands) {
  const Quadrature gauss = gauss_legendre(bands);
  const int steps = 2 * bands;
  std::vector<WeightedDirection> rule;
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    const double z = gauss.nodes[i], r = std::sqrt(1 - z * z);
    for (int k = 0; k < steps; ++k) {
      const double phi = 2 * kPi * k / steps;
      rule.push_back({{r * std::cos(phi), r * std::sin(phi), z}, gauss.weights[i] * 2 * kPi / steps});
    }
  }
  return rule;
}

}  // namespace zonal
