#pragma once

#include "zonal/base/kernel.h"
#include "zonal/math/vec.h"

namespace zonal {

/// Most points of one call. Arrays of coordinates have room for so many, because they are read and written in whole
/// vectors.
inline constexpr int kKernelPoints = 32;

/// The footprints of some target texels in the source's frame: the point (dx, dy) of texel i, -1/2..1/2 of its sides
/// away from its centre, lies toward center + dx across + dy down (not normalised). Indices are [axis][texel].
struct TexelFrames {
  float center[3][kKernelPoints], across[3][kKernelPoints], down[3][kKernelPoints];
};

/// How a panorama's texel coordinates (whole at texel centres) follow from azimuth and elevation in radians.
struct PanoramaScale {
  float x_zero, x_per_radian;
  float y_zero, y_per_radian;
};

struct TexelArray {
  const Rgb* texels;
  int width, height;
};

/// What a texel's sums hold: lanes 0..2 and 3..5 are red, green, blue to be added up, 6 and 7 anything.
inline constexpr int kSumLanes = 8;

/// The inner loops of resample(), one set for each instruction set.
struct ResampleKernels {
  /// Texel coordinates of the point (dx, dy) of each texel. Error below 1e-6 radians.
  void (*panorama_positions)(const TexelFrames&, float dx, float dy, const PanoramaScale&, int count, float* x,
                             float* y);
  /// Adds the value between texels at (x[i], y[i]) to sums[8 i ...]: straight lines, or sample_taps.h's limited cubic.
  /// Points whose 4 x 4 texels do not all lie inside the picture, its last row left out, are not added but listed;
  /// returns how many.
  int (*add_linear)(const TexelArray&, int count, const float* x, const float* y, float* sums, int* missed);
  int (*add_cubic)(const TexelArray&, int count, const float* x, const float* y, float* sums, int* missed);
  /// Sum and largest of `count` numbers.
  void (*sum_and_max)(const float* values, int count, float* sum, float* max);
};

ZONAL_KERNELS(ResampleKernels, kResampleKernels, resample_kernels);

}  // namespace zonal
