#pragma once

#include <cstdint>
#include <optional>

#include "zonal/light/survey.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// The compact light around the brightest texel: the connected texels above a tenth of its luminance, and one ring of
/// texels around them into which its edge spills; the next ring is its background. nullopt unless the peak is at least
/// 16 times the map's mean and the light subtends less than 0.03 sr (11 degrees across).
std::optional<SunEstimate> estimate_sun(const Environment&, const Mapping&, Texel brightest, double mean_luminance,
                                        double total_luminance);

/// Whether texels at the map's largest channel value form one compact patch (under 0.1 sr, four texels or more) that is
/// brighter than its map but not as a sun would be (1000 times its mean): the ceiling of a sensor or a format.
bool looks_clipped(const Environment&, const Mapping&, Texel brightest, float max_channel, double mean_luminance);

}  // namespace zonal
