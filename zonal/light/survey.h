#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/light/survey_kernel.h"
#include "zonal/math/vec.h"
#include "zonal/sphere/projection.h"

namespace zonal {

/// The brightest compact region of a map, when it stands out like a sun or a lamp.
struct SunEstimate {
  Vec3 toward_sun;          ///< centroid of its energy, unit
  double diameter_deg = 0;  ///< of the disc with its solid angle; a texel's size at least
  RgbD irradiance;          ///< on a surface that faces it, above the surrounding sky
  double energy_share = 0;  ///< of the whole map's luminance, 0..1
  bool operator==(const SunEstimate&) const = default;
};

struct Survey {
  ImageSize size;
  double shown = 0;  ///< solid angle shown, steradians (4π for a full picture)
  RgbD mean;         ///< by solid angle, over finite texels
  double min_luminance = 0;
  double max_luminance = 0;
  Vec3 toward_max;              ///< where the maximum is
  std::int64_t texels = 0;      ///< texels that show something
  std::int64_t nan_texels = 0;  ///< with a NaN in any channel: in no sum
  std::int64_t inf_texels = 0;  ///< with an infinity (and no NaN): in no sum
  std::int64_t negative_texels = 0;
  double negative_energy_share = 0;  ///< |sum of negative channels| / sum of positive channels, by solid angle
  std::int64_t plateau_texels = 0;   ///< texels whose largest channel is exactly the map's largest
  bool clipped_sun = false;          ///< the plateau looks like a sensor's or format's ceiling in front of a light
  std::array<double, kLuminanceBins> histogram = {};  ///< solid angle by log2 luminance (see kFirstBinLog2), steradians
  std::optional<SunEstimate> sun;                     ///< absent when nothing compact stands out
};

/// What a map holds and what is doubtful about it. One pass over the texels and a short one around the brightest.
/// The same bits for any thread count. Throws Error{kInput} when the size does not fit the projection,
/// Error{kCancelled}.
Survey survey(const Environment&, const Run& = {});

/// How many texels repair() changed.
struct Repairs {
  std::int64_t non_finite = 0;  ///< replaced by the mean of finite neighbours (0 when there is none)
  std::int64_t negative = 0;    ///< their negative channels raised to 0
  bool operator==(const Repairs&) const = default;
};
/// Makes every value finite and not negative, and says how many texels that changed.
Repairs repair(Environment&);

}  // namespace zonal
