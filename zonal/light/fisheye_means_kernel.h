#pragma once

#include "zonal/base/kernel.h"

namespace zonal {

/// A run of pixels: unit directions, weights, and radiance times weight.
struct LobePixels {
  const float *x, *y, *z, *weight, *r, *g, *b;
};

/// max(c, 0)^exponent f(c) with f(c) = Σ factor[k] T_k(2c - 1), Chebyshev's polynomials. Below `least_cosine` nothing
/// counts, so that no power leaves the range of float.
struct LobeShape {
  int whole;        ///< the exponent's whole part
  float remainder;  ///< and what is left, 0 <= remainder < 1
  float least_cosine;
  const float* factor;
  int factors;  ///< 1 or more
};

struct FisheyeMeansKernels {
  /// sums += Σ over the pixels of the lobe around q times (weight, r, g, b).
  void (*add)(const LobeShape& lobe, const LobePixels& pixels, int count, const float* q, double* sums);
};
ZONAL_KERNELS(FisheyeMeansKernels, kFisheyeMeansKernels, fisheye_means_kernels);

}  // namespace zonal
