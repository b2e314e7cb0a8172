// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/sht/kernels.h"

namespace zonal::ZONAL_ISA {
namespace {

constexpr int kLanes = ZONAL_LANES;
using Vec = double __attribute__((vector_size(kLanes * sizeof(double))));
using Mask = decltype(Vec{} < Vec{});

constexpr int kAmplitudes = 6;  // three channels, cosine and sine

// Near the poles sin^m θ underflows long before the function grows to its size. Values are kept as q 2^(-400 k); while
// k > 0 they are below 2^-60 of anything that matters and are not summed (the idea of libsharp, Reinecke & Seljebotn
// 2013).
constexpr double kShrink = 0x1p-400, kGrow = 0x1p400, kSmall = 0x1p-60, kLarge = 0x1p340;

inline Vec absolute(Vec v) { return v < 0 ? -v : v; }
inline bool any(Mask mask) {
  long bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= mask[i];
  return bits != 0;
}

/// The recurrence on N vectors of rings: q is q_l, before is q_{l-1}.
template <int N>
struct Walk {
  Vec x[N], q[N], before[N], k[N];
  int l;

  Walk(const LegendreColumn& column, const double* cosines, const double* sines) : l(column.m) {
    for (int v = 0; v < N; ++v) {
      x[v] = reinterpret_cast<const Vec*>(cosines)[v];
      seed(v, column, reinterpret_cast<const Vec*>(sines)[v]);
    }
  }

  /// q_m = seed sin^m θ by repeated squaring, scaled.
  void seed(int v, const LegendreColumn& column, Vec base) {
    Vec power = Vec{} + 1, power_k = Vec{}, base_k = Vec{};
    for (int e = column.m; e > 0; e >>= 1) {
      if (e & 1) {
        power *= base;
        power_k += base_k;
        rescale_up(power, power_k, kShrink);
      }
      base *= base;
      base_k += base_k;
      rescale_up(base, base_k, kShrink);
    }
    power *= column.seed;
    rescale_up(power, power_k, kSmall);
    q[v] = power;
    k[v] = power_k;
    before[v] = Vec{};
  }

  static void rescale_up(Vec& value, Vec& count, double below) {
    const Mask tiny = value < below;
    value = tiny ? value * kGrow : value;
    count = tiny ? count + 1 : count;
  }

  void advance(double step) {
    for (int v = 0; v < N; ++v) {
      const Vec next = (step * x[v]) * q[v] - before[v];
      before[v] = q[v];
      q[v] = next;
    }
    ++l;
  }

  void advance_scaled(double step) {
    advance(step);
    for (int v = 0; v < N; ++v) {
      const Mask large = absolute(q[v]) > kLarge;
      q[v] = large ? q[v] * kShrink : q[v];
      before[v] = large ? before[v] * kShrink : before[v];
      k[v] = large ? k[v] - 1 : k[v];
    }
  }

