#pragma once

#include "zonal/light/split.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// Of what a picture shows.
SphereSum sphere_sum(const Environment&, const Mapping&, const Run&);

/// Of discs of light.
SphereSum sphere_sum(const std::vector<SplitLight>&);

}  // namespace zonal
