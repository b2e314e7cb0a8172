#pragma once

#include "zonal/base/run.h"
#include "zonal/light/convolve.h"
#include "zonal/light/environment.h"
#include "zonal/light/lobe.h"
#include "zonal/report/bake_page.h"

namespace zonal {

/// Compares a map with the brute-force sum over all texels of the environment (light/reference.h) at texels drawn with
/// a fixed seed. `map` is `factor` times the environment seen through the lobe. Differences are relative to the true
/// value of each channel, or to a thousandth of the environment's mean brightness where that is more. Throws
/// std::logic_error when a difference is beyond the bound of the report, unless the environment was resampled on the
/// way (`bounded` false: the bound does not cover that step).
struct VerifyOptions {
  int directions = 64;
  double factor = 1;
  bool bounded = true;
};
Verification verify(const Environment& environment, const Lobe&, const Environment& map, const ConvolveReport&,
                    const VerifyOptions&, const Run& = {});

}  // namespace zonal
