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
  Shift shift;              ///< against the exposure that stays where it is
  double disagreement = 0;  ///< share of the compared bits that differ from the next exposure toward that one
  bool too_flat = false;    ///< nothing to hold on to (all black or all white): it was left where its neighbour is
};

/// Finds the translation of hand-held shots and sets their shifts: median threshold bitmaps (Ward 2003). Both pictures
/// of a pair are cut at the same percentile of their own brightness, which does not depend on the exposure; texels near
/// the threshold do not count; the shift with the smallest share of different bits is looked for in full in pictures
/// halved to some 32 texels, then refined by one texel at each finer level. Ward cuts at the median (here also at other
/// percentiles, where the median is black or white) and looks one texel around at the coarsest level too. Neighbours in
/// exposure are compared, and the middle exposure stays where it is. Whole texels; no rotation. For an arranged
/// bracket.
std::vector<Alignment> align_exposures(Exposures&, const AlignOptions& = {}, const Run& = {});

}  // namespace zonal
