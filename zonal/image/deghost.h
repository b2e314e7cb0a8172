#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/response.h"

namespace zonal {

struct DeghostOptions {
  double threshold = 4;  ///< standard deviations by which a logarithm of radiance must differ to be called moved
  TrustedRanges trusted = {};
};

/// Which parts of which exposures to leave out of a merge, because something moved.
struct Deghosting {
  std::vector<Image<std::uint8_t>>
      masks;                     ///< for MergeOptions::masks: 255 where an exposure agrees, 0 where it does not
  int reference = 0;             ///< the exposure whose moment is shown
  double noise_codes = 1;        ///< the noise that was measured: standard deviation in codes of 255
  std::vector<double> left_out;  ///< for each exposure, share of its texels with a mask below one half
};

/// Compares every exposure with a reference: the one with the most weight (best exposed); where that has no code of
/// weight 0.1, the nearest in exposure that has. An exposure disagrees at a texel when in some channel, both codes
/// having such a weight,
///
///     |ln(X(z) / t) - ln(X(z_ref) / t_ref)| > threshold sqrt(s² + s_ref²),   s = noise_codes d ln X / dz,
///
/// the noise being measured as the median over all such pairs (times 1.48; one code at least). A mask falls smoothly
/// from 1 to 0 as the share of disagreeing texels in the window around grows from 1/8 to 3/8 (5x5, or 1/150 of the
/// shorter side), so that single noisy texels stay and the rims of what moved go. Memory: one byte a texel and
/// exposure.
Deghosting deghost(const Exposures&, const Response&, const DeghostOptions& = {}, const Run& = {});

}  // namespace zonal
