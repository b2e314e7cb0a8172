#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/sh/sh.h"

namespace zonal {

// The product of two functions of a and b bands has a+b-1 bands. What is asked for beyond those is zero; with fewer,
// the result is the exact product, projected on them. Colours multiply by channel; a number and a colour give a colour.

template <class T>
inline constexpr bool kIsColor = false;
template <class T>
inline constexpr bool kIsColor<Color3<T>> = true;

/// The coefficient of a product: a colour when one of them is, in the wider of their precisions.
template <class A, class B>
using ProductOf = std::conditional_t<kIsColor<A> || kIsColor<B>, Color3<std::common_type_t<ScalarOf<A>, ScalarOf<B>>>,
                                     std::common_type_t<ScalarOf<A>, ScalarOf<B>>>;

/// Coefficients of f g by exact quadrature on rings, for any number of bands; O(bands^3). `f` and `g` hold the squares
/// of their bands.
std::vector<double> multiply_on_sphere(std::span<const double> f, std::span<const double> g, int result_bands);

/// One channel of a value; a number is its own every channel.
template <class T>
constexpr auto& channel_of(T& value, int channel) {
  if constexpr (kIsColor<std::remove_const_t<T>>) {
    return channel == 0 ? value.r : channel == 1 ? value.g : value.b;
  } else {
    return value;
  }
}

/// One channel of the coefficients.
template <class T, int N>
std::vector<double> channel_of(const Sh<T, N>& sh, int channel) {
  std::vector<double> values(sh.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = channel_of(sh[i], channel);
  return values;
}

/// The coefficients of f g for functions of 1 to 6 bands, projected on as many: by exact quadrature as well, on rings
/// that the compiler has prepared, in SIMD lanes. To a few roundings of the precision given; no heap. The spans hold
/// bands^2 numbers; `result` may be `f` or `g`.
void multiply_few_bands(int bands, std::span<const float> f, std::span<const float> g, std::span<float> result);
void multiply_few_bands(int bands, std::span<const double> f, std::span<const double> g, std::span<double> result);

/// The product of functions of any bands up to 6 through multiply_few_bands, channel by channel.
template <int K, class T, int N, class U, int M>
Sh<ProductOf<T, U>, K> product_of_few_bands(const Sh<T, N>& f, const Sh<U, M>& g, int bands) {
  using Scalar = ScalarOf<ProductOf<T, U>>;
  constexpr std::size_t kMost = coefficient_count(kMaxStaticBands);
  const int most = std::max({f.bands(), g.bands(), bands});
  const std::size_t size = std::min(static_cast<std::size_t>(coefficient_count(most)), kMost);
  Sh<ProductOf<T, U>, K> result(bands);
  std::array<Scalar, kMost> store_a, store_b;
  const std::span a = std::span(store_a).first(size), b = std::span(store_b).first(size);
  for (int channel = 0; channel < (kIsColor<ProductOf<T, U>> ? 3 : 1); ++channel) {
    for (std::size_t i = 0; i < size; ++i) {
      a[i] = i < f.size() ? static_cast<Scalar>(channel_of(f[i], channel)) : Scalar(0);
      b[i] = i < g.size() ? static_cast<Scalar>(channel_of(g[i], channel)) : Scalar(0);
    }
    multiply_few_bands(most, std::span<const Scalar>(a), std::span<const Scalar>(b), a);
    for (std::size_t i = 0; i < result.size(); ++i) channel_of(result[i], channel) = a[i];
  }
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
/// In the wider of their precisions up to 6 bands everywhere, without heap where they are static; above in double.
template <int K = kDynamic, class T, int N, class U, int M>
Sh<ProductOf<T, U>, K> product_to(const Sh<T, N>& f, const Sh<U, M>& g, int bands = K) {
  check(f.bands() >= 1 && g.bands() >= 1 && bands >= 1, "a product needs at least one band of each");
  if constexpr (std::max({N, M, K}) <= kMaxStaticBands) {
    if (std::max({f.bands(), g.bands(), bands}) <= kMaxStaticBands) return product_of_few_bands<K>(f, g, bands);
  }
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
