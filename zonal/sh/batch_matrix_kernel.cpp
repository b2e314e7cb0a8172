// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include <utility>

#include "zonal/sh/batch_lanes.h"
#include "zonal/sh/gaunt_list.h"

namespace zonal::ZONAL_ISA {
namespace {

/// The functions k that are in entry (row, column) of a product matrix, and how much of each.
struct Entry {
  int terms = 0;
  int k[8] = {};
  float share[8] = {};

  constexpr void add(int other, double value) {
    k[terms] = other;
    share[terms++] = static_cast<float>(value);
  }
};

/// The lower triangle, entry (row, column) at row (row + 1) / 2 + column.
template <int N>
struct Triangle {
  static constexpr int kEntries = N * N * (N * N + 1) / 2;
  Entry entries[kEntries] = {};

  constexpr Triangle() {
    for (const GauntIntegral& g : kGauntList<N>) {
      at(g.k, g.j).add(g.i, g.value);
      if (g.i != g.j) at(g.k, g.i).add(g.j, g.value);
      if (g.j != g.k) at(g.j, g.i).add(g.k, g.value);
    }
  }
  constexpr Entry& at(int row, int column) { return entries[row * (row + 1) / 2 + column]; }
};

template <int N>
constexpr Triangle<N> kTriangle;

template <int N, int entry, int term = 0>
[[gnu::always_inline]] inline Vec sum_from(BatchIn f) {
  constexpr int k = kTriangle<N>.entries[entry].k[term];
  constexpr float share = kTriangle<N>.entries[entry].share[term];
  if constexpr (kTriangle<N>.entries[entry].terms == 0) {
    return Vec{};
  } else if constexpr (term + 1 == kTriangle<N>.entries[entry].terms) {
    return share * load_row(f, k);
  } else {
    return share * load_row(f, k) + sum_from<N, entry, term + 1>(f);
  }
}

/// One row of the triangle: few enough streams to write at a time, and a loop that stays in the instruction cache.
template <int N, int row>
struct MatrixRow {
  static constexpr int kA = N * N, kB = 0, kOut = row + 1;

  template <int... column>
  [[gnu::always_inline]] static void store_entries(BatchIn f, BatchOut out, std::integer_sequence<int, column...>) {
    (store_row(out, column, sum_from<N, row*(row + 1) / 2 + column>(f)), ...);
  }
  void operator()(BatchIn f, BatchIn, BatchOut out) const {
    store_entries(f, out, std::make_integer_sequence<int, row + 1>());
  }
};

template <int N, int row = 0>
void rows_from(BatchIn f, long count, BatchOut out) {
  MatrixRow<N, row> work;
  over_batch(step_of(work), f, {}, out, count);
  if constexpr (row + 1 < N * N) rows_from<N, row + 1>(f, count, {out.first + (row + 1) * out.stride, out.stride});
}

template <int N>
void matrices(BatchIn f, long count, BatchOut out) {
  Tile tile;  // in the first cache from row to row
  for (long j = 0; j < count; j += kTileItems) {
    const long items = count - j < kTileItems ? count - j : kTileItems;
    rows_from<N>(tile.fill({f.first + j, f.stride}, N * N, items), items, {out.first + j, out.stride});
  }
}

}  // namespace

const BatchMatrixKernels kBatchMatrixKernels = {
    {matrices<1>, matrices<2>, matrices<3>, matrices<4>, matrices<5>, matrices<6>},
};

}  // namespace zonal::ZONAL_ISA
