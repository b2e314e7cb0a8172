// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/sh/batch_lanes.h"
#include "zonal/sh/eval.h"

namespace zonal::ZONAL_ISA {
namespace {

/// Rows that are written as soon as a vector of them is known: together they would not fit the registers.
template <bool PastCaches>
struct RowWriter {
  BatchOut out;
  struct Row {
    float* place;
    [[gnu::always_inline]] void operator=(Vec value) const {
      if constexpr (PastCaches) {
        store_past_caches(place, value);
      } else {
        store(place, value);
      }
    }
  };
  [[gnu::always_inline]] Row operator[](int row) const { return {out.first + row * out.stride}; }
};

template <int N, bool PastCaches>
struct BasisWork {
  static constexpr int kA = 3, kB = 0, kOut = N * N;

  void operator()(BatchIn directions, BatchIn, BatchOut out) const {
    basis_unrolled<N, Vec, float>(load_row(directions, 0), load_row(directions, 1), load_row(directions, 2),
                                  RowWriter<PastCaches>{out});
  }
};

template <int N, int Channels>
struct EvaluateWork {
  static constexpr int kA = 3, kB = 0, kOut = Channels;
  const float* sh;

  void operator()(BatchIn directions, BatchIn, BatchOut out) const {
    Vec y[N * N], sum[Channels];
    basis_unrolled<N, Vec, float>(load_row(directions, 0), load_row(directions, 1), load_row(directions, 2), y);
#pragma GCC unroll 4
    for (int c = 0; c < Channels; ++c) sum[c] = sh[c * N * N] * y[0];
    if constexpr (Channels == 1) {
#pragma GCC unroll 36
      for (int i = 1; i < N * N; ++i) sum[0] += sh[i] * y[i];
    } else {
      // A loop: unrolled, 16 registers do not hold the sums, and each addition waits for memory.
#pragma GCC unroll 1
      for (int i = 1; i < N * N; ++i) {
#pragma GCC unroll 4
        for (int c = 0; c < Channels; ++c) sum[c] += sh[c * N * N + i] * y[i];
      }
    }
#pragma GCC unroll 4
    for (int c = 0; c < Channels; ++c) store_row(out, c, sum[c]);
  }
};

template <int N>
void basis(BatchIn directions, long count, BatchOut out) {
  BasisWork<N, false> work;
  Step step = step_of(work);
  // Only whole cache lines go to memory one by one.
  if constexpr (sizeof(Vec) == 64) step.run_past_caches = run<BasisWork<N, true>>;
  over_batch(step, directions, {}, out, count);
}

template <int N, int Channels>
void evaluate_channels(const float* sh, BatchIn directions, long count, BatchOut out) {
  EvaluateWork<N, Channels> work{sh};
  over_batch(step_of(work), directions, {}, out, count);
}

template <int N>
void evaluate(const float* sh, int channels, BatchIn directions, long count, BatchOut values) {
  // As many channels together as share the work on the basis and leave it its registers.
  constexpr int kTogether = 4;
  for (; channels > 0; channels -= kTogether, sh += kTogether * N * N, values.first += kTogether * values.stride) {
    if (channels == 1) {
      evaluate_channels<N, 1>(sh, directions, count, values);
    } else if (channels == 2) {
      evaluate_channels<N, 2>(sh, directions, count, values);
    } else if (channels == 3) {
      evaluate_channels<N, 3>(sh, directions, count, values);
    } else {
      evaluate_channels<N, kTogether>(sh, directions, count, values);
    }
  }
}

}  // namespace

const BatchEvaluateKernels kBatchEvaluateKernels = {
    {basis<1>, basis<2>, basis<3>, basis<4>, basis<5>, basis<6>},
    {evaluate<1>, evaluate<2>, evaluate<3>, evaluate<4>, evaluate<5>, evaluate<6>},
};

}  // namespace zonal::ZONAL_ISA
