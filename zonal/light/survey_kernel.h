#pragma once

#include "zonal/base/kernel.h"
#include "zonal/math/vec.h"

namespace zonal {

/// Histogram bin i holds log2 luminance in [i - 24, i - 23); darker and brighter fall into the first and last one.
inline constexpr int kLuminanceBins = 48;
inline constexpr int kFirstBinLog2 = -24;

/// What one row of texels of equal solid angle holds.
struct RowCount {
  double sum[3] = {};       // per channel
  double negative_sum = 0;  // of negative channels
  float min_luminance = 0, max_luminance = 0, max_channel = 0;
  int negative_texels = 0;
  int bins[kLuminanceBins] = {};  // texels
  bool finite = true;             // false: a NaN or infinity spoilt the row; nothing else holds
};

/// The inner loop of survey(), for each instruction set.
struct SurveyKernels {
  void (*count_row)(const Rgb* texels, int count, RowCount*);
};

ZONAL_KERNELS(SurveyKernels, kSurveyKernels, survey_kernels);

}  // namespace zonal
