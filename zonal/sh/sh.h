#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/math/vec.h"

namespace zonal {

/// The number of bands is known at run time only.
inline constexpr int kDynamic = -1;
/// Up to this many bands code is unrolled at compile time.
inline constexpr int kMaxStaticBands = 6;

constexpr int coefficient_count(int bands) { return bands * bands; }
constexpr int coefficient_index(int l, int m) { return l * (l + 1) + m; }

/// The real number type inside a coefficient: float for Rgb. And the type in which long sums of it are taken.
template <class T>
struct CoefficientTraits {
  using Scalar = T;
  using Wide = double;
};
template <class T>
struct CoefficientTraits<Color3<T>> {
  using Scalar = T;
  using Wide = RgbD;
};
template <class T>
using ScalarOf = typename CoefficientTraits<T>::Scalar;
template <class T>
using WideOf = typename CoefficientTraits<T>::Wide;

/// The spherical-harmonic coefficients of a function on the sphere: N bands l = 0..N-1, N^2 coefficients at index
/// l(l+1)+m. Real orthonormal basis without the Condon-Shortley sign (y_{1,1} = +0.4886 x). T is float, double, Rgb or
/// RgbD. Sh<T, N> is a plain value of N^2 T; Sh<T> takes its bands from the constructor. New coefficients are zero.
template <class T, int N = kDynamic>
class Sh {
  static_assert(N == kDynamic || N >= 1);

 public:
  using Value = T;
  using Scalar = ScalarOf<T>;

  constexpr Sh() = default;
  /// `bands` must be N where N is static.
  constexpr explicit Sh(int bands) {
    if constexpr (N == kDynamic) {
      check(bands >= 0, "the number of bands must not be negative");
      bands_ = bands;
      values_.resize(static_cast<std::size_t>(coefficient_count(bands)));
    } else {
      check(bands == N, "the number of bands must be the static one");
    }
  }

  constexpr int bands() const {
    if constexpr (N == kDynamic) {
      return bands_;
    } else {
      return N;
    }
  }
  constexpr std::size_t size() const { return values_.size(); }

  constexpr T& operator()(int l, int m) { return values_[static_cast<std::size_t>(coefficient_index(l, m))]; }
  constexpr const T& operator()(int l, int m) const {
    return values_[static_cast<std::size_t>(coefficient_index(l, m))];
  }
  constexpr T& operator[](std::size_t i) { return values_[i]; }
  constexpr const T& operator[](std::size_t i) const { return values_[i]; }

  /// The 2l+1 coefficients m = -l..l of a band.
  constexpr std::span<T> band(int l) { return values().subspan(l * l, 2 * l + 1); }
  constexpr std::span<const T> band(int l) const { return values().subspan(l * l, 2 * l + 1); }
  constexpr std::span<T> values() { return values_; }
  constexpr std::span<const T> values() const { return values_; }

  constexpr Sh& operator+=(const Sh& other) {
    check(bands() == other.bands(), "coefficients of different numbers of bands do not add");
    for (std::size_t i = 0; i < size(); ++i) values_[i] = values_[i] + other.values_[i];
    return *this;
  }
  constexpr Sh& operator-=(const Sh& other) {
    check(bands() == other.bands(), "coefficients of different numbers of bands do not subtract");
    for (std::size_t i = 0; i < size(); ++i) values_[i] = values_[i] - other.values_[i];
    return *this;
  }
  constexpr Sh& operator*=(Scalar s) {
    for (T& value : values_) value = s * value;
    return *this;
  }

  friend constexpr Sh operator+(Sh a, const Sh& b) { return a += b; }
  friend constexpr Sh operator-(Sh a, const Sh& b) { return a -= b; }
  friend constexpr Sh operator*(Scalar s, Sh a) { return a *= s; }

  constexpr bool operator==(const Sh&) const = default;

 private:
  struct Known {
    bool operator==(const Known&) const = default;
  };
  [[no_unique_address]] std::conditional_t<N == kDynamic, int, Known> bands_ = {};
  std::conditional_t<N == kDynamic, std::vector<T>, std::array<T, static_cast<std::size_t>(N == kDynamic ? 0 : N * N)>>
      values_ = {};
};

/// A colour times the coefficients of a scalar function.
template <class T, int N>
constexpr Sh<Color3<T>, N> operator*(Color3<T> color, const Sh<T, N>& sh) {
  Sh<Color3<T>, N> product(sh.bands());
  for (std::size_t i = 0; i < sh.size(); ++i) product[i] = sh[i] * color;
  return product;
}

/// The same coefficients in another precision.
template <class To, class From, int N>
constexpr Sh<To, N> cast(const Sh<From, N>& sh) {
  Sh<To, N> result(sh.bands());
  for (std::size_t i = 0; i < sh.size(); ++i) result[i] = static_cast<To>(sh[i]);
  return result;
}

/// The same function with fewer bands (the rest dropped) or more (zeros added). `bands` is needed where M is dynamic.
template <int M = kDynamic, class T, int N>
constexpr Sh<T, M> with_bands(const Sh<T, N>& sh, int bands = M) {
  Sh<T, M> result(bands);
  const std::size_t common = sh.size() < result.size() ? sh.size() : result.size();
  for (std::size_t i = 0; i < common; ++i) result[i] = sh[i];
  return result;
}

/// The bridge from run time to compile time: calls work.template operator()<N>() with N = bands for 1..6 bands, N =
/// kDynamic for any other number. `work` returns the same type for each.
template <class Work>
constexpr decltype(auto) with_static_bands(int bands, Work&& work) {
  static_assert(kMaxStaticBands == 6, "one case for each");
  switch (bands) {
    case 1:
      return work.template operator()<1>();
    case 2:
      return work.template operator()<2>();
    case 3:
      return work.template operator()<3>();
    case 4:
      return work.template operator()<4>();
    case 5:
      return work.template operator()<5>();
    case 6:
      return work.template operator()<6>();
    default:
      return work.template operator()<kDynamic>();
  }
}

}  // namespace zonal
