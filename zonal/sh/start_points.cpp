#include "zonal/sh/start_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "zonal/base/check.h"
#include "zonal/math/sphere_rule.h"

namespace zonal {
namespace {

struct Forces {
  std::vector<Vec3> tangential;
  double square = 0;
};

Forces forces(const std::vector<Vec3>& points) {
  Forces forces = {std::vector<Vec3>(points.size()), 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vec3 force;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (k == i) continue;
      const Vec3 apart = points[i] - points[k];
      const double distance = length(apart);
      force += (1 / (distance * distance * distance)) * apart;
    }
    forces.tangential[i] = force - dot(force, points[i]) * points[i];
    forces.square += dot(forces.tangential[i], forces.tangential[i]);
  }
  return forces;
}

}  // namespace

double repulsion_energy(const std::vector<Vec3>& directions) {
  double energy = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) energy += 1 / length(directions[i] - directions[k]);
  }
  return energy;
}

std::vector<Vec3> repelled_directions(int count) {
  check(count >= 1 && count <= 200, "from 1 to 200 start points");
  std::vector<Vec3> points = spiral_directions(count);
  Forces now = forces(points);
  const double spacing = std::sqrt(4 * kPi / count), stiffness = 1 / (spacing * spacing * spacing);
  double step = 0.1 / stiffness;
  for (int iteration = 0; iteration < 5000 && std::sqrt(now.square) > 1e-13 * count * stiffness; ++iteration) {
    // No point moves farther than a part of the way to its neighbour.
    double largest = 0;
    for (const Vec3 force : now.tangential) largest = std::max(largest, length(force));
    const double move = std::min(step, 0.1 * spacing / largest);
    std::vector<Vec3> moved = points;
    for (std::size_t i = 0; i < points.size(); ++i) moved[i] = normalize(points[i] + move * now.tangential[i]);
    const Forces there = forces(moved);
    // The step that would have been right for the stiffness just met (Barzilai & Borwein 1988): some hundred steps
    // where doubling and halving (Sloan 2008) takes thousands.
    double moved_square = 0, softening = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 way = moved[i] - points[i];
      moved_square += dot(way, way);
      softening += dot(way, now.tangential[i] - there.tangential[i]);
    }
    step = softening > 0 ? moved_square / softening : 2 * move;
    points = std::move(moved);
    now = there;
  }
  return points;
}

}  // namespace zonal
