#pragma once

#include "zonal/base/kernel.h"
#include "zonal/sh/sh.h"

/// The loops of batch.h, which has their contracts. SIMD lanes hold different items of a batch; nothing is shuffled.
/// Arrays of functions are indexed by bands - 1.
namespace zonal {

/// The rows of a batch: number i of item j is first[i * stride + j].
template <class T>
struct BatchRows {
  T* first;
  long stride;
};
using BatchIn = BatchRows<const float>;
using BatchOut = BatchRows<float>;

struct BatchEvaluateKernels {
  /// directions: x, y, z.
  void (*basis[kMaxStaticBands])(BatchIn directions, long count, BatchOut basis);
  /// sh[channel][coefficient].
  void (*evaluate[kMaxStaticBands])(const float* sh, int channels, BatchIn directions, long count, BatchOut values);
};
ZONAL_KERNELS(BatchEvaluateKernels, kBatchEvaluateKernels, batch_evaluate_kernels);

struct BatchRotateKernels {
  /// blocks: as rotation_blocks() makes them.
  void (*by_one[kMaxStaticBands])(const float* blocks, BatchIn from, long count, BatchOut to);
  /// rotations: the nine entries, rows first. Returns whether all of them are orthogonal.
  bool (*by_each[kMaxStaticBands])(BatchIn rotations, BatchIn from, long count, BatchOut to);
};
ZONAL_KERNELS(BatchRotateKernels, kBatchRotateKernels, batch_rotate_kernels);

struct BatchProductKernels {
  void (*product[kMaxStaticBands])(BatchIn f, BatchIn g, long count, BatchOut result);
};
ZONAL_KERNELS(BatchProductKernels, kBatchProductKernels, batch_product_kernels);

struct BatchMatrixKernels {
  /// matrices: entry (i, j), j <= i, in row i (i + 1) / 2 + j.
  void (*matrices[kMaxStaticBands])(BatchIn f, long count, BatchOut matrices);
};
ZONAL_KERNELS(BatchMatrixKernels, kBatchMatrixKernels, batch_matrix_kernels);

}  // namespace zonal
