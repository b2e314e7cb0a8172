#pragma once

// For the batch kernels alone, each of which is compiled once per instruction set (see cmake/zonal.cmake): internal to
// the file that includes it.
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "zonal/sh/batch_kernels.h"

namespace zonal::ZONAL_ISA {
namespace {

constexpr int kLanes = 2 * ZONAL_LANES;  // floats
using Vec = float __attribute__((vector_size(kLanes * sizeof(float))));
using UnalignedVec = float __attribute__((vector_size(kLanes * sizeof(float)), aligned(sizeof(float)), may_alias));

inline Vec load(const float* p) { return *reinterpret_cast<const UnalignedVec*>(p); }
inline void store(float* p, Vec v) { *reinterpret_cast<UnalignedVec*>(p) = v; }
inline Vec load_row(BatchIn in, long row) { return load(in.first + row * in.stride); }
inline void store_row(BatchOut out, long row, Vec v) { store(out.first + row * out.stride, v); }

/// How many vectors hold so many items.
inline long vectors_of(long count) { return (count + kLanes - 1) / kLanes; }

/// To memory without a place in the caches; `p` is aligned to the vector.
inline void store_past_caches(float* p, Vec v) {
#if !defined(__x86_64__)
  store(p, v);
#elif ZONAL_LANES == 8
  _mm512_stream_ps(p, v);
#elif ZONAL_LANES == 4
  _mm256_stream_ps(p, v);
#else
  _mm_stream_ps(p, v);
#endif
}
inline void finish_stores_past_caches() {
#if defined(__x86_64__)
  _mm_sfence();
#endif
}

/// What is done to a batch: Work::kA, kB and kOut are the rows of its inputs and its output, and work(a, b, out) does
/// one vector of each.
struct Step {
  /// So many vectors. Never inlined: the bits of an item must not depend on its place in the batch, so whole vectors
  /// and the rest go through the same instructions.
  void (*run)(void* work, BatchIn a, BatchIn b, BatchOut out, long vectors);
  void* work;
  int a_rows, b_rows, out_rows;
  /// The same with a result that goes to memory past the caches; null where the step has no such form.
  void (*run_past_caches)(void* work, BatchIn a, BatchIn b, BatchOut out, long vectors);
};

template <class Work>
[[gnu::noinline]] void run(void* any, BatchIn a, BatchIn b, BatchOut out, long vectors) {
  Work& work = *static_cast<Work*>(any);
  for (long i = 0; i < vectors; ++i) {
    work(a, b, out);
    a.first += kLanes;
    b.first += kLanes;
    out.first += kLanes;
  }
}

template <class Work>
inline Step step_of(Work& work) {
  return {run<Work>, &work, Work::kA, Work::kB, Work::kOut, nullptr};
}

/// Items that are copied close together where rows cannot be used where they are.
constexpr long kTileItems = 256;
constexpr long kTileStride = kTileItems + 16;  // an odd number of cache lines
constexpr int kTileRows = coefficient_count(kMaxStaticBands);

struct Tile {
  alignas(64) float values[kTileRows * kTileStride];

  BatchOut rows() { return {values, kTileStride}; }

  /// The last item again behind the last, to a whole vector.
  BatchIn fill(BatchIn from, int rows, long count) {
    for (int row = 0; row < rows; ++row) {
      const float* source = from.first + row * from.stride;
      float* place = values + row * kTileStride;
      long i = 0;
      for (; i + kLanes <= count; i += kLanes) store(place + i, load(source + i));
      for (const long end = vectors_of(count) * kLanes; i < end; ++i) place[i] = source[i < count ? i : count - 1];
    }
    return {values, kTileStride};
  }
  void copy_to(BatchOut to, int rows, long count, bool past_caches) const {
    for (int row = 0; row < rows; ++row) {
      const float* source = values + row * kTileStride;
      float* place = to.first + row * to.stride;
      long i = 0;
      if (past_caches) {
        for (; i < count; i += kLanes) store_past_caches(place + i, load(source + i));
      } else {
        for (; i + kLanes <= count; i += kLanes) store(place + i, load(source + i));
        for (; i < count; ++i) place[i] = source[i];
      }
    }
  }
};

/// Whether so many rows, used side by side, compete for the same few places of a cache: 64 sets of lines of 64 bytes
/// are a common first cache, and rows a multiple of 1024 bytes apart share 4 of the sets.
inline bool crowded(int rows, long stride) { return rows > 16 && stride % 256 == 0; }

/// A result larger than this goes to memory past the caches: they would have lost it before it is read.
constexpr long kLargeBytes = 32L << 20;

/// The step for every item. `out` may be one of the inputs.
[[gnu::noinline]] void over_batch(const Step& step, BatchIn a, BatchIn b, BatchOut out, long count) {
  const bool past_caches = reinterpret_cast<unsigned long>(out.first) % 64 == 0 && out.stride % 16 == 0 &&
                           count % 16 == 0 && step.out_rows * out.stride * long{sizeof(float)} > kLargeBytes;
  const bool inputs_crowded = crowded(step.a_rows, a.stride) || crowded(step.b_rows, b.stride);
  if (past_caches && !inputs_crowded && step.run_past_caches != nullptr) {
    step.run_past_caches(step.work, a, b, out, count / kLanes);
    finish_stores_past_caches();
    return;
  }
  const bool staged = past_caches || inputs_crowded || crowded(step.out_rows, out.stride);
  const long direct = staged ? 0 : count / kLanes * kLanes;
  step.run(step.work, a, b, out, direct / kLanes);
  if (direct == count) return;
  if (direct > 0 && out.first != a.first && out.first != b.first) {
    // The last whole vector once more, shifted: what it has in common with the one before comes out the same.
    const long last = count - kLanes;
    step.run(step.work, {a.first + last, a.stride}, {b.first + last, b.stride}, {out.first + last, out.stride}, 1);
    return;
  }
  Tile tile_a, tile_b, tile_out;
  for (long j = direct; j < count; j += kTileItems) {
    const long items = count - j < kTileItems ? count - j : kTileItems;
    step.run(step.work, tile_a.fill({a.first + j, a.stride}, step.a_rows, items),
             tile_b.fill({b.first + j, b.stride}, step.b_rows, items), tile_out.rows(), vectors_of(items));
    tile_out.copy_to({out.first + j, out.stride}, step.out_rows, items, past_caches);
  }
  if (past_caches) finish_stores_past_caches();
}

}  // namespace
}  // namespace zonal::ZONAL_ISA
