// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/sh/product_kernel.h"

#include <type_traits>

#include "zonal/sh/ring_tables.h"
#include "zonal/sh/ring_waves.h"

// For one pair of functions the lanes are pairs of rings.
namespace zonal::ZONAL_ISA {
namespace {

constexpr int kFloatLanes = 4, kDoubleLanes = ZONAL_LANES < 4 ? 2 : 4;
using Floats = float __attribute__((vector_size(kFloatLanes * sizeof(float))));
using Doubles = double __attribute__((vector_size(kDoubleLanes * sizeof(double))));

template <class T>
constexpr int kLanes = std::is_same_v<T, float> ? kFloatLanes : kDoubleLanes;
template <class T>
using Vec = std::conditional_t<std::is_same_v<T, float>, Floats, Doubles>;

/// RingTables with pairs side by side; lanes that are left over count nothing.
template <int N, class T>
struct Tables {
  static constexpr int kPairs = RingTables<N>::kPairs;
  static constexpr int kVectors = (kPairs + kLanes<T> - 1) / kLanes<T>;
  Vec<T> synthesis[kVectors][N][N] = {}, analysis[kVectors][N][N] = {};

  constexpr Tables() {
    constexpr RingTables<N> exact;
    for (int vector = 0; vector < kVectors; ++vector) {
      for (int l = 0; l < N; ++l) {
        for (int m = 0; m < N; ++m) {
          synthesis[vector][l][m] = lanes_of(exact.synthesis, vector, l, m);
          analysis[vector][l][m] = lanes_of(exact.analysis, vector, l, m);
        }
      }
    }
  }

  static constexpr Vec<T> lanes_of(const double (&table)[kPairs][N][N], int vector, int l, int m) {
    const auto entry = [&](int lane) {
      const int pair = vector * kLanes<T> + lane;
      return pair < kPairs ? static_cast<T>(table[pair][l][m]) : T{};
    };
    if constexpr (kLanes<T> == 2) {
      return Vec<T>{entry(0), entry(1)};
    } else {
      return Vec<T>{entry(0), entry(1), entry(2), entry(3)};
    }
  }
};

template <int N, class T>
constexpr Tables<N, T> kTables;

/// The sums of the lanes of four vectors.
template <class V>
[[gnu::always_inline]] inline V add_lanes_of_four(V a, V b, V c, V d) {
  const V ab = __builtin_shufflevector(a, b, 0, 4, 1, 5) + __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const V cd = __builtin_shufflevector(c, d, 0, 4, 1, 5) + __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

template <int Count, class T>
[[gnu::always_inline]] inline void add_lanes(const Vec<T>* vectors, T* sums) {
  int i = 0;
  if constexpr (kLanes<T> == 4) {
#pragma GCC unroll 9
    for (; i + 4 <= Count; i += 4) {
      const Vec<T> four = add_lanes_of_four(vectors[i], vectors[i + 1], vectors[i + 2], vectors[i + 3]);
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) sums[i + k] = four[k];
    }
  }
#pragma GCC unroll 36
  for (; i < Count; ++i) {
    T sum = vectors[i][0];
#pragma GCC unroll 4
    for (int lane = 1; lane < kLanes<T>; ++lane) sum += vectors[i][lane];
    sums[i] = sum;
  }
}

template <int N, class T>
void product(const T* f, const T* g, T* result) {
  Vec<T> parts[N * N] = {};
  for (int vector = 0; vector < Tables<N, T>::kVectors; ++vector) {
    Waves<N, Vec<T>> f_north, f_south, g_north, g_south, north, south;
    synthesize<N>(f, kTables<N, T>.synthesis[vector], f_north, f_south);
    synthesize<N>(g, kTables<N, T>.synthesis[vector], g_north, g_south);
    multiply_waves(f_north, g_north, north);
    multiply_waves(f_south, g_south, south);
    analyze<N>(north, south, kTables<N, T>.analysis[vector], parts);
  }
  add_lanes<N * N>(parts, result);
}

}  // namespace

const ProductKernels kProductKernels = {
    {product<1, float>, product<2, float>, product<3, float>, product<4, float>, product<5, float>, product<6, float>},
    {product<1, double>, product<2, double>, product<3, double>, product<4, double>, product<5, double>,
     product<6, double>},
};

}  // namespace zonal::ZONAL_ISA
