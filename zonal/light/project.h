#pragma once

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// Radiance as spherical-harmonic coefficients: Σ over texels of radiance times exact solid angle times y_lm at the
/// texel's centre. Of a full picture the mean goes into l = 0 alone and what deviates from it is summed, so a constant
/// is exact in any picture. Any projection (texels that show nothing count as black), any number of bands.
/// Equirectangular maps go through the fast transform; for 3 or 6 bands that runs at about the speed of reading the
/// pixels. The others cost O(texels bands²). The same bits for any number of threads. Throws Error{kInput} when the
/// size does not fit the projection, Error{kCancelled}.
Sh<RgbD> project(const Environment&, int bands, const Run& = {});

template <int N>
Sh<Rgb, N> project(const Environment& environment, const Run& run = {}) {
  return with_bands<N>(cast<Rgb>(project(environment, N, run)));
}

}  // namespace zonal
