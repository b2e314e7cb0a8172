#pragma once

#include <vector>

#include "zonal/base/grid.h"
#include "zonal/math/vec.h"
#include "zonal/sht/kernels.h"

namespace zonal {

/// Ring sums for at most six bands straight from the rows, without a transform: what an irradiance probe needs from a
/// panorama, at about the speed of reading it. Products in float, sums of 16 of them in float, the rest in double:
/// relative error below 1e-6 of the row's absolute sum.
class RingMoments {
 public:
  static constexpr int kMaxBands = 6;
  /// Rows must fall into quarters.
  static bool serves(int width, int bands) { return bands <= kMaxBands && width % 4 == 0; }

  RingMoments(int width, int bands, Isa isa);

  /// values[row][m][re, im][channel] of Σ f exp(-2πi m x / width) for m < bands; row 1 is skipped when south is null.
  using Values = double[2][kMaxBands][2][3];
  void operator()(const float* north, const float* south, Values& values) const;

 private:
  const MomentKernels& kernels_;
  int width_;
  int bands_;  // 3 or 6: what is computed
  std::vector<float> table_;
};

}  // namespace zonal
