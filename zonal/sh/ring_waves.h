#pragma once

// For kernels alone, each of which is compiled once per instruction set: internal to the file that includes it. See
// ring_tables.h for the idea.
namespace zonal::ZONAL_ISA {
namespace {

/// Half the amplitudes of cos m phi and sin m phi on a ring, m < N; whole ones for m = 0, which has no sine. V is a
/// SIMD vector: its lanes are functions, or rings.
template <int N, class V>
struct Waves {
  V cosine[N], sine[N];
};

/// The waves of order m on a ring and its mirror image; `sign` is 1 for those of cosines, -1 for those of sines. Either
/// the coefficients or the table's entries are vectors, or both.
template <int N, int m, int sign, class V, class Coefficient, class Entry>
[[gnu::always_inline]] inline void synthesize_order(const Coefficient* sh, const Entry (&table)[N][N], V& north,
                                                    V& south) {
  V even = table[m][m] * sh[m * (m + 1) + sign * m], odd = {};
#pragma GCC unroll 6
  for (int l = m + 1; l < N; ++l) {
    const V part = table[l][m] * sh[l * (l + 1) + sign * m];
    if ((l - m) % 2 == 0) {
      even += part;
    } else {
      odd += part;
    }
  }
  north = even + odd;
  south = even - odd;
}

template <int N, int m = 0, class V, class Coefficient, class Entry>
[[gnu::always_inline]] inline void synthesize(const Coefficient* sh, const Entry (&table)[N][N], Waves<N, V>& north,
                                              Waves<N, V>& south) {
  if constexpr (m < N) {
    synthesize_order<N, m, 1>(sh, table, north.cosine[m], south.cosine[m]);
    if constexpr (m > 0) synthesize_order<N, m, -1>(sh, table, north.sine[m], south.sine[m]);
    synthesize<N, m + 1>(sh, table, north, south);
  }
}

/// The adjoint: adds to the coefficients.
template <int N, int m, int sign, class V, class Entry>
[[gnu::always_inline]] inline void analyze_order(V north, V south, const Entry (&table)[N][N], V* sh) {
  const V even = north + south, odd = north - south;
#pragma GCC unroll 6
  for (int l = m; l < N; ++l) sh[l * (l + 1) + sign * m] += table[l][m] * ((l - m) % 2 == 0 ? even : odd);
}

template <int N, int m = 0, class V, class Entry>
[[gnu::always_inline]] inline void analyze(const Waves<N, V>& north, const Waves<N, V>& south,
                                           const Entry (&table)[N][N], V* sh) {
  if constexpr (m < N) {
    analyze_order<N, m, 1>(north.cosine[m], south.cosine[m], table, sh);
    if constexpr (m > 0) analyze_order<N, m, -1>(north.sine[m], south.sine[m], table, sh);
    analyze<N, m + 1>(north, south, table, sh);
  }
}

/// The waves m < N of f g: e^{ia} e^{ib} = e^{i(a+b)}, and a wave of -m is the conjugate of m.
template <int N, class V>
[[gnu::always_inline]] inline void multiply_waves(const Waves<N, V>& f, const Waves<N, V>& g, Waves<N, V>& product) {
  V half = {};
#pragma GCC unroll 6
  for (int m = 1; m < N; ++m) half += f.cosine[m] * g.cosine[m] + f.sine[m] * g.sine[m];
  product.cosine[0] = f.cosine[0] * g.cosine[0] + (half + half);
#pragma GCC unroll 6
  for (int m = 1; m < N; ++m) {
    V cosine = f.cosine[0] * g.cosine[m] + f.cosine[m] * g.cosine[0];
    V sine = f.cosine[0] * g.sine[m] + f.sine[m] * g.cosine[0];
#pragma GCC unroll 6
    for (int a = 1; a < m; ++a) {
      const int b = m - a;
      cosine += f.cosine[a] * g.cosine[b] - f.sine[a] * g.sine[b];
      sine += f.sine[a] * g.cosine[b] + f.cosine[a] * g.sine[b];
    }
#pragma GCC unroll 6
    for (int a = m + 1; a < N; ++a) {
      const int b = a - m;
      cosine += f.cosine[a] * g.cosine[b] + f.sine[a] * g.sine[b];
      cosine += g.cosine[a] * f.cosine[b] + g.sine[a] * f.sine[b];
      sine += f.sine[a] * g.cosine[b] - f.cosine[a] * g.sine[b];
      sine += g.sine[a] * f.cosine[b] - g.cosine[a] * f.sine[b];
    }
    product.cosine[m] = cosine;
    product.sine[m] = sine;
  }
}

}  // namespace
}  // namespace zonal::ZONAL_ISA
