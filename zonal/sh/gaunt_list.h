#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "zonal/sh/gaunt.h"
#include "zonal/sh/gauss_rings.h"
#include "zonal/sh/sh.h"

namespace zonal {
namespace gaunt_detail {

constexpr int magnitude(int m) { return m < 0 ? -m : m; }

/// The integral over phi of three factors cos(m phi), or sin(-m phi) for negative m; 0 unless the sines pair up and the
/// largest |m| is the sum of the others.
constexpr double phi_integral(int m1, int m2, int m3) {
  const int largest = std::max({magnitude(m1), magnitude(m2), magnitude(m3)});
  const int sum = magnitude(m1) + magnitude(m2) + magnitude(m3);
  const int sines = (m1 < 0) + (m2 < 0) + (m3 < 0);
  if (sum != 2 * largest || sines % 2 != 0) return 0;
  if (largest == 0) return 2 * std::numbers::pi;
  if (m1 == 0 || m2 == 0 || m3 == 0) return std::numbers::pi;
  // cos a cos b holds +cos(a+b)/2, sin a sin b holds -cos(a+b)/2, sin a cos b holds sin(a+b)/2.
  const bool sum_is_cosine = m1 == largest || m2 == largest || m3 == largest;
  return sines == 2 && sum_is_cosine ? -std::numbers::pi / 2 : std::numbers::pi / 2;
}

struct Lm {
  int l = 0, m = 0;
};

/// a, b, c in order of their bands.
template <int Bands>
constexpr double gaunt(Lm a, Lm b, Lm c) {
  if ((a.l + b.l + c.l) % 2 != 0 || c.l > a.l + b.l) return 0;  // parity, triangle
  const double phi = phi_integral(a.m, b.m, c.m);
  if (phi == 0) return 0;
  constexpr const GaussRings<Bands>& rings = kGaussRings<Bands>;
  double sum = 0;
  for (std::size_t ring = 0; ring < rings.kRings; ++ring) {
    const auto q = [&](Lm i) {
      return rings.q[ring][static_cast<std::size_t>(i.l)][static_cast<std::size_t>(magnitude(i.m))];
    };
    sum += rings.weight[ring] * q(a) * q(b) * q(c);
  }
  return phi * sum;
}

template <int Bands>
struct Candidates {
  static constexpr std::size_t kCount = coefficient_count(Bands);
  std::array<GauntIntegral, kCount*(kCount + 1) * (kCount + 2) / 6> entries = {};
  std::size_t count = 0;

  constexpr Candidates() {
    std::array<Lm, kCount> lm;
    for (int l = 0; l < Bands; ++l) {
      for (int m = -l; m <= l; ++m) lm[static_cast<std::size_t>(coefficient_index(l, m))] = {l, m};
    }
    for (std::uint8_t k = 0; k < kCount; ++k) {
      for (std::uint8_t j = 0; j <= k; ++j) {
        for (std::uint8_t i = 0; i <= j; ++i) {
          const double value = gaunt<Bands>(lm[i], lm[j], lm[k]);
          // The smallest integral is 0.0096, rounding leaves 1e-15 of a zero: ten pairs pass the rules and vanish.
          if (value > 1e-9 || value < -1e-9) entries[count++] = {i, j, k, value};
        }
      }
    }
  }
};

}  // namespace gaunt_detail

/// The integrals of gaunt_integrals(Bands) for code that the compiler unrolls.
template <int Bands>
inline constexpr auto kGauntList = [] {
  constexpr gaunt_detail::Candidates<Bands> all;
  std::array<GauntIntegral, all.count> list = {};
  for (std::size_t i = 0; i < all.count; ++i) list[i] = all.entries[i];
  return list;
}();

}  // namespace zonal
