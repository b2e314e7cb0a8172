#pragma once

#include "zonal/base/kernel.h"

/// The inner loops of the transform. Each *_kernel.cpp is compiled once per instruction set; SIMD lanes hold different
/// ring pairs (a ring and its mirror image below the equator), so nothing is shuffled. Arrays of doubles whose shape
/// ends in [lanes] hold one SIMD vector per entry and are aligned to it.
namespace zonal {

/// One pass of a Stockham transform (decimation in frequency).
struct FftStage {
  int radix;               // r
  int groups;              // m: the length that is left after this stage
  int stride;              // s: the product of the radices before it
  const double* twiddles;  // twiddles[p][k-1] as (cos, -sin)(2π p k / (r m)), p = 0..m-1, k = 1..r-1
  const double* roots;     // roots[j] as (cos, -sin)(2π j / r), j = 0..r-1; generic radices only
};

/// Complex transforms along rings, `lanes` of them at a time: values[n] is [re, im][lanes].
struct RingKernels {
  int lanes;
  /// X_k = Σ_n x_n exp(-2πi nk/N). Both buffers hold N entries; returns the one that holds the result.
  double* (*fft)(const FftStage* stages, int stage_count, double* values, double* scratch);
  /// values[n] *= factors[n] (complex scalars), and conjugated after that where asked for.
  void (*multiply)(double* values, const double* factors, int count, bool conjugate);
  /// Reads one channel of `lanes` row pairs: re = north, im = south. A null row reads as zero. Rows hold interleaved
  /// RGB.
  void (*load_float)(const float* const* north, const float* const* south, int channel, int width, double* values);
  void (*load_double)(const double* const* north, const double* const* south, int channel, int width, double* values);
  void (*store_float)(const double* values, int channel, int width, float* const* north, float* const* south);
  void (*store_double)(const double* values, int channel, int width, double* const* north, double* const* south);
  /// From the transform of a packed pair to the sums Σ f cos mφ and Σ f sin mφ of (north + south) and (north - south),
  /// m < bands: spectrum + m * spectrum_stride is [symmetric, antisymmetric][channel][cos, sin][lanes]. phases[m] =
  /// exp(-imφ_0), φ_0 the azimuth of texel 0; weights[lanes] multiplies each ring.
  void (*unpack)(const double* values, int width, int channel, int bands, const double* phases, const double* weights,
                 double* spectrum, long spectrum_stride);
  /// The adjoint: from cos/sin amplitudes of the two rings' half sums to the values whose transform is the packed pair.
  void (*pack)(const double* spectrum, long spectrum_stride, int channel, int bands, const double* phases, int width,
               double* values);
};
ZONAL_KERNELS(RingKernels, kRingKernels, ring_kernels);

/// The few lowest sums of a pair of rows at the speed of reading them, for 3 or 6 bands. sums is [row][entry][channel]:
/// entry 0 is Σ f, entries 2m-1 and 2m are Re and Im of Σ f exp(-2πi m x / width), width a multiple of 4. Rows hold
/// interleaved RGB; south may be null. table holds cos and sin of 2π m x / width as float for each float i = 3x +
/// channel of a quarter row: [i / lanes][m - 1][cos, sin][lanes], and the rest past whole vectors as [i][m - 1][cos,
/// sin].
struct MomentKernels {
  int lanes;
  void (*three)(const float* north, const float* south, int width, const float* table, double* sums);
  void (*six)(const float* north, const float* south, int width, const float* table, double* sums);
};
ZONAL_KERNELS(MomentKernels, kMomentKernels, moment_kernels);

/// The associated Legendre functions of one m by their three-term recurrence q_l = step_l x q_{l-1} - q_{l-2}, where
/// sqrt(2 - δ_m0) K_lm P_lm(x) = scale_l q_l.
struct LegendreColumn {
  int m;
  int bands;           // l = m..bands-1
  double seed;         // q_m / sin^m θ
  const double* step;  // step[l - m]
};

/// Rings come in blocks of `lanes` pairs. x = cos θ and sine = sin θ of the northern ring, [block][lanes].
/// spectrum is [block][12][lanes] with 12 = [symmetric, antisymmetric][channel][cos, sin].
struct LegendreKernels {
  int lanes;
  /// sums[l - m][6][lanes] += Σ_blocks q_l(x) spectrum[l - m odd][6].
  void (*analyze)(const LegendreColumn& column, int blocks, const double* x, const double* sine, const double* spectrum,
                  double* sums);
  /// spectrum[.][6] = Σ_l q_l(x) coefficients[l - m][6], split by the parity of l - m.
  void (*synthesize)(const LegendreColumn& column, int blocks, const double* x, const double* sine,
                     const double* coefficients, double* spectrum);
};
ZONAL_KERNELS(LegendreKernels, kLegendreKernels, legendre_kernels);

}  // namespace zonal
