// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/sh/batch_lanes.h"
#include "zonal/sh/turns.h"

namespace zonal::ZONAL_ISA {
namespace {

template <int N>
struct RotateByOne {
  static constexpr int kA = N * N, kB = 0, kOut = N * N;
  const float* blocks;

  template <int l>
  void bands_from(BatchIn from, BatchOut to) const {
    if constexpr (l < N) {
      constexpr int kSize = 2 * l + 1;
      Vec old[kSize];  // read before anything is written: `to` may be `from`
#pragma GCC unroll 11
      for (int n = 0; n < kSize; ++n) old[n] = load_row(from, l * l + n);
      const float* row = blocks + l * (4 * l * l - 1) / 3;
      for (int m = 0; m < kSize; ++m, row += kSize) {
        Vec sum = row[0] * old[0];
#pragma GCC unroll 11
        for (int n = 1; n < kSize; ++n) sum += row[n] * old[n];
        store_row(to, l * l + m, sum);
      }
      bands_from<l + 1>(from, to);
    }
  }
  void operator()(BatchIn from, BatchIn, BatchOut to) const { bands_from<0>(from, to); }
};

using Mask = decltype(Vec{} < Vec{});

inline Vec square_root(Vec v) {
  Vec root;
  for (int i = 0; i < kLanes; ++i) root[i] = __builtin_sqrtf(v[i]);
  return root;
}

/// A rotation of its own in each lane.
struct Matrices {
  Vec entries[9];
  Vec operator()(int row, int column) const { return entries[3 * row + column]; }
  Vec dot(int i, int j) const {
    return (*this)(i, 0) * (*this)(j, 0) + (*this)(i, 1) * (*this)(j, 1) + (*this)(i, 2) * (*this)(j, 2);
  }

  /// As check_orthogonal() of rotate.h: the norm of R R^T - 1 is at most 1e-6. False for NaN.
  Mask orthogonal() const {
    const Vec xx = dot(0, 0) - 1, yy = dot(1, 1) - 1, zz = dot(2, 2) - 1;
    const Vec xy = dot(0, 1), yz = dot(1, 2), xz = dot(0, 2);
    return xx * xx + yy * yy + zz * zz + 2 * (xy * xy + yz * yz + xz * xz) <= 1e-12f;
  }

  Vec determinant() const {
    return (*this)(0, 0) * ((*this)(1, 1) * (*this)(2, 2) - (*this)(1, 2) * (*this)(2, 1)) +
           (*this)(0, 1) * ((*this)(1, 2) * (*this)(2, 0) - (*this)(1, 0) * (*this)(2, 2)) +
           (*this)(0, 2) * ((*this)(1, 0) * (*this)(2, 1) - (*this)(1, 1) * (*this)(2, 0));
  }

  /// Of the rotation, with a mirror of y before it where `handedness` is -1.
  turns::Angles<Vec> angles(Vec handedness) const {
    const Vec x = (*this)(0, 2), y = (*this)(1, 2), square = x * x + y * y;
    const Vec one = Vec{} + 1, sin_b = square_root(square);
    // So close to the pole a is anybody's guess; c is taken from Z(-a) R, so that the guess does not matter.
    const Mask off_pole = square > 1e-30f;
    const Vec inverse = one / (off_pole ? sin_b : one);
    const Vec cos_a = off_pole ? x * inverse : one, sin_a = off_pole ? y * inverse : Vec{};
    return {.cos_a = cos_a,
            .sin_a = sin_a,
            .cos_b = (*this)(2, 2),
            .sin_b = sin_b,
            .cos_c = handedness * (cos_a * (*this)(1, 1) - sin_a * (*this)(0, 1)),
            .sin_c = cos_a * (*this)(1, 0) - sin_a * (*this)(0, 0)};
  }
};

template <int N>
struct RotateByEach {
  static constexpr int kA = 9, kB = N * N, kOut = N * N;
  Mask orthogonal = Vec{} == Vec{};

  void operator()(BatchIn rotations, BatchIn from, BatchOut to) {
    Matrices r;
#pragma GCC unroll 9
    for (int i = 0; i < 9; ++i) r.entries[i] = load_row(rotations, i);
    orthogonal &= r.orthogonal();
    const Vec handedness = r.determinant() < 0 ? Vec{} - 1 : Vec{} + 1;
    const turns::Angles<Vec> angles = r.angles(handedness);
    Vec sh[N * N];
#pragma GCC unroll 6
    for (int l = 0; l < N; ++l) {
#pragma GCC unroll 11
      for (int m = -l; m <= l; ++m) {
        const Vec value = load_row(from, l * (l + 1) + m);
        sh[l * (l + 1) + m] = m < 0 ? handedness * value : value;
      }
    }
    turns::turn<N, float>(sh, angles);
#pragma GCC unroll 36
    for (int i = 0; i < N * N; ++i) store_row(to, i, sh[i]);
  }
};

template <int N>
void by_one(const float* blocks, BatchIn from, long count, BatchOut to) {
  RotateByOne<N> work{blocks};
  over_batch(step_of(work), from, {}, to, count);
}

template <int N>
bool by_each(BatchIn rotations, BatchIn from, long count, BatchOut to) {
  RotateByEach<N> work;
  over_batch(step_of(work), rotations, from, to, count);
  bool all = true;
  for (int i = 0; i < kLanes; ++i) all = all && work.orthogonal[i] != 0;
  return all;
}

}  // namespace

const BatchRotateKernels kBatchRotateKernels = {
    {by_one<1>, by_one<2>, by_one<3>, by_one<4>, by_one<5>, by_one<6>},
    {by_each<1>, by_each<2>, by_each<3>, by_each<4>, by_each<5>, by_each<6>},
};

}  // namespace zonal::ZONAL_ISA
