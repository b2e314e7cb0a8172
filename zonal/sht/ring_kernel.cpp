// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/sht/kernels.h"

namespace zonal::ZONAL_ISA {
namespace {

constexpr int kLanes = ZONAL_LANES;
using Vec = double __attribute__((vector_size(kLanes * sizeof(double))));

struct Complex {
  Vec re, im;
};
struct Root {
  double re, im;
};

inline Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator*(Complex a, Root w) { return {a.re * w.re - a.im * w.im, a.re * w.im + a.im * w.re}; }
inline Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
inline Complex times_minus_i(Complex a) { return {a.im, -a.re}; }
inline Complex conjugate(Complex a) { return {a.re, -a.im}; }

template <int Radix>
inline void butterfly(Complex* a);

template <>
inline void butterfly<2>(Complex* a) {
  const Complex t = a[1];
  a[1] = a[0] - t;
  a[0] = a[0] + t;
}

template <>
inline void butterfly<3>(Complex* a) {
  constexpr double kSin = 0x1.bb67ae8584caap-1;  // sin 2π/3
  const Complex sum = a[1] + a[2], turn = kSin * times_minus_i(a[1] - a[2]);
  const Complex mid = a[0] - 0.5 * sum;
  a[0] = a[0] + sum;
  a[1] = mid + turn;
  a[2] = mid - turn;
}

template <>
inline void butterfly<4>(Complex* a) {
  const Complex t0 = a[0] + a[2], t1 = a[0] - a[2], t2 = a[1] + a[3], t3 = times_minus_i(a[1] - a[3]);
  a[0] = t0 + t2;
  a[1] = t1 + t3;
  a[2] = t0 - t2;
  a[3] = t1 - t3;
}

template <>
inline void butterfly<5>(Complex* a) {
  constexpr double kCos1 = 0x1.3c6ef372fe95p-2, kCos2 = -0x1.9e3779b97f4a8p-1;  // cos 2π/5, cos 4π/5
  constexpr double kSin1 = 0x1.e6f0e134454ffp-1, kSin2 = 0x1.2cf2304755a5ep-1;  // sin 2π/5, sin 4π/5
  const Complex p1 = a[1] + a[4], p2 = a[2] + a[3];
  const Complex m1 = times_minus_i(a[1] - a[4]), m2 = times_minus_i(a[2] - a[3]);
  const Complex c1 = a[0] + kCos1 * p1 + kCos2 * p2, c2 = a[0] + kCos2 * p1 + kCos1 * p2;
  const Complex s1 = kSin1 * m1 + kSin2 * m2, s2 = kSin2 * m1 - kSin1 * m2;
  a[0] = a[0] + p1 + p2;
  a[1] = c1 + s1;
  a[2] = c2 + s2;
  a[3] = c2 - s2;
  a[4] = c1 - s1;
}

template <>
inline void butterfly<8>(Complex* a) {
  constexpr double kHalfRoot = 0x1.6a09e667f3bcdp-1;  // cos π/4
  Complex even[4] = {a[0], a[2], a[4], a[6]}, odd[4] = {a[1], a[3], a[5], a[7]};
  butterfly<4>(even);
  butterfly<4>(odd);
  odd[1] = {kHalfRoot * (odd[1].re + odd[1].im), kHalfRoot * (odd[1].im - odd[1].re)};
  odd[2] = times_minus_i(odd[2]);
  odd[3] = {kHalfRoot * (odd[3].im - odd[3].re), -kHalfRoot * (odd[3].re + odd[3].im)};
  for (int k = 0; k < 4; ++k) {
    a[k] = even[k] + odd[k];
    a[k + 4] = even[k] - odd[k];
  }
}

template <int Radix>
void fixed_stage(const FftStage& stage, const Complex* __restrict in, Complex* __restrict out) {
  const int m = stage.groups, s = stage.stride;
  for (int p = 0; p < m; ++p) {
    Root w[Radix];
    for (int k = 1; k < Radix; ++k) {
      const double* t = stage.twiddles + 2 * (static_cast<long>(p) * (Radix - 1) + k - 1);
      w[k] = {t[0], t[1]};
    }
    for (int q = 0; q < s; ++q) {
      Complex a[Radix];
      for (int k = 0; k < Radix; ++k) a[k] = in[q + s * (p + m * k)];
      butterfly<Radix>(a);
      Complex* target = out + q + s * Radix * p;
      target[0] = a[0];
      for (int k = 1; k < Radix; ++k) target[s * k] = m == 1 ? a[k] : a[k] * w[k];
    }
  }
}

/// Any radix, by its definition: r² operations, for the odd factors that real image widths have now and then.
void generic_stage(const FftStage& stage, const Complex* __restrict in, Complex* __restrict out) {
  const int r = stage.radix, m = stage.groups, s = stage.stride;
  for (int p = 0; p < m; ++p) {
    for (int q = 0; q < s; ++q) {
      for (int k = 0; k < r; ++k) {
        Complex sum = in[q + s * p];
        for (int j = 1, turn = k; j < r; ++j, turn += k) {
          if (turn >= r) turn -= r;
          sum = sum + in[q + s * (p + m * j)] * Root{stage.roots[2 * turn], stage.roots[2 * turn + 1]};
        }
        const double* t = stage.twiddles + 2 * (static_cast<long>(p) * (r - 1) + k - 1);
        out[q + s * (r * p + k)] = k == 0 ? sum : sum * Root{t[0], t[1]};
      }
    }
  }
}

double* fft(const FftStage* stages, int stage_count, double* values, double* scratch) {
  Complex* in = reinterpret_cast<Complex*>(values);
  Complex* out = reinterpret_cast<Complex*>(scratch);
  for (int i = 0; i < stage_count; ++i) {
    switch (stages[i].radix) {
      case 2:
        fixed_stage<2>(stages[i], in, out);
        break;
      case 3:
        fixed_stage<3>(stages[i], in, out);
        break;
      case 4:
        fixed_stage<4>(stages[i], in, out);
        break;
      case 5:
        fixed_stage<5>(stages[i], in, out);
        break;
      case 8:
        fixed_stage<8>(stages[i], in, out);
        break;
      default:
        generic_stage(stages[i], in, out);
    }
    Complex* swapped = in;
    in = out;
    out = swapped;
  }
  return reinterpret_cast<double*>(in);
}

void multiply(double* values, const double* factors, int count, bool conjugated) {
  Complex* z = reinterpret_cast<Complex*>(values);
  for (int n = 0; n < count; ++n) {
    const Complex product = z[n] * Root{factors[2 * n], factors[2 * n + 1]};
    z[n] = conjugated ? conjugate(product) : product;
  }
}

// Tiles of columns: a tile of the target stays in the first-level cache while `lanes` row pairs are written into it.
constexpr int kTile = 32;

template <class T>
void load(const T* const* north, const T* const* south, int channel, int width, double* values) {
  for (int begin = 0; begin < width; begin += kTile) {
    const int end = begin + kTile < width ? begin + kTile : width;
    for (int lane = 0; lane < kLanes; ++lane) {
      for (int half = 0; half < 2; ++half) {
        const T* row = half == 0 ? north[lane] : south[lane];
        double* target = values + half * kLanes + lane;
        if (row == nullptr) {
          for (int x = begin; x < end; ++x) target[2L * kLanes * x] = 0;
        } else {
          for (int x = begin; x < end; ++x) target[2L * kLanes * x] = row[3L * x + channel];
        }
      }
    }
  }
}

template <class T>
void store(const double* values, int channel, int width, T* const* north, T* const* south) {
  for (int begin = 0; begin < width; begin += kTile) {
    const int end = begin + kTile < width ? begin + kTile : width;
    for (int lane = 0; lane < kLanes; ++lane) {
      for (int half = 0; half < 2; ++half) {
        T* row = half == 0 ? north[lane] : south[lane];
        if (row == nullptr) continue;
        const double* source = values + half * kLanes + lane;
        for (int x = begin; x < end; ++x) row[3L * x + channel] = static_cast<T>(source[2L * kLanes * x]);
      }
    }
  }
}

/// Entries of one m: [symmetric, antisymmetric][channel][cos, sin].
inline Vec* amplitudes(double* spectrum, int parity, int channel) {
  return reinterpret_cast<Vec*>(spectrum) + 6 * parity + 2 * channel;
}

void unpack(const double* values, int width, int channel, int bands, const double* phases, const double* weights,
            double* spectrum, long spectrum_stride) {
  const Complex* z = reinterpret_cast<const Complex*>(values);
  const Vec half_weight = *reinterpret_cast<const Vec*>(weights) * 0.5;
  for (int m = 0; m < bands; ++m, spectrum += spectrum_stride) {
    const int k = m % width, mirror = k == 0 ? 0 : width - k;
    // Real rows packed as north + i south: north_k = (z_k + conj z_-k) / 2, south_k = (z_k - conj z_-k) / 2i.
    const Complex a = z[k], b = conjugate(z[mirror]);
    const Complex north = a + b, south = times_minus_i(a - b);
    // Σ f exp(-imφ) with φ falling to the right is the conjugate of the transform, turned by the phase of texel 0.
    const Root phase = {phases[2 * m], phases[2 * m + 1]};
    const Complex sum = conjugate(north + south) * phase, difference = conjugate(north - south) * phase;
    Vec* symmetric = amplitudes(spectrum, 0, channel);
    Vec* antisymmetric = amplitudes(spectrum, 1, channel);
    symmetric[0] = half_weight * sum.re;
    symmetric[1] = -(half_weight * sum.im);
    antisymmetric[0] = half_weight * difference.re;
    antisymmetric[1] = -(half_weight * difference.im);
  }
}

void pack(const double* spectrum, long spectrum_stride, int channel, int bands, const double* phases, int width,
          double* values) {
  Complex* z = reinterpret_cast<Complex*>(values);
  for (int n = 0; n < width; ++n) z[n] = Complex{};
  for (int m = 0; m < bands; ++m, spectrum += spectrum_stride) {
    const Vec* symmetric = amplitudes(const_cast<double*>(spectrum), 0, channel);
    const Vec* antisymmetric = amplitudes(const_cast<double*>(spectrum), 1, channel);
    const Root back = {phases[2 * m], -phases[2 * m + 1]};
    const Complex even = Complex{0.5 * symmetric[0], -0.5 * symmetric[1]} * back;
    const Complex odd = Complex{0.5 * antisymmetric[0], -0.5 * antisymmetric[1]} * back;
    const Complex north = even + odd, south = even - odd;
    const int k = m % width, mirror = k == 0 ? 0 : width - k;
    z[k] = z[k] + Complex{north.re - south.im, north.im + south.re};
    z[mirror] = z[mirror] + Complex{north.re + south.im, south.re - north.im};
  }
}

}  // namespace

const RingKernels kRingKernels = {kLanes,       fft,           multiply, load<float>, load<double>,
                                  store<float>, store<double>, unpack,   pack};

}  // namespace zonal::ZONAL_ISA
