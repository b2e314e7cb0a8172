#pragma once

#include "zonal/base/kernel.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// The product of two functions of as many bands as it keeps, at index bands - 1. `result` may be `f` or `g`.
struct ProductKernels {
  void (*in_float[kMaxStaticBands])(const float* f, const float* g, float* result);
  void (*in_double[kMaxStaticBands])(const double* f, const double* g, double* result);
};
ZONAL_KERNELS(ProductKernels, kProductKernels, product_kernels);

}  // namespace zonal
