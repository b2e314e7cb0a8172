// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/sh/batch_lanes.h"
#include "zonal/sh/ring_tables.h"
#include "zonal/sh/ring_waves.h"

namespace zonal::ZONAL_ISA {
namespace {

/// RingTables in float.
template <int N>
struct Tables {
  static constexpr int kPairs = RingTables<N>::kPairs;
  float synthesis[kPairs][N][N] = {}, analysis[kPairs][N][N] = {};

  constexpr Tables() {
    constexpr RingTables<N> exact;
    for (int pair = 0; pair < kPairs; ++pair) {
      for (int l = 0; l < N; ++l) {
        for (int m = 0; m < N; ++m) {
          synthesis[pair][l][m] = static_cast<float>(exact.synthesis[pair][l][m]);
          analysis[pair][l][m] = static_cast<float>(exact.analysis[pair][l][m]);
        }
      }
    }
  }
};

template <int N>
constexpr Tables<N> kTables;

template <int N>
struct ProductWork {
  static constexpr int kA = N * N, kB = N * N, kOut = N * N;

  void operator()(BatchIn f, BatchIn g, BatchOut out) const {
    // Copied close together: rows that lie a power of two apart compete for the same few places of a cache.
    Vec a[N * N], b[N * N], product[N * N] = {};
    for (int i = 0; i < N * N; ++i) {
      a[i] = load_row(f, i);
      b[i] = load_row(g, i);
    }
    for (int pair = 0; pair < Tables<N>::kPairs; ++pair) {
      Waves<N, Vec> f_north, f_south, g_north, g_south, north, south;
      synthesize<N>(a, kTables<N>.synthesis[pair], f_north, f_south);
      synthesize<N>(b, kTables<N>.synthesis[pair], g_north, g_south);
      multiply_waves(f_north, g_north, north);
      multiply_waves(f_south, g_south, south);
      analyze<N>(north, south, kTables<N>.analysis[pair], product);
    }
    for (int i = 0; i < N * N; ++i) store_row(out, i, product[i]);
  }
};

template <int N>
void product(BatchIn f, BatchIn g, long count, BatchOut result) {
  ProductWork<N> work;
  over_batch(step_of(work), f, g, result, count);
}

}  // namespace

const BatchProductKernels kBatchProductKernels = {
    {product<1>, product<2>, product<3>, product<4>, product<5>, product<6>},
};

}  // namespace zonal::ZONAL_ISA
