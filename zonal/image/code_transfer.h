#pragma once

#include "zonal/image/align_grey.h"

namespace zonal {

/// Makes two exposures of one scene alike: a table for each that turns its codes into those of the shorter exposure,
/// cut to the range in which both see the light. What the longer one saturates and what the shorter one leaves black is
/// the same constant in both then, so that they differ by noise and place alone, and every texel can be compared.
struct CodeTransfer {
  std::array<float, kGreyLevels> shorter = {}, longer = {};
  float range = 0;  ///< how many codes are left between the ends
};

/// The codes of the longer exposure are matched by histogram: as many texels of the scene are darker than a code's
/// light in one exposure as in the other, wherever they lie (Grossberg & Nayar 2003). So the camera's curve need not be
/// known, and the pictures may still be misplaced by a little. Takes the histograms of the part that both show.
CodeTransfer transfer_codes(const GreyHistogram& shorter, const GreyHistogram& longer);

}  // namespace zonal
