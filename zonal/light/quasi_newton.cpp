#include "zonal/light/quasi_newton.h"

#include <Eigen/Core>
#include <limits>

namespace zonal {
namespace {

struct Point {
  Eigen::VectorXd x, slopes;
  double value = 0;
};

Point point_at(const SlopedFunction& function, Eigen::VectorXd x) {
  Point point{std::move(x), {}, 0};
  point.slopes.resize(point.x.size());
  const auto size = static_cast<std::size_t>(point.x.size());
  point.value = function(std::span<const double>(point.x.data(), size), std::span(point.slopes.data(), size));
  return point;
}

/// A lower point along `toward`, a good piece down the slope and where the slope has become gentler: the weak
/// conditions of Wolfe, by doubling and halving (Lewis & Overton 2013, algorithm 2.6). Without one, `from` itself.
Point lower_point(const SlopedFunction& function, const Point& from, const Eigen::VectorXd& toward, double step) {
  constexpr double kDown = 1e-4, kGentler = 0.9;
  constexpr int kMostTries = 25;  // halvings: a ten-millionth of the step that was expected to do
  const double slope = from.slopes.dot(toward);
  double near = 0, far = std::numeric_limits<double>::infinity();
  Point best = from;
  for (int tries = 0; tries < kMostTries; ++tries) {
    Point next = point_at(function, from.x + step * toward);
    if (!(next.value < from.value + kDown * step * slope)) {  // NaN is not lower
      far = step;
    } else {
      const bool gentle = next.slopes.dot(toward) >= kGentler * slope;
      if (next.value < best.value) best = std::move(next);
      if (gentle) break;
      near = step;
    }
    step = far < std::numeric_limits<double>::infinity() ? (near + far) / 2 : 2 * near;
  }
  return best;
}

}  // namespace

void minimise(const SlopedFunction& function, std::span<double> x, const MinimiseOptions& options) {
  const auto size = static_cast<Eigen::Index>(x.size());
  Point here = point_at(function, Eigen::Map<const Eigen::VectorXd>(x.data(), size));
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(size, size);  // of the second derivative, as far as it is known
  const auto flat = [&] { return here.slopes.norm() <= options.flat * std::max(1.0, here.x.norm()); };
  for (int steps = 0; steps < options.max_steps && !flat(); ++steps) {
    const Eigen::VectorXd toward = -(inverse * here.slopes);
    Point next = lower_point(function, here, toward, steps == 0 ? 1 / here.slopes.norm() : 1);
    if (!(next.value < here.value)) break;
    const Eigen::VectorXd moved = next.x - here.x, change = next.slopes - here.slopes;
    const double curvature = moved.dot(change);
    here = std::move(next);
    if (curvature <= 0) continue;
    if (steps == 0) inverse *= curvature / change.squaredNorm();  // the right size to begin with (eq. 6.20)
    // Eq. 6.17, multiplied out.
    const Eigen::VectorXd product = inverse * change;
    inverse += (1 + change.dot(product) / curvature) / curvature * moved * moved.transpose() -
               (product * moved.transpose() + moved * product.transpose()) / curvature;
  }
  Eigen::Map<Eigen::VectorXd>(x.data(), size) = here.x;
}

}  // namespace zonal
