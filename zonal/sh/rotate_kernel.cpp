// Compiled once per instruction set: nothing here but the loops (see cmake/zonal.cmake).
#include "zonal/sh/rotate_kernel.h"

#include <type_traits>
#include <utility>

#include "zonal/sh/turns.h"

// One function is too little for SIMD lanes of functions, but its bands 2 to 5 turn about Z by the same angles: they
// are the four lanes. Band 1 is a vector and turns as vectors do.
namespace zonal::ZONAL_ISA {
namespace {

using FloatLanes = float __attribute__((vector_size(4 * sizeof(float))));
using DoubleLanes = double __attribute__((vector_size(4 * sizeof(double))));
template <class T>
using Lanes = std::conditional_t<std::is_same_v<T, float>, FloatLanes, DoubleLanes>;

constexpr int kFirstBand = 2, kLastBand = 5;

/// The swap of y and z makes each function of four kinds, cosines and sines of even and odd m, from those of one kind:
/// its parity in x stays, those in y and z change places.
enum Kind { kEvenCosine, kOddCosine, kOddSine, kEvenSine };
constexpr Kind kSource[2][4] = {{kEvenCosine, kEvenSine, kOddSine, kOddCosine},   // in even bands
                                {kOddSine, kOddCosine, kEvenCosine, kEvenSine}};  // in odd bands

/// The three of a kind: 0, 2, 4 or 1, 3, 5. (There is no sine of 0; its place holds zeros.)
constexpr int order_of(int kind, int i) { return 2 * i + (kind == kOddCosine || kind == kOddSine); }

/// Where the function of this kind is in band l; -1 where there is none.
constexpr int place_of(int l, int kind, int i) {
  const int m = order_of(kind, i);
  if (m > l || (kind == kEvenSine && m == 0)) return -1;
  return coefficient_index(l, kind == kOddSine || kind == kEvenSine ? -m : m);
}

/// How much of source j in band l goes into number i of a kind.
constexpr double swap_share(int l, int kind, int i, int j) {
  const int to = place_of(l, kind, i), from = place_of(l, kSource[l % 2][kind], j), middle = coefficient_index(l, 0);
  return to < 0 || from < 0 ? 0 : turns::swap_entry(l, to - middle, from - middle);
}

/// Cosines and sines of the multiples of an angle, in every lane.
template <class T>
struct Multiples {
  Lanes<T> cosines[kLastBand + 1], sines[kLastBand + 1];

  [[gnu::always_inline]] Multiples(T cosine, T sine) {
    cosines[1] = Lanes<T>{} + cosine, sines[1] = Lanes<T>{} + sine;
#pragma GCC unroll 4
    for (int m = 2; m <= kLastBand; ++m) {  // by halves: no more than three steps from the first
      const int p = m / 2, q = m - p;
      cosines[m] = cosines[p] * cosines[q] - sines[p] * sines[q];
      sines[m] = sines[p] * cosines[q] + cosines[p] * sines[q];
    }
  }
};

/// Bands 2 to 5 of a function of N bands.
template <class T, int N>
struct Bands {
  Lanes<T> of[4][3];  ///< [kind][i]; zero where a band has no such function

  /// swap_share in each band.
  template <int kind, int i, int j>
  static constexpr Lanes<T> kShare = {
      static_cast<T>(swap_share(2, kind, i, j)), static_cast<T>(swap_share(3, kind, i, j)),
      static_cast<T>(swap_share(4, kind, i, j)), static_cast<T>(swap_share(5, kind, i, j))};

  template <int kind, int i>
  [[gnu::always_inline]] void load(const T* sh) {
    const auto value = [&]<int l>() { return l < N && place_of(l, kind, i) >= 0 ? sh[place_of(l, kind, i)] : T{}; };
    of[kind][i] = Lanes<T>{value.template operator()<2>(), value.template operator()<3>(),
                           value.template operator()<4>(), value.template operator()<5>()};
  }
  template <int kind, int i>
  [[gnu::always_inline]] void store(T* sh) const {
#pragma GCC unroll 4
    for (int l = kFirstBand; l < N; ++l) {
      if (place_of(l, kind, i) >= 0) sh[place_of(l, kind, i)] = of[kind][i][l - kFirstBand];
    }
  }

  [[gnu::always_inline]] void turn_about_z(const Multiples<T>& angle) {
#pragma GCC unroll 5
    for (int m = 1; m < N; ++m) {
      Lanes<T>& even = of[m % 2 ? kOddCosine : kEvenCosine][m / 2];
      Lanes<T>& odd = of[m % 2 ? kOddSine : kEvenSine][m / 2];
      const Lanes<T> before = even;
      even = angle.cosines[m] * before - angle.sines[m] * odd;
      odd = angle.sines[m] * before + angle.cosines[m] * odd;
    }
  }

  /// Turns the sines over.
  [[gnu::always_inline]] void mirror_y() {
    for (int i = 0; i < 3; ++i) {
      of[kOddSine][i] = -of[kOddSine][i];
      of[kEvenSine][i] = -of[kEvenSine][i];
    }
  }

