#pragma once

#include <optional>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/io/roughness_map.h"
#include "zonal/light/environment.h"
#include "zonal/light/lobe.h"
#include "zonal/light/survey.h"
#include "zonal/report/bake_page.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// What to make of an environment.
struct BakeOptions {
  int size_px = 256;  ///< face edge of the chain's level 0
  int levels = 0;     ///< of the chain, each half of the last; 0: down to 16 px
  LobeKind lobe = LobeKind::kGgx;
  RoughnessMap roughness_map = RoughnessMap::kLinear;
  int bands = 3;  ///< of the coefficients
  int irradiance_px = 64;
  int table_px = 128;
};

/// The number of levels that `levels` = 0 stands for: 5 for 256, at least 1.
int default_levels(int size_px);

/// All the light of one environment, ready for a renderer. Every map is a cube stack in the memory frame.
struct Bake {
  Environment panorama;           ///< a small equirectangular copy, to look at
  std::vector<ChainLevel> chain;  ///< level 0: the environment, not convolved

  Environment irradiance;  ///< E, not divided by pi
  ConvolveReport irradiance_report;
  std::optional<Verification> irradiance_verified;
  RgbD irradiance_up, irradiance_down;

  Sh<RgbD> radiance;        ///< coefficients of the environment
  std::vector<ShFit> fits;  ///< 1..6 bands

  Image<Rgb> split_sum;  ///< DfgVariant::kStandard

  std::vector<Timing> timings;
};

/// Fills a Bake. `shown` (or null) is a map of the environment's projection and size, 1 where it is known and 0 where
/// it is not: the rest is left out of every mean (light/partial.h). With `verify`, every convolved map is compared with
/// the brute-force sum at 64 texels, and a difference beyond the stated bound throws std::logic_error. Throws
/// Error{kUsage} for options outside their domain, Error{kInput} for values that are not finite, Error{kCancelled}.
Bake bake(const Environment&, const Environment* shown, const BakeOptions&, bool verify, const Run& = {});

/// (bias, scale + bias, charlie): DfgVariant::kMultiscatter from the standard table.
Image<Rgb> multiscatter_from_standard(Image<Rgb> table);

}  // namespace zonal
