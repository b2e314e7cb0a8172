#include "zonal/light/partial.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

Environment mask_of(const Environment& environment) {
  const ImageSize size{environment.radiance.width(), environment.radiance.height()};
  const Mapping mapping(environment.projection, size);
  Environment mask{Image<Rgb>(size.width, size.height), environment.projection};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (mapping.texel_direction(x, y)) mask.radiance(x, y) = {1, 1, 1};
    }
  }
  return mask;
}

void renormalise(Convolved& light, const Convolved& mask) {
  constexpr float kLeastSeen = 1e-2f;
  const auto texels = light.map.radiance.values();
  const auto seen = mask.map.radiance.values();
  check(texels.size() == seen.size(), "light and mask must have one size");
  double worst = 0;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const float share = seen[i].r;
    if (share < kLeastSeen) {
      texels[i] = {};
      continue;
    }
    texels[i] = (1 / share) * texels[i];
    const Rgb magnitude = {std::abs(texels[i].r), std::abs(texels[i].g), std::abs(texels[i].b)};
    // (L + dL)/(M + dM) - L/M = (dL - L/M dM)/(M + dM)
    worst = std::max(worst, (light.report.error_bound + max_channel(magnitude) * mask.report.error_bound) / share);
  }
  if (light.report.error_bound == 0) return;
  const double growth = worst / light.report.error_bound;
  light.report.error_bound *= growth;
  light.report.bound_to_mean *= growth;
  light.report.bound_to_peak *= growth;
}

}  // namespace zonal
