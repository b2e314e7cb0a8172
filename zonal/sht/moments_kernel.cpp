// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/sht/kernels.h"

namespace zonal::ZONAL_ISA {
namespace {

constexpr int kLanes = 2 * ZONAL_LANES;  // floats
using Vec = float __attribute__((vector_size(kLanes * sizeof(float))));
using Unaligned = float __attribute__((vector_size(kLanes * sizeof(float)), aligned(sizeof(float))));
using Half = float __attribute__((vector_size(ZONAL_LANES * sizeof(float))));
using Wide = double __attribute__((vector_size(ZONAL_LANES * sizeof(double))));

// Floats are summed this many times before they go on in double: a relative error of at most 16 * 2^-24.
constexpr int kFloatRun = 16;
constexpr int kPhases = 3;  // interleaved RGB: vector j starts with channel j * kLanes mod 3
constexpr int kChunk = kPhases * kFloatRun;

inline Vec load(const float* p) { return *reinterpret_cast<const Unaligned*>(p); }

/// Sums of one row: entry 0 is Σ f, entries 2m-1 and 2m are Re and Im of Σ f exp(-2πi m x / W).
template <class T, int Bands>
struct Sums {
  T of[2 * Bands - 1] = {};
};

/// Four texels a quarter turn apart share their cosines: (f0 + f2) ± (f1 + f3) serve even m, (f0 - f2) and (f1 - f3)
/// odd m. table[m - 1] is [cos, sin]; T is one float or a vector of them.
template <int Bands, class T>
inline void add_quarters(Sums<T, Bands>& sums, T f0, T f1, T f2, T f3, const T (&table)[2 * Bands]) {
  const T even = f0 + f2, odd = f0 - f2, even_turned = f1 + f3, odd_turned = f1 - f3;
  const T all = even + even_turned, alternate = even - even_turned;
  sums.of[0] += all;
  for (int m = 1; m < Bands; ++m) {
    const T cosine = table[2 * m - 2], sine = table[2 * m - 1];
    T& re = sums.of[2 * m - 1];
    T& im = sums.of[2 * m];
    if (m % 2 == 0) {
      const T f = m % 4 == 0 ? all : alternate;
      re += f * cosine;
      im -= f * sine;
    } else if (m % 4 == 1) {
      re += odd * cosine - odd_turned * sine;
      im -= odd * sine + odd_turned * cosine;
    } else {
      re += odd * cosine + odd_turned * sine;
      im -= odd * sine - odd_turned * cosine;
    }
  }
}

template <int Bands>
struct RowSums {
  Wide of[kPhases][2 * Bands - 1][2] = {};

  void flush(int phase, const Sums<Vec, Bands>& run) {
    for (int i = 0; i < 2 * Bands - 1; ++i) {
      const Half* halves = reinterpret_cast<const Half*>(&run.of[i]);
      of[phase][i][0] += __builtin_convertvector(halves[0], Wide);
      of[phase][i][1] += __builtin_convertvector(halves[1], Wide);
    }
  }

  void add_to(double* sums) const {
    for (int phase = 0; phase < kPhases; ++phase) {
      for (int i = 0; i < 2 * Bands - 1; ++i) {
        const double* lanes = reinterpret_cast<const double*>(of[phase][i]);
        for (int lane = 0; lane < kLanes; ++lane) sums[3 * i + (phase * kLanes + lane) % 3] += lanes[lane];
      }
    }
  }
};

template <int Bands>
void row_moments(const float* north, const float* south, int width, const float* table, double* sums) {
  const int quarter = 3 * (width / 4);
  const int vectors = quarter / kLanes;
  const int rows = south == nullptr ? 1 : 2;
  RowSums<Bands> totals[2];
  for (int begin = 0; begin < vectors; begin += kChunk) {
    const int end = begin + kChunk < vectors ? begin + kChunk : vectors;
    for (int phase = 0; phase < kPhases; ++phase) {
      Sums<Vec, Bands> north_run, south_run;
      for (int j = begin + phase; j < end; j += kPhases) {
        Vec turn[2 * Bands];
        for (int i = 0; i < 2 * (Bands - 1); ++i) turn[i] = load(table + (2L * (Bands - 1) * j + i) * kLanes);
        const float* f = north + static_cast<long>(j) * kLanes;
        add_quarters<Bands>(north_run, load(f), load(f + quarter), load(f + 2L * quarter), load(f + 3L * quarter),
                            turn);
        if (rows == 1) continue;
        f = south + static_cast<long>(j) * kLanes;
        add_quarters<Bands>(south_run, load(f), load(f + quarter), load(f + 2L * quarter), load(f + 3L * quarter),
                            turn);
      }
      totals[0].flush(phase, north_run);
      if (rows == 2) totals[1].flush(phase, south_run);
    }
  }
  const float* rest = table + 2L * (Bands - 1) * vectors * kLanes;
  for (int row = 0; row < rows; ++row) {
    double* out = sums + static_cast<long>(row) * 3 * (2 * Bands - 1);
    totals[row].add_to(out);
    const float* f = row == 0 ? north : south;
    for (int i = vectors * kLanes; i < quarter; ++i) {
      double turn[2 * Bands];
      for (int k = 0; k < 2 * (Bands - 1); ++k) turn[k] = rest[2L * (Bands - 1) * (i - vectors * kLanes) + k];
      Sums<double, Bands> one;
      add_quarters<Bands, double>(one, f[i], f[i + quarter], f[i + 2L * quarter], f[i + 3L * quarter], turn);
      for (int k = 0; k < 2 * Bands - 1; ++k) out[3 * k + i % 3] += one.of[k];
    }
  }
}

}  // namespace

const MomentKernels kMomentKernels = {kLanes, row_moments<3>, row_moments<6>};

}  // namespace zonal::ZONAL_ISA
