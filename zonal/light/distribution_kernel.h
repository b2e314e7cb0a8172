#pragma once

#include "zonal/base/kernel.h"

namespace zonal {

/// What one row of a map holds.
struct RowTally {
  double sum = 0;    ///< of the absolute values; not finite when one of them is not
  float lowest = 0;  ///< the least value, or 0
};

/// Looks at a row in groups of 16 texels, 48 floats, the last one shorter: the largest absolute value of each into
/// `groups`.
using TallyRow = RowTally (*)(const float* row, int floats, float* groups);
inline constexpr int kGroupTexels = 16;

ZONAL_KERNELS(TallyRow, kTallyRow, tally_row);

}  // namespace zonal
