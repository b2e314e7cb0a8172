#pragma once

#include "zonal/image/align_pyramid.h"
#include "zonal/image/placement.h"

namespace zonal {

/// A placement found by least squares, and how good it is.
struct Refined {
  Placement placement;
  double residual_codes = 0;  ///< robust standard deviation of what is left, in codes of the shorter exposure
  double correlation = 0;     ///< of the two pictures where they have structure; 1: they show the same
  double error_px = 0;  ///< standard error of the place of a corner, as the residual has it; infinite: undetermined
};

/// The placement of `moving` against `fixed`, pyramids of pictures that codes were made alike for (code_transfer.h),
/// near `start`: shift and rotation that minimise the differences of all texels, by Gauss-Newton steps from the
/// coarsest level to the finest. The steps are taken in `fixed`, whose differences between texels do not change
/// (inverse compositional: Baker & Matthews 2004), the coarsest from several rotations up to 6 degrees. Differences
/// beyond 4.7 standard deviations do not count (Tukey's biweight): what moved by itself does not pull. Serial,
/// O(texels).
Refined refine_placement(const std::vector<Image<float>>& fixed, const std::vector<Image<float>>& moving,
                         const Placement& start);
/// The same from a placement that is right to a texel or two: on the finest levels alone, without a search.
Refined polish_placement(const std::vector<Image<float>>& fixed, const std::vector<Image<float>>& moving,
                         const Placement& start);

/// 1 for the texels of `fixed` at which both have data and differ by less than three standard deviations (`found` says
/// what that is): what shows the same in both.
Image<std::uint8_t> agreeing_texels(const Image<float>& fixed, const Image<float>& moving, const Refined& found);

}  // namespace zonal
