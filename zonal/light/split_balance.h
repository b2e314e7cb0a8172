#pragma once

#include "zonal/light/split.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// Of what a picture shows.
SplitSum split_sum(const Environment&, const Mapping&, const Run&);

/// Of discs of light.
SplitSum split_sum(const std::vector<SplitLight>&);

}  // namespace zonal
