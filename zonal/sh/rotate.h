#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <type_traits>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

// Turning a function: (rotate(f, R))(d) = f(R^T d), so what f had at d the result has at R d. Each band turns by an
// orthogonal matrix of its own. A Rotation with a mirror in it works as well.

/// Entries of the matrices of bands 0..bands-1, of 1, 9, 25 ... entries.
constexpr int rotation_entries(int bands) { return bands * (4 * bands * bands - 1) / 3; }

/// The matrices of bands 0..bands-1 one after another into `blocks` (rotation_entries(bands) values), each with rows m
/// and columns n from -l to l. Recurrence from band to band (after Ivanic & Ruedenberg 1996), exact to a few roundings
/// a band; O(bands^3). `rotation` is orthogonal to 1e-6; what it lacks grows l times in band l.
void rotation_blocks(const Rotation& rotation, int bands, std::span<double> blocks);

/// Throws std::logic_error unless `rotation` is orthogonal to 1e-6: float input is, NaN is not.
void check_orthogonal(const Rotation& rotation);

/// Whether `rotation` turns about the Z axis alone, without a mirror.
bool is_about_z(const Rotation& rotation);

/// A rotation prepared once for many functions of at most `bands` bands. Up to 6 static bands it takes no heap.
template <int N = kDynamic>
class ShRotation {
 public:
  explicit ShRotation(const Rotation& rotation, int bands = N) : bands_(bands) {
    check(bands >= 1 && (N == kDynamic || bands == N), "ShRotation needs at least one band, as many as it is made for");
    if constexpr (!kFixed) blocks_.resize(static_cast<std::size_t>(rotation_entries(bands)));
    rotation_blocks(rotation, bands, blocks_);
  }

  int bands() const { return bands_; }

  /// How much of the old coefficient n is in the new coefficient m of band l.
  double operator()(int l, int m, int n) const {
    return blocks_[static_cast<std::size_t>(rotation_entries(l) + (l + m) * (2 * l + 1) + l + n)];
  }

  /// The turned function. Sums in double.
  template <class T, int M>
  Sh<T, M> apply(const Sh<T, M>& sh) const {
    return turned(sh, [](int size, int m, int n) { return m * size + n; });
  }
  /// The function turned back.
  template <class T, int M>
  Sh<T, M> apply_inverse(const Sh<T, M>& sh) const {
    return turned(sh, [](int size, int m, int n) { return n * size + m; });
  }

 private:
  static constexpr bool kFixed = N != kDynamic && N <= kMaxStaticBands;

  template <class T, int M, class Place>
  Sh<T, M> turned(const Sh<T, M>& sh, Place place) const {
    check(sh.bands() <= bands_, "ShRotation was made for fewer bands");
    Sh<T, M> result(sh.bands());
    for (int l = 0; l < sh.bands(); ++l) {
      const int size = 2 * l + 1;
      const double* block = blocks_.data() + rotation_entries(l);
      const std::span<const T> from = sh.band(l);
      const std::span<T> to = result.band(l);
      for (int m = 0; m < size; ++m) {
        WideOf<T> sum = {};
        for (int n = 0; n < size; ++n) sum += block[place(size, m, n)] * static_cast<WideOf<T>>(from[n]);
        to[m] = static_cast<T>(sum);
      }
    }
    return result;
  }

  int bands_;
  std::conditional_t<kFixed, std::array<double, static_cast<std::size_t>(kFixed ? rotation_entries(N) : 0)>,
                     std::vector<double>>
      blocks_;
};

/// The function turned about +Z by the angle of this cosine and sine, x towards y. O(bands^2).
template <class T, int N>
Sh<T, N> rotate_about_z(Sh<T, N> sh, double cosine, double sine) {
  double cos_m = 1, sin_m = 0;
  for (int m = 1; m < sh.bands(); ++m) {
    const double next = cos_m * cosine - sin_m * sine;
    sin_m = sin_m * cosine + cos_m * sine;
    cos_m = next;
    const auto c = static_cast<ScalarOf<T>>(cos_m), s = static_cast<ScalarOf<T>>(sin_m);
    for (int l = m; l < sh.bands(); ++l) {
      const T even = sh(l, m), odd = sh(l, -m);
      sh(l, m) = c * even - s * odd;
      sh(l, -m) = s * even + c * odd;
    }
  }
  return sh;
}

