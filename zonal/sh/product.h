#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/sh/gaunt.h"
#include "zonal/sh/sh.h"

namespace zonal {

// The product of two functions of a and b bands has a+b-1 bands. What is asked for beyond those is zero; with fewer,
// the result is the exact product, projected on them. Colours multiply by channel; a number and a colour give a colour.

template <class T>
inline constexpr bool kIsColor = false;
template <class T>
inline constexpr bool kIsColor<Color3<T>> = true;

template <class A, class B>
constexpr auto multiply_values(const A& a, const B& b) {
  if constexpr (kIsColor<A> && !kIsColor<B>) {
    return b * a;
  } else {
    return a * b;
  }
}

/// The coefficient of a product: a colour when one of them is, in the wider of their precisions.
template <class A, class B>
using ProductOf = std::conditional_t<kIsColor<A> || kIsColor<B>, Color3<std::common_type_t<ScalarOf<A>, ScalarOf<B>>>,
                                     std::common_type_t<ScalarOf<A>, ScalarOf<B>>>;

/// Coefficients of f g by exact quadrature on rings, for any number of bands; O(bands^3). `f` and `g` hold the squares
/// of their bands.
std::vector<double> multiply_on_sphere(std::span<const double> f, std::span<const double> g, int result_bands);

/// One channel of the coefficients; a number is its own every channel.
template <class T, int N>
std::vector<double> channel_of(const Sh<T, N>& sh, int channel) {
  std::vector<double> values(sh.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if constexpr (kIsColor<T>) {
      values[i] = channel == 0 ? sh[i].r : channel == 1 ? sh[i].g : sh[i].b;
    } else {
      values[i] = sh[i];
    }
  }
  return values;
}

/// The product of functions of at most 6 bands by the list of Gaunt integrals, summed in double. No heap.
template <int K, class T, int N, class U, int M>
Sh<ProductOf<T, U>, K> product_by_list(const Sh<T, N>& f, const Sh<U, M>& g, int bands) {
  using Sum = decltype(multiply_values(WideOf<T>(), WideOf<U>()));
  constexpr std::size_t kMost = coefficient_count(kMaxStaticBands);
  std::array<WideOf<T>, kMost> a = {};
  std::array<WideOf<U>, kMost> b = {};
  std::array<Sum, kMost> sum = {};
  for (std::size_t i = 0; i < std::min(f.size(), kMost); ++i) a[i] = static_cast<WideOf<T>>(f[i]);
  for (std::size_t i = 0; i < std::min(g.size(), kMost); ++i) b[i] = static_cast<WideOf<U>>(g[i]);
  // All six orders of i, j, k at once, without a branch; where indices are equal those orders are fewer.
  constexpr std::array<double, 3> kShare = {1, 1.0 / 2, 1.0 / 6};
  const auto both = [&](std::size_t i, std::size_t j) {
    return multiply_values(a[i], b[j]) + multiply_values(a[j], b[i]);
  };
  for (const auto& [i, j, k, value] : gaunt_integrals(std::max({f.bands(), g.bands(), bands}))) {
    const double share = value * kShare[static_cast<std::size_t>(i == j) + static_cast<std::size_t>(j == k)];
    sum[k] += share * both(i, j);
    sum[j] += share * both(i, k);
    sum[i] += share * both(j, k);
  }
  Sh<ProductOf<T, U>, K> result(bands);
  const std::size_t count = std::min(result.size(), kMost);
  for (std::size_t i = 0; i < count; ++i) result[i] = static_cast<ProductOf<T, U>>(sum[i]);
  return result;
}

/// The product of functions of any bands through multiply_on_sphere, channel by channel.
template <int K, class T, int N, class U, int M>
Sh<ProductOf<T, U>, K> product_by_rings(const Sh<T, N>& f, const Sh<U, M>& g, int bands) {
  Sh<ProductOf<T, U>, K> result(bands);
  if constexpr (kIsColor<ProductOf<T, U>>) {
    std::array<std::vector<double>, 3> rgb;
    for (int c = 0; c < 3; ++c) rgb[c] = multiply_on_sphere(channel_of(f, c), channel_of(g, c), bands);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = static_cast<ProductOf<T, U>>(RgbD(rgb[0][i], rgb[1][i], rgb[2][i]));
    }
  } else {
    const std::vector<double> values = multiply_on_sphere(channel_of(f, 0), channel_of(g, 0), bands);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<ProductOf<T, U>>(values[i]);
  }
  return result;
}

/// f g with a given number of bands, more or fewer than f and g have: product_to<4>(f, g), product_to(f, g, bands).
/// Up to 6 bands everywhere by the list of Gaunt integrals, without heap where they are static; above, on the sphere.
template <int K = kDynamic, class T, int N, class U, int M>
Sh<ProductOf<T, U>, K> product_to(const Sh<T, N>& f, const Sh<U, M>& g, int bands = K) {
  check(f.bands() >= 1 && g.bands() >= 1 && bands >= 1, "a product needs at least one band of each");
  if (std::max({f.bands(), g.bands(), bands}) <= kMaxStaticBands) return product_by_list<K>(f, g, bands);
  return product_by_rings<K>(f, g, bands);
}

template <int N, int M>
inline constexpr int kWiderBands = N == kDynamic || M == kDynamic ? kDynamic : std::max(N, M);
template <int N, int M>
inline constexpr int kFullBands = N == kDynamic || M == kDynamic ? kDynamic : N + M - 1;

/// f g with as many bands as the one of f and g that has more.
template <class T, int N, class U, int M>
Sh<ProductOf<T, U>, kWiderBands<N, M>> product(const Sh<T, N>& f, const Sh<U, M>& g) {
  return product_to<kWiderBands<N, M>>(f, g, std::max(f.bands(), g.bands()));
}

/// All of f g: the sum of their bands less one.
template <class T, int N, class U, int M>
Sh<ProductOf<T, U>, kFullBands<N, M>> full_product(const Sh<T, N>& f, const Sh<U, M>& g) {
  return product_to<kFullBands<N, M>>(f, g, f.bands() + g.bands() - 1);
}

}  // namespace zonal