  template <int kind>
  [[gnu::always_inline]] void swap_kind(const Bands& old) {
    using Mask = decltype(Lanes<T>{} < Lanes<T>{});
    constexpr Mask kOddBand = {0, -1, 0, -1};
    constexpr Kind even = kSource[0][kind], odd = kSource[1][kind];
    const Lanes<T> a = kOddBand ? old.of[odd][0] : old.of[even][0];
    const Lanes<T> b = kOddBand ? old.of[odd][1] : old.of[even][1];
    const Lanes<T> c = kOddBand ? old.of[odd][2] : old.of[even][2];
    of[kind][0] = kShare<kind, 0, 0> * a + kShare<kind, 0, 1> * b + kShare<kind, 0, 2> * c;
    of[kind][1] = kShare<kind, 1, 0> * a + kShare<kind, 1, 1> * b + kShare<kind, 1, 2> * c;
    of[kind][2] = kShare<kind, 2, 0> * a + kShare<kind, 2, 1> * b + kShare<kind, 2, 2> * c;
  }
  [[gnu::always_inline]] void swap_yz() {
    const Bands old = *this;
    swap_kind<kEvenCosine>(old);
    swap_kind<kOddCosine>(old);
    swap_kind<kOddSine>(old);
    swap_kind<kEvenSine>(old);
  }
};

template <class Work>
[[gnu::always_inline]] inline void for_each_place(Work&& work) {
  [&]<int... n>(std::integer_sequence<int, n...>) { (work.template operator()<n / 3, n % 3>(), ...); }
  (std::make_integer_sequence<int, 12>());
}

inline float square_root(float value) { return __builtin_sqrtf(value); }
inline double square_root(double value) { return __builtin_sqrt(value); }

/// The angles of a rotation, and whether there is a mirror of y before it.
template <class T>
struct Decomposed {
  turns::Angles<T> angles;
  T r[3][3];
  bool mirrored;

  [[gnu::always_inline]] explicit Decomposed(const double* entries) {
#pragma GCC unroll 9
    for (int i = 0; i < 9; ++i) r[i / 3][i % 3] = static_cast<T>(entries[i]);
    const T determinant = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) +
                          r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2]) +
                          r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
    mirrored = determinant < 0;
    const T handedness = mirrored ? T(-1) : T(1);
    const T square = r[2][0] * r[2][0] + r[2][1] * r[2][1];
    angles.cos_b = r[2][2];
    angles.sin_b = square_root(square);
    // So close to the pole c is anybody's guess; a is taken from R Z(-c), so that the guess does not matter.
    const bool off_pole = square > T(sizeof(T) == sizeof(float) ? 1e-30 : 1e-200);
    const T inverse = 1 / (off_pole ? angles.sin_b : T(1));
    angles.cos_c = off_pole ? -r[2][0] * inverse : T(1);
    angles.sin_c = off_pole ? r[2][1] * handedness * inverse : T(0);
    angles.cos_a = r[1][0] * angles.sin_c + handedness * r[1][1] * angles.cos_c;
    angles.sin_a = -(r[0][0] * angles.sin_c + handedness * r[0][1] * angles.cos_c);
  }
};

template <int N, class T>
[[gnu::always_inline]] inline void rotate_by_lanes(const Decomposed<T>& rotation, const T* from, T* to, long count) {
  const auto& [cos_a, sin_a, cos_b, sin_b, cos_c, sin_c] = rotation.angles;
  const Multiples<T> c(cos_c, sin_c), minus_b(cos_b, -sin_b), a(cos_a, sin_a);
  for (; count > 0; --count, from += N * N, to += N * N) {
    to[0] = from[0];
    const T x = from[3], y = from[1], z = from[2];
    to[3] = rotation.r[0][0] * x + rotation.r[0][1] * y + rotation.r[0][2] * z;
    to[1] = rotation.r[1][0] * x + rotation.r[1][1] * y + rotation.r[1][2] * z;
    to[2] = rotation.r[2][0] * x + rotation.r[2][1] * y + rotation.r[2][2] * z;

    Bands<T, N> bands;
    for_each_place([&]<int kind, int i>() { bands.template load<kind, i>(from); });
    if (rotation.mirrored) bands.mirror_y();
    bands.turn_about_z(c);
    bands.swap_yz();
    bands.turn_about_z(minus_b);
    bands.swap_yz();
    bands.turn_about_z(a);
    for_each_place([&]<int kind, int i>() { bands.template store<kind, i>(to); });
  }
}

template <int N, class T>
[[gnu::always_inline]] inline void rotate_one_by_one(const Decomposed<T>& rotation, const T* from, T* to, long count) {
  for (; count > 0; --count, from += N * N, to += N * N) {
    T sh[N * N];
    for (int l = 0; l < N; ++l) {
      for (int m = -l; m <= l; ++m) {
        const T value = from[coefficient_index(l, m)];
        sh[coefficient_index(l, m)] = rotation.mirrored && m < 0 ? -value : value;
      }
    }
    turns::turn<N, T>(sh, rotation.angles);
    for (int i = 0; i < N * N; ++i) to[i] = sh[i];
  }
}

template <int N, class T>
void rotate(const double* entries, const T* from, T* to, long count) {
  const Decomposed<T> rotation(entries);
  if constexpr (ZONAL_LANES < 4 && sizeof(T) == sizeof(double)) {  // there are no four lanes
    rotate_one_by_one<N>(rotation, from, to, count);
  } else {
    rotate_by_lanes<N>(rotation, from, to, count);
  }
}

}  // namespace

const RotateKernels kRotateKernels = {
    {rotate<4, float>, rotate<5, float>, rotate<6, float>},
    {rotate<4, double>, rotate<5, double>, rotate<6, double>},
};

}  // namespace zonal::ZONAL_ISA