/// The same for 1, 2 or 3 static bands and any rotation, unrolled: band 1 is a vector v and turns to R v, band 2 is a
/// symmetric matrix A without trace and turns to R A R^T. In T's own precision.
template <class T, int N>
Sh<T, N> rotate_few_bands(const Sh<T, N>& sh, const Rotation& rotation) {
  static_assert(1 <= N && N <= 3);
  using Scalar = ScalarOf<T>;
  using Row = std::array<T, 3>;
  std::array<std::array<Scalar, 3>, 3> r;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 row = rotation.rows[i];
    r[i] = {static_cast<Scalar>(row.x), static_cast<Scalar>(row.y), static_cast<Scalar>(row.z)};
  }
  const auto turn = [&](std::size_t i, const Row& v) { return r[i][0] * v[0] + r[i][1] * v[1] + r[i][2] * v[2]; };

  Sh<T, N> result;
  result[0] = sh[0];
  if constexpr (N > 1) {
    const Row v = {sh(1, 1), sh(1, -1), sh(1, 0)};
    result(1, 1) = turn(0, v);
    result(1, -1) = turn(1, v);
    result(1, 0) = turn(2, v);
  }
  if constexpr (N > 2) {
    // The function of band 2 is sqrt(15/16pi) d^T A d.
    constexpr auto kSqrt3 = static_cast<Scalar>(std::numbers::sqrt3);
    const T xy = sh(2, -2), yz = sh(2, -1), xz = sh(2, 1), third = (1 / kSqrt3) * sh(2, 0);
    const std::array<Row, 3> a = {Row{sh(2, 2) - third, xy, xz}, Row{xy, Scalar(-1) * sh(2, 2) - third, yz},
                                  Row{xz, yz, Scalar(2) * third}};
    std::array<Row, 3> ra;  // A R^T, transposed
    for (std::size_t i = 0; i < 3; ++i) ra[i] = {turn(i, a[0]), turn(i, a[1]), turn(i, a[2])};
    result(2, -2) = turn(0, ra[1]);
    result(2, -1) = turn(1, ra[2]);
    result(2, 0) = (kSqrt3 / 2) * turn(2, ra[2]);
    result(2, 1) = turn(0, ra[2]);
    result(2, 2) = Scalar(0.5) * (turn(0, ra[0]) - turn(1, ra[1]));
  }
  return result;
}

/// The same for up to 6 static bands and a rotation without a mirror, as turns about Z and swaps of y and z, whose
/// matrices are made once in the run of the program: R = Z(a) Y(b) Z(c), and Y(b) is Z(-b) between two swaps (Pinchon &
/// Hoggan 2007).
template <class T, int N>
Sh<T, N> rotate_by_turns(const Sh<T, N>& sh, const Rotation& rotation) {
  static_assert(1 <= N && N <= kMaxStaticBands);
  static const ShRotation<N> swap_yz(Rotation{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}}});
  const auto& [x, y, z] = rotation.rows;
  const double sin_b = std::hypot(x.z, y.z);
  const double cos_a = sin_b > 0 ? x.z / sin_b : 1, sin_a = sin_b > 0 ? y.z / sin_b : 0;
  // Next to the pole a is anybody's guess; c is taken from Z(-a) R, so that the guess does not matter.
  const double sin_c = cos_a * y.x - sin_a * x.x, cos_c = cos_a * y.y - sin_a * x.y;
  const Sh<T, N> tipped = rotate_about_z(swap_yz.apply(rotate_about_z(sh, cos_c, sin_c)), z.z, -sin_b);
  return rotate_about_z(swap_yz.apply(tipped), cos_a, sin_a);
}

/// (rotate(f, R))(d) = f(R^T d). For one function; ShRotation for many. O(bands^3), O(bands^2) about Z; no heap up to 6
/// static bands, the turns about Z in T's own precision there. Throws std::logic_error where R is not orthogonal to
/// 1e-6.
template <class T, int N>
Sh<T, N> rotate(const Sh<T, N>& sh, const Rotation& rotation) {
  check_orthogonal(rotation);
  check(sh.bands() >= 1, "rotate needs at least one band");
  if constexpr (1 <= N && N <= 3) {
    return rotate_few_bands(sh, rotation);
  } else {
    if (is_about_z(rotation)) return rotate_about_z(sh, rotation.rows[0].x, rotation.rows[1].x);
    if constexpr (N != kDynamic && N <= kMaxStaticBands) {
      if (determinant(rotation) > 0) return rotate_by_turns(sh, rotation);
    }
    return ShRotation<N>(rotation, sh.bands()).apply(sh);
  }
}

}  // namespace zonal
