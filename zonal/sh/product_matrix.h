#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/sh/gaunt.h"
#include "zonal/sh/product.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// Multiplication by a fixed function f as a symmetric matrix from `bands` bands to as many: M_ij = int f y_i y_j.
/// Bands of f up to 2 bands - 2 matter. O(bands^4) numbers; O(bands^5) to make above 6 bands. No heap up to 6 static
/// bands of both.
template <int N = kDynamic>
class ProductMatrix {
 public:
  template <class S, int M>
  explicit ProductMatrix(const Sh<S, M>& f, int bands = N)
      : count_(static_cast<std::size_t>(coefficient_count(bands))) {
    static_assert(std::is_floating_point_v<S>, "the matrix of each channel of a colour is another one");
    check(bands >= 1 && f.bands() >= 1 && (N == kDynamic || bands == N),
          "ProductMatrix needs at least one band, as many as it is made for");
    if constexpr (!kFixed) entries_.resize(count_ * count_);
    if (std::max(f.bands(), bands) <= kMaxStaticBands) {
      fill_by_list(f, bands);
    } else {
      fill_by_columns(channel_of(f, 0), bands);
    }
  }

  double operator()(std::size_t i, std::size_t j) const { return entries_[i * count_ + j]; }

  /// f times `sh`, of the bands of the matrix. Sums in double.
  template <class T, int M>
  Sh<T, M> apply(const Sh<T, M>& sh) const {
    check(sh.size() == count_, "ProductMatrix multiplies functions of the bands it was made for");
    Sh<T, M> result(sh.bands());
    for (std::size_t i = 0; i < count_; ++i) {
      WideOf<T> sum = {};
      for (std::size_t j = 0; j < count_; ++j) sum += (*this)(i, j) * static_cast<WideOf<T>>(sh[j]);
      result[i] = static_cast<T>(sum);
    }
    return result;
  }

 private:
  static constexpr bool kFixed = N != kDynamic && N <= kMaxStaticBands;

  template <class F>
  void fill_by_list(const F& f, int bands) {
    const auto add = [&](std::size_t i, std::size_t j, std::size_t k, double value) {
      if (k >= f.size() || i >= count_ || j >= count_) return;
      entries_[i * count_ + j] += value * f[k];
      if (i != j) entries_[j * count_ + i] += value * f[k];
    };
    for (const auto& [i, j, k, value] : gaunt_integrals(std::max(f.bands(), bands))) {
      add(i, j, k, value);
      if (j != k) add(i, k, j, value);
      if (i != j) add(j, k, i, value);
    }
  }
  void fill_by_columns(std::span<const double> f, int bands) {
    std::vector<double> unit(count_, 0.0);
    for (std::size_t j = 0; j < count_; ++j) {
      unit[j] = 1;
      const std::vector<double> column = multiply_on_sphere(f, unit, bands);
      unit[j] = 0;
      for (std::size_t i = 0; i < count_; ++i) entries_[i * count_ + j] = column[i];
    }
  }

  std::size_t count_;
  std::conditional_t<kFixed, std::array<double, static_cast<std::size_t>(kFixed ? coefficient_count(N* N) : 0)>,
                     std::vector<double>>
      entries_ = {};
};

}  // namespace zonal
