#include "zonal/sh/peaks.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/math/sphere_rule.h"

namespace zonal {
namespace {

// The search is done on the function without its mean, divided by derivative_bound(): values within [-1, 1], slopes
// within `bands`, curvatures within bands^2. The thresholds below are in these units.
constexpr double kFlatCurvature = 1e-7;   // times bands^2: a ridge, as far as doubles tell
constexpr double kFlatDifference = 1e-9;  // between the values found along one ridge
constexpr double kSameDirection = 1e-3;   // over bands, in radians: Newton stops much nearer than this

/// From d along the great circle of a tangent.
Vec3 walk(Vec3 d, Vec3 tangent) {
  const double angle = length(tangent);
  if (angle == 0) return d;
  return normalize(std::cos(angle) * d + (std::sin(angle) / angle) * tangent);
}

/// Newton's method uphill. Where the function is not concave the sizes of the curvatures serve, so that every step goes
/// up; a saddle is left along its rising direction.
Peak ascend(const JetEvaluator& jet_at, int bands, Vec3 d) {
  const double least_curvature = kFlatCurvature * bands * bands, smallest_gradient = 1e-14 * bands;
  const double longest_step = 0.5 / bands;
  Jet jet = jet_at(d);
  PrincipalCurvatures curvatures = principal_curvatures(jet, d);
  for (int iteration = 0; iteration < 200; ++iteration) {
    Vec3 step;
    if (length(jet.gradient) > smallest_gradient) {
      for (const auto& [curvature, axis] : {std::pair(curvatures.upper, curvatures.upper_direction),
                                            std::pair(curvatures.lower, curvatures.lower_direction)}) {
        step += (dot(jet.gradient, axis) / std::max(std::abs(curvature), least_curvature)) * axis;
      }
    } else if (curvatures.upper > least_curvature) {
      step = (0.1 / bands) * curvatures.upper_direction;
    }
    if (length(step) > longest_step) step = (longest_step / length(step)) * step;
    if (length(step) < 1e-15) break;
    const double rise = dot(jet.gradient, step);
    bool risen = false;
    for (double t = 1; t > 1e-6 && !risen; t /= 2) {
      const Vec3 next = walk(d, t * step);
      const Jet there = jet_at(next);
      // Close to the peak the rise drowns in the rounding of values of size 1.
      if (there.value >= jet.value + 1e-4 * t * rise - 1e-15) {
        risen = true;
        d = next;
        jet = there;
      }
    }
    if (!risen) break;
    curvatures = principal_curvatures(jet, d);
  }
  return {d, jet.value, length(jet.gradient), curvatures.upper < -least_curvature};
}

/// One for each that was found more than once, one for each ridge, the highest first.
std::vector<Peak> distinct(std::vector<Peak> found, int bands) {
  std::stable_sort(found.begin(), found.end(), [](const Peak& a, const Peak& b) { return a.value > b.value; });
  std::vector<Peak> points;
  for (const Peak& peak : found) {
    const bool known = std::any_of(points.begin(), points.end(), [&](const Peak& other) {
      return length(peak.direction - other.direction) < kSameDirection / bands;
    });
    if (!known) points.push_back(peak);
  }
  // Along a ridge every start point ends somewhere else: what hangs together within three spacings is one.
  const double near = 3 * std::sqrt(4 * kPi / static_cast<double>(found.size()));
  std::vector<Peak> peaks;
  std::vector<char> taken(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (taken[i]) continue;
    peaks.push_back(points[i]);
    if (points[i].isolated) continue;
    std::vector<std::size_t> ridge = {i};
    while (!ridge.empty()) {
      const Peak& from = points[ridge.back()];
      ridge.pop_back();
      for (std::size_t k = i + 1; k < points.size(); ++k) {
        if (taken[k] || points[k].isolated || std::abs(from.value - points[k].value) > kFlatDifference ||
            length(from.direction - points[k].direction) > near)
          continue;
        taken[k] = true;
        ridge.push_back(k);
      }
    }
  }
  return peaks;
}

/// The function in the units above, and the way back.
struct Scaled {
  Sh<double> sh;
  double mean = 0, scale = 0;

  explicit Scaled(const Sh<double>& original) : sh(original) {
    check(sh.bands() >= 1, "peaks of a function of at least one band");
    mean = sh[0] / std::sqrt(4 * kPi);
    scale = derivative_bound(sh, 0);
    if (!std::isfinite(mean) || !std::isfinite(scale)) {
      throw Error(ErrorKind::kInput, "a coefficient of the function is not finite");
    }
    sh[0] = 0;
    if (scale > 0) {
      for (double& value : sh.values()) value /= scale;
    }
  }
  Peak back(Peak peak, double sign) const {
    peak.value = mean + sign * scale * peak.value;
    peak.gradient *= scale;
    return peak;
  }
};

}  // namespace

Peaks find_peaks(const Sh<double>& sh) {
  const Scaled scaled(sh);
  const int bands = sh.bands();
  Peaks result;
  if (scaled.scale == 0) {
    const Peak plateau = {{0, 0, 1}, scaled.mean, 0, false};
    result.maxima = result.minima = {plateau};
    return result;
  }
  const std::vector<Vec3> starts = spiral_directions(std::max(16, 4 * bands * bands));
  result.starts = static_cast<int>(starts.size());
  for (const double sign : {1.0, -1.0}) {
    const JetEvaluator jet_at(sign * scaled.sh);
    std::vector<Peak> found;
    for (const Vec3 start : starts) found.push_back(ascend(jet_at, bands, start));
    std::vector<Peak>& peaks = sign > 0 ? result.maxima : result.minima;
    for (const Peak& peak : distinct(std::move(found), bands)) {
      peaks.push_back(scaled.back(peak, sign));
      result.largest_gradient = std::max(result.largest_gradient, peaks.back().gradient);
    }
  }
  return result;
}

Peak descend(const Sh<double>& sh, Vec3 start) {
  const Scaled scaled(sh);
  if (scaled.scale == 0) return {start, scaled.mean, 0, false};
  return scaled.back(ascend(JetEvaluator(-1 * scaled.sh), sh.bands(), start), -1);
}

}  // namespace zonal
