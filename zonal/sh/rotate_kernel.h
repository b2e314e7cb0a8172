#pragma once

#include "zonal/base/kernel.h"

namespace zonal {

/// Turns functions of 4, 5 or 6 bands, one behind the other; at index bands - 4. `rotation` is its nine entries, rows
/// first. `to` may be `from`.
struct RotateKernels {
  void (*in_float[3])(const double* rotation, const float* from, float* to, long count);
  void (*in_double[3])(const double* rotation, const double* from, double* to, long count);
};
ZONAL_KERNELS(RotateKernels, kRotateKernels, rotate_kernels);

}  // namespace zonal
