#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <type_traits>

#include "zonal/sh/basis_constants.h"
#include "zonal/sh/sh.h"

// How the rotation matrix of band l grows out of that of band l-1, for rotate.cpp at run time and for the compiler. A
// coordinate times y_{l-1,a} has a part in band l: it is a handful of y_{l,m} with the weights of terms_of. Read the
// other way, y_{l,m} is a sum of products of a coordinate and a y_{l-1,a}; turned, the coordinates mix by the matrix R
// of band 1 and the y_{l-1} by the matrix B of band l-1:
//   M(m, n) = sum over terms of m and of n: weight_m weight_n R(c_m, c_n) B(a_m, a_n) / (l (2l-1)).
// The weights are those of Ivanic & Ruedenberg 1996. Their sum runs over the terms of m alone and divides by what one
// single term of n keeps, which lifts the rounding from band to band: 1e-11 at 64 bands. The sum over both is a
// projection (the terms of all m are orthogonal), so nothing is lifted.
namespace zonal {

/// Entries of the matrices of bands 0..bands-1, of 1, 9, 25 ... entries.
constexpr int rotation_entries(int bands) { return bands * (4 * bands * bands - 1) / 3; }

namespace rotation_detail {

constexpr double root(double square) {
  return std::is_constant_evaluated() ? constexpr_sqrt(square) : std::sqrt(square);
}

struct Term {
  int coordinate = 0;  ///< 0 z, 1 x, -1 y: its m in band 1
  int a = 0;
  double weight = 0;
};

struct Terms {
  std::array<Term, 5> terms = {};
  int count = 0;
  constexpr void add(int coordinate, int a, double weight, int l) {
    if (-l < a && a < l) terms[static_cast<std::size_t>(count++)] = {coordinate, a, weight};
  }
  constexpr const Term* begin() const { return terms.data(); }
  constexpr const Term* end() const { return terms.data() + count; }
};

/// Ivanic & Ruedenberg 1996, tables 1 and 2, as corrected in 1998.
constexpr Terms terms_of(int l, int m) {
  const int p = m < 0 ? -m : m;
  Terms t;
  t.add(0, m, root(1.0 * (l + m) * (l - m)), l);
  if (m == 0) {
    const double v = -root(2.0 * (l - 1) * l) / 2;
    t.add(1, 1, v, l);
    t.add(-1, -1, v, l);
    return t;
  }
  // cos m phi for m > 0 comes from cos cos and sin sin, sin from sin cos and cos sin; m = 0 has no sine.
  const int sign = m > 0 ? 1 : -1;
  const double v = root(1.0 * (l + p - 1) * (l + p)) / 2, w = -root(1.0 * (l - p - 1) * (l - p)) / 2;
  const double lower = p == 1 ? std::numbers::sqrt2 * v : v;
  if (m > 0 || p > 1) t.add(1, sign * (p - 1), lower, l);
  if (m < 0 || p > 1) t.add(-1, -sign * (p - 1), -sign * lower, l);
  t.add(1, sign * (p + 1), w, l);
  t.add(-1, -sign * (p + 1), sign * w, l);
  return t;
}

/// Room for one band: the terms of each m, and a row for each coordinate.
struct Room {
  std::span<Terms> terms;
  std::span<double> rows;
};

constexpr void next_block(int l, const double* first, const double* before, double* block, const Room& room) {
  const int size = 2 * l + 1, inner = 2 * l - 1;
  for (int m = -l; m <= l; ++m) room.terms[static_cast<std::size_t>(l + m)] = terms_of(l, m);
  // rows(c)[a], c = -1..1, a = 1-l..l-1: the sum over the terms of m
  const auto rows = [&](int c) { return room.rows.data() + (1 + c) * inner + (l - 1); };
  const double scale = 1.0 / (l * inner);
  for (int m = 0; m < size; ++m) {
    for (int i = 0; i < 3 * inner; ++i) room.rows[static_cast<std::size_t>(i)] = 0;
    for (const Term& term : room.terms[static_cast<std::size_t>(m)]) {
      const double* from = before + (l - 1 + term.a) * inner + (l - 1);
      for (int c = -1; c <= 1; ++c) {
        const double weight = scale * term.weight * first[3 * (1 + term.coordinate) + 1 + c];
        for (int a = 1 - l; a < l; ++a) rows(c)[a] += weight * from[a];
      }
    }
    for (int n = 0; n < size; ++n) {
      double sum = 0;
      for (const Term& term : room.terms[static_cast<std::size_t>(n)])
        sum += term.weight * rows(term.coordinate)[term.a];
      block[m * size + n] = sum;
    }
  }
}

/// From the matrices of bands 0 and 1 to those of all bands.
constexpr void grow(std::span<double> blocks, int bands, const Room& room) {
  const auto block = [&](int l) { return blocks.data() + rotation_entries(l); };
  for (int l = 2; l < bands; ++l) next_block(l, block(1), block(l - 1), block(l), room);
}

/// The same without heap, for at most kMaxStaticBands.
constexpr void grow_few(std::span<double> blocks, int bands) {
  constexpr std::size_t kWidest = 2 * kMaxStaticBands - 1;
  std::array<Terms, kWidest> terms;
  std::array<double, 3 * kWidest> rows = {};
  grow(blocks, bands, {terms, rows});
}

}  // namespace rotation_detail
}  // namespace zonal
