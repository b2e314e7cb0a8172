#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/light/split_sources.h"

namespace zonal {

/// A texel that was filled.
struct FilledTexel {
  Texel texel;
  int source = 0;  ///< which one it was filled for
  Vec3 toward;
  double solid_angle = 0;
  Rgb before;
};

/// Fills the sources' texels and what they touched around them from their rims (split.h says how) and returns what was
/// there, source by source. A source around which there is nothing to fill from is left alone.
std::vector<FilledTexel> fill_sources(Environment&, const Mapping&, const std::vector<Source>&, const Run&);

}  // namespace zonal
