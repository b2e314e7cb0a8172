#include "zonal/light/extract.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "zonal/base/error.h"
#include "zonal/light/extract_fit.h"
#include "zonal/light/extract_refine.h"
#include "zonal/light/model.h"
#include "zonal/light/model_argument.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/peaks.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

constexpr double kWorthwhile = 1e-6;  // what a further light must take off the residual
constexpr double kRounding = 1e-12;   // residuals this near are equal

/// The best fits with at most 1, 2, 3 ... lights.
using Ladder = std::vector<LightFit>;

double residual_below(const Ladder& ladder) { return ladder.empty() ? 1 : ladder.back().residual; }

void keep_better(std::optional<LightFit>& best, LightFit other) {
  if (!best || other.residual < best->residual - kRounding) best = std::move(other);
}

std::vector<LightShape> with(std::vector<LightShape> shapes, LightShape further) {
  shapes.push_back(further);
  return shapes;
}

/// The maxima one after the other, each time the one that leaves least *radiance*: in the irradiance metric a lobe that
/// truncation raises between two lights would pass for both. Those that do not help in the metric are passed over.
Ladder select_maxima(const LightFitter& fitter, const LightFitter& by_radiance,
                     const std::vector<ExtractMaximum>& maxima, int lights) {
  Ladder ladder;
  std::vector<LightShape> candidates;
  for (int i = 0; i < static_cast<int>(maxima.size()); ++i) {
    candidates.push_back({maxima[static_cast<std::size_t>(i)].direction, 0, i});
  }
  std::vector<LightShape> chosen;
  while (static_cast<int>(ladder.size()) < lights && !candidates.empty()) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double residual = by_radiance.fit(with(chosen, candidates[i])).residual;
      if (residual < least) {
        least = residual;
        best = i;
      }
    }
    chosen.push_back(candidates[best]);
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(best));
    LightFit next = fitter.fit(with(ladder.empty() ? std::vector<LightShape>{} : ladder.back().shapes, chosen.back()));
    if (next.residual < residual_below(ladder) - kWorthwhile) ladder.push_back(std::move(next));
  }
  return ladder;
}

/// About where one more light would explain most.
LightShape highest_remainder(const LightFitter& fitter, const LightFit& fit) {
  const Sh<double> left = fitter.unexplained(fit);
  LightShape best;
  double highest = -std::numeric_limits<double>::infinity();
  for (const Vec3 direction : spiral_directions(4 * coefficient_count(fitter.bands()))) {
    const double value = evaluate(left, direction);
    if (value > highest) {
      highest = value;
      best.direction = direction;
    }
  }
  return best;
}

/// The half angles to start from: for each light in turn that of a few which leaves least.
std::vector<LightShape> with_start_angles(const LightFitter& fitter, std::vector<LightShape> shapes) {
  for (LightShape& shape : shapes) {
    double best = shape.versine, least = fitter.fit(shapes).residual;
    for (const double half_angle : {radians(8.0), radians(20.0), radians(40.0), radians(70.0)}) {
      shape.versine = 1 - std::cos(half_angle);
      const double residual = fitter.fit(shapes).residual;
      if (residual < least) {
        least = residual;
        best = shape.versine;
      }
    }
    shape.versine = best;
  }
  return shapes;
}

/// Climbs the ladder again with free shapes. On each rung it starts from the old rung and from the new rung below with
/// one light more, so no residual can be greater than either.
Ladder improve(const LightFitter& fitter, const Ladder& old, FreeShapes free, int lights) {
  Ladder ladder;
  while (static_cast<int>(ladder.size()) < lights) {
    const std::size_t rung = ladder.size();
    std::vector<std::vector<LightShape>> starts;
    if (rung < old.size()) starts.push_back(old[rung].shapes);
    const LightFit below = ladder.empty() ? fitter.fit({}) : ladder.back();
    if (free.directions) {
      starts.push_back(with(below.shapes, highest_remainder(fitter, below)));
    } else if (rung < old.size()) {
      starts.push_back(with(below.shapes, old[rung].shapes.back()));
    }
    std::optional<LightFit> best;
    for (std::vector<LightShape>& start : starts) {
      keep_better(best, refine_lights(fitter, start, free));
      if (free.angles) keep_better(best, refine_lights(fitter, with_start_angles(fitter, start), free));
    }
    const bool worthwhile = best && best->residual < below.residual - kWorthwhile;
    if (!worthwhile && rung >= old.size()) break;
    // The old ladder may stand lower here, or still go down further up.
    const bool overtaken = rung < old.size() && old[rung].residual < below.residual;
    ladder.push_back(worthwhile || overtaken ? std::move(*best) : below);
  }
  return ladder;
}

Sh<double> luminance_of(const Sh<RgbD>& radiance) {
  Sh<double> result(radiance.bands());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = luminance(radiance[i]);
  return result;
}

}  // namespace

ExtractedLights extract_lights(const Sh<RgbD>& radiance, const ExtractOptions& options) {
  if (options.lights < 0) throw Error(ErrorKind::kUsage, "the number of lights must not be negative");
  const LightFitter fitter(radiance, options.metric, options.nonnegative);
  if (fitter.constant()) return fitter.result(fitter.fit({}));

  std::vector<ExtractMaximum> maxima;
  if (options.lights > 0) {
    for (const Peak& peak : find_peaks(luminance_of(radiance)).maxima) maxima.push_back({peak.direction, peak.value});
  }
  const LightFitter by_radiance(radiance, ExtractMetric::kRadiance, options.nonnegative);
  Ladder ladder = select_maxima(fitter, by_radiance, maxima, options.lights);
  if (options.refine) ladder = improve(fitter, ladder, {.directions = true}, options.lights);
  if (options.cones) {
    ladder = improve(fitter, ladder, {.directions = options.refine, .angles = true}, options.lights);
  }
  const LightFit best = ladder.empty() ? fitter.fit({}) : ladder.back();
  ExtractedLights result = fitter.result(best);
  std::stable_sort(result.lights.begin(), result.lights.end(), [](const ExtractedLight& a, const ExtractedLight& b) {
    return luminance(a.irradiance) > luminance(b.irradiance);
  });
  for (const LightShape& shape : best.shapes) {
    if (shape.maximum >= 0) maxima[static_cast<std::size_t>(shape.maximum)].taken = true;
  }
  result.maxima = std::move(maxima);
  return result;
}

ExtractedLights fit_lights(const Sh<RgbD>& radiance, std::span<const Vec3> directions, ExtractMetric metric,
                           bool nonnegative) {
  const LightFitter fitter(radiance, metric, nonnegative);
  std::vector<LightShape> shapes;
  for (const Vec3 direction : directions) shapes.push_back({direction_of(direction, "the way toward a light")});
  return fitter.result(fitter.fit(std::move(shapes)));
}

Sh<RgbD> project(const ExtractedLights& extracted, int bands) {
  Sh<RgbD> sh = ambient_sh(extracted.ambient, bands);
  for (const ExtractedLight& light : extracted.lights) {
    if (!(light.half_angle >= 0 && light.half_angle <= kPi / 2)) {
      throw Error(ErrorKind::kUsage, "the half angle of a light must be from 0 to pi/2");
    }
    const double sine = std::sin(light.half_angle / 2), versine = 2 * sine * sine;
    sh += (1 / (1 - versine / 2) * finite(light.irradiance, "the irradiance")) *
          zonal_toward(zonal_from_factors(disc_factors(versine, bands).factors),
                       direction_of(light.direction, "the way toward a light"));
  }
  return sh;
}

}  // namespace zonal