  bool all_full_size() const {
    bool small = false;
    for (int v = 0; v < N; ++v) small |= any(k[v] > 0);
    return !small;
  }
  bool any_full_size() const {
    bool full = false;
    for (int v = 0; v < N; ++v) full |= any(k[v] <= 0);
    return full;
  }
  /// q_l where it counts, else 0.
  Vec value(int v) const { return k[v] <= 0 ? q[v] : Vec{}; }
};

/// Where P_lm stays below 2^-60 for every l < bands: m beyond the turning point l sin θ by a margin (as in libsharp).
inline bool negligible(const LegendreColumn& column, const double* sines, int count) {
  double widest = 0;
  for (int i = 0; i < count; ++i) widest = sines[i] > widest ? sines[i] : widest;
  const double margin = 0.01 * column.bands > 100 ? 0.01 * column.bands : 100;
  return column.m > column.bands * widest + margin;
}

template <int N>
void analyze_blocks(const LegendreColumn& column, const double* cosines, const double* sines, const double* spectrum,
                    double* sums) {
  if (negligible(column, sines, N * kLanes)) return;
  const Vec* rings = reinterpret_cast<const Vec*>(spectrum);  // [N][2][6]
  Vec* out = reinterpret_cast<Vec*>(sums);                    // [l - m][6]
  Walk<N> walk(column, cosines, sines);
  const int last = column.bands - 1;

  const auto accumulate = [&](const Vec(&value)[N]) {
    const int parity = (walk.l - column.m) & 1;
    Vec* target = out + static_cast<long>(walk.l - column.m) * kAmplitudes;
    for (int a = 0; a < kAmplitudes; ++a) {
      Vec sum = target[a];
      for (int v = 0; v < N; ++v) sum += value[v] * rings[(2 * v + parity) * kAmplitudes + a];
      target[a] = sum;
    }
  };

  for (; !walk.all_full_size(); walk.advance_scaled(column.step[walk.l + 1 - column.m])) {
    if (walk.any_full_size()) {
      Vec value[N];
      for (int v = 0; v < N; ++v) value[v] = walk.value(v);
      accumulate(value);
    }
    if (walk.l == last) return;
  }
  for (;; walk.advance(column.step[walk.l + 1 - column.m])) {
    accumulate(walk.q);
    if (walk.l == last) return;
  }
}

template <int N>
void synthesize_blocks(const LegendreColumn& column, const double* cosines, const double* sines,
                       const double* coefficients, double* spectrum) {
  Vec* rings = reinterpret_cast<Vec*>(spectrum);  // [N][2][6]
  for (int i = 0; i < N * 2 * kAmplitudes; ++i) rings[i] = Vec{};
  if (negligible(column, sines, N * kLanes)) return;
  Walk<N> walk(column, cosines, sines);
  const int last = column.bands - 1;

  // Until every ring counts, and until l - m is even: sums in memory.
  while (!walk.all_full_size() || ((walk.l - column.m) & 1) != 0) {
    if (walk.any_full_size()) {
      const int parity = (walk.l - column.m) & 1;
      const double* c = coefficients + static_cast<long>(walk.l - column.m) * kAmplitudes;
      for (int v = 0; v < N; ++v) {
        const Vec value = walk.value(v);
        for (int a = 0; a < kAmplitudes; ++a) rings[(2 * v + parity) * kAmplitudes + a] += value * c[a];
      }
    }
    if (walk.l == last) return;
    walk.advance_scaled(column.step[walk.l + 1 - column.m]);
  }

  // From here on in registers, two bands at a time.
  Vec even[N][kAmplitudes], odd[N][kAmplitudes];
  for (int v = 0; v < N; ++v) {
    for (int a = 0; a < kAmplitudes; ++a) {
      even[v][a] = rings[2 * v * kAmplitudes + a];
      odd[v][a] = rings[(2 * v + 1) * kAmplitudes + a];
    }
  }
  const double* c = coefficients + static_cast<long>(walk.l - column.m) * kAmplitudes;
  const double* step = column.step + (walk.l - column.m);
  const int remaining = last - walk.l + 1;
  for (int pair = 0; pair < remaining / 2; ++pair, c += 2 * kAmplitudes, step += 2) {
    for (int v = 0; v < N; ++v) {
      for (int a = 0; a < kAmplitudes; ++a) even[v][a] += walk.q[v] * c[a];
    }
    walk.advance(step[1]);
    for (int v = 0; v < N; ++v) {
      for (int a = 0; a < kAmplitudes; ++a) odd[v][a] += walk.q[v] * c[kAmplitudes + a];
    }
    walk.advance(step[2]);
  }
  for (int v = 0; v < N; ++v) {
    for (int a = 0; a < kAmplitudes; ++a) {
      if (remaining & 1) even[v][a] += walk.q[v] * c[a];
      rings[2 * v * kAmplitudes + a] = even[v][a];
      rings[(2 * v + 1) * kAmplitudes + a] = odd[v][a];
    }
  }
}

// How many vectors of rings go side by side: what the registers hold (32 with AVX-512, 16 otherwise).
constexpr int kAnalyzeWidth = kLanes == 8 ? 4 : 2;
constexpr int kSynthesizeWidth = kLanes == 8 ? 2 : 1;

void analyze(const LegendreColumn& column, int blocks, const double* x, const double* sine, const double* spectrum,
             double* sums) {
  int b = 0;
  const auto at = [&](const double* array, int entries) { return array + static_cast<long>(b) * entries * kLanes; };
  for (; b + kAnalyzeWidth <= blocks; b += kAnalyzeWidth) {
    analyze_blocks<kAnalyzeWidth>(column, at(x, 1), at(sine, 1), at(spectrum, 12), sums);
  }
  for (; b < blocks; ++b) analyze_blocks<1>(column, at(x, 1), at(sine, 1), at(spectrum, 12), sums);
}

void synthesize(const LegendreColumn& column, int blocks, const double* x, const double* sine,
                const double* coefficients, double* spectrum) {
  int b = 0;
  const auto at = [&](const double* array, int entries) { return array + static_cast<long>(b) * entries * kLanes; };
  for (; b + kSynthesizeWidth <= blocks; b += kSynthesizeWidth) {
    synthesize_blocks<kSynthesizeWidth>(column, at(x, 1), at(sine, 1), coefficients,
                                        spectrum + static_cast<long>(b) * 12 * kLanes);
  }
  for (; b < blocks; ++b) {
    synthesize_blocks<1>(column, at(x, 1), at(sine, 1), coefficients, spectrum + static_cast<long>(b) * 12 * kLanes);
  }
}

}  // namespace

const LegendreKernels kLegendreKernels = {kLanes, analyze, synthesize};

}  // namespace zonal::ZONAL_ISA
