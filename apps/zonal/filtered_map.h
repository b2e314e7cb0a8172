#pragma once

#include "apps/zonal/input.h"
#include "apps/zonal/output.h"
#include "zonal/light/convolve.h"

namespace zonal {

/// The light of an input seen through a lobe, as a map; says the error bound.
Convolved filtered_map(const InputOptions&, const Lobe&, const Projection& to, ImageSize, Call&);

/// Where a map of this size goes.
ImageSize target_size(const OutputOptions&, const Projection& to, int fallback_px);

}  // namespace zonal
