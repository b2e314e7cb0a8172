#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/exposures.h"

namespace zonal {

struct AlignOptions {
  int largest_shift_px = 0;  ///< to look for between neighbouring exposures; 0: an eighth of the shorter side
};

/// How one exposure was laid on its neighbour.
struct Alignment {
  Placement placement;        ///< against the exposure that stays where it is
  double residual_codes = 0;  ///< robust standard deviation of the differences left between the smoothed pictures
  double correlation = 1;     ///< of the two where they have structure
  double error_px = 0;        ///< standard error of the place of a corner, by that residual
  bool aligned = true;        ///< false: nothing to hold on to; it was left where its neighbour is
};

/// Finds shift and rotation of hand-held shots and sets their placements. Each exposure is compared with its neighbour
/// toward the middle one, which stays where it is (with the next but one where that fails, and so on): coarsely by
/// threshold bitmaps (align_bitmaps.h), then by least squares to a fraction of a texel (align_refine.h), the longer
/// exposure's codes being brought to those of the shorter by their histograms (code_transfer.h): no response is needed,
/// exposures may be stops apart, and what is clipped in one is clipped in both. Not aligned: pairs that correlate by
/// less than 0.8, whose corners are uncertain by half a pixel or more, or that turned by more than 10 degrees. A
/// placement within 0.05 px of whole texels everywhere becomes that: its texels keep their codes. Shift and rotation
/// only: a camera that tilts by an angle a moves what is off the axis by more, by a² f at the most for shots of focal
/// length f px. For an arranged bracket. O(exposures texels), a pair at a time in memory for each thread; same bits on
/// any threads. Throws Error{kCancelled}.
std::vector<Alignment> align_exposures(Exposures&, const AlignOptions& = {}, const Run& = {});

}  // namespace zonal
