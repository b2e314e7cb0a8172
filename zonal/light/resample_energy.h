#pragma once

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/light/resample_tiles.h"

namespace zonal {

/// Samples at the footprint's spacing give smooth light its energy, but a single texel that outshines the map (a sun)
/// up to a few percent more or less, by where the samples fall. This adds to `result` what each such texel lacks, in
/// proportion to what the target texels already have of it, so that Σ radiance * solid angle of it is kept. For targets
/// that show the whole sphere.
void keep_bright_texels(const Environment& source, const TileResampler&, const Run&, Environment& result);

}  // namespace zonal
