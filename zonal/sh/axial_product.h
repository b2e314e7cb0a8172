#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/math/legendre.h"
#include "zonal/math/quadrature.h"
#include "zonal/math/turn.h"
#include "zonal/sh/rotate.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// Entries of the matrices of each |m|: bands^2 for m = 0, (bands-1)^2 for 1, ... 1.
constexpr int axial_entries(int bands) { return bands * (bands + 1) * (2 * bands + 1) / 6; }

/// Multiplication by a function k(d.n) of the angle to an axis n, from `bands` bands to as many. In the frame of the
/// axis it couples equal m only: a small symmetric matrix for each |m|, int k y_{l,m} y_{l',m}. The product has more
/// bands than are kept (for a function with an edge, infinitely many); those kept are exact. Up to 6 static bands it
/// takes no heap.
template <int N = kDynamic>
class AxialProduct {
 public:
  /// k as a rule on the cosine of the angle: rule.weights times k(node) integrates polynomials of degree
  /// 2 bands - 2 times k exactly.
  template <class Function>
  AxialProduct(const Quadrature& rule, Function&& k, int bands = N) : bands_(bands) {
    check(bands >= 1 && (N == kDynamic || bands == N),
          "AxialProduct needs at least one band, as many as it is made for");
    Column column = {};
    if constexpr (!kFixed) {
      entries_.resize(static_cast<std::size_t>(axial_entries(bands)));
      column.resize(static_cast<std::size_t>(bands));
    }
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const double z = rule.nodes[i], r = std::sqrt((1 - z) * (1 + z)), weight = kPi * rule.weights[i] * k(z);
      for (int m = 0; m < bands; ++m) {
        const std::span<double> p = std::span(column).first(static_cast<std::size_t>(bands - m));
        associated_legendre(m, z, r, p);
        double* entry = entries_.data() + before(m);
        for (const double row : p) {
          for (const double value : p) *entry++ += (m == 0 ? 2 : 1) * weight * row * value;
        }
      }
    }
  }

  int bands() const { return bands_; }

  /// The integral of k y_{l,m} y_{other,m} for an axis +Z, the same for -m; |m| <= l, other.
  double operator()(int l, int other, int m) const {
    m = m < 0 ? -m : m;
    return entries_[static_cast<std::size_t>(before(m) + (l - m) * (bands_ - m) + other - m)];
  }

  /// The product about +Z. Sums in double.
  template <class T, int M>
  Sh<T, M> apply(const Sh<T, M>& sh) const {
    check(sh.bands() == bands_, "AxialProduct multiplies functions of the bands it was made for");
    Sh<T, M> result(bands_);
    for (int l = 0; l < bands_; ++l) {
      for (int m = -l; m <= l; ++m) {
        WideOf<T> sum = {};
        for (int other = m < 0 ? -m : m; other < bands_; ++other) {
          sum += (*this)(l, other, m) * static_cast<WideOf<T>>(sh(other, m));
        }
        result(l, m) = static_cast<T>(sum);
      }
    }
    return result;
  }

  /// The product about a unit axis.
  template <class T, int M>
  Sh<T, M> apply(const Sh<T, M>& sh, Vec3 axis) const {
    const Rotation up_to_axis = turn_z_to(axis);
    if (up_to_axis == Rotation::identity()) return apply(sh);
    if constexpr (kFixed) {
      return rotate(apply(rotate(sh, transpose(up_to_axis))), up_to_axis);
    } else {
      const ShRotation<N> turn(up_to_axis, bands_);
      return turn.apply(apply(turn.apply_inverse(sh)));
    }
  }

 private:
  static constexpr bool kFixed = N != kDynamic && N <= kMaxStaticBands;
  int before(int m) const { return axial_entries(bands_) - axial_entries(bands_ - m); }

  using Column =
      std::conditional_t<kFixed, std::array<double, static_cast<std::size_t>(kFixed ? N : 0)>, std::vector<double>>;

  int bands_;
  std::conditional_t<kFixed, std::array<double, static_cast<std::size_t>(kFixed ? axial_entries(N) : 0)>,
                     std::vector<double>>
      entries_ = {};
};

/// f times the zonal function of these coefficients (of m = 0) about a unit axis, with the bands of f. The product is
/// taken in the frame of the axis; O(bands^2 zonal.size()), and a rotation there and back. Zonal bands beyond
/// 2 bands - 1 do not matter. Up to 6 static bands only the first call of the program takes heap.
template <class T, int N>
Sh<T, N> product_with_zonal(const Sh<T, N>& f, std::span<const double> zonal, Vec3 axis = {0, 0, 1}) {
  check(f.bands() >= 1, "a product needs at least one band of each");
  const std::size_t most = static_cast<std::size_t>(2 * f.bands() - 1);
  zonal = zonal.first(zonal.size() < most ? zonal.size() : most);
  // Degree 2 (bands-1) of the pair and as much of the zonal function.
  const auto multiply = [&](const Quadrature& rule, std::span<double> y) {
    const auto value = [&](double z) {
      associated_legendre(0, z, std::sqrt((1 - z) * (1 + z)), y);
      double sum = 0;
      for (std::size_t l = 0; l < zonal.size(); ++l) sum += zonal[l] * y[l];
      return sum;
    };
    return AxialProduct<N>(rule, value, f.bands()).apply(f, axis);
  };
  if constexpr (N != kDynamic && N <= kMaxStaticBands) {
    static const Quadrature rule = gauss_legendre(2 * N - 1);
    std::array<double, static_cast<std::size_t>(2 * N - 1)> y;
    return multiply(rule, y);
  } else {
    std::vector<double> y(most);
    return multiply(gauss_legendre(2 * f.bands() - 1), y);
  }
}

}  // namespace zonal
