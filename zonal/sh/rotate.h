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
#include "zonal/sh/rotation_recurrence.h"
#include "zonal/sh/sh.h"

namespace zonal {

// Turning a function: (rotate(f, R))(d) = f(R^T d), so what f had at d the result has at R d. Each band turns by an
// orthogonal matrix of its own. A Rotation with a mirror in it works as well.

/// The matrices of bands 0..bands-1 one after another into `blocks` (rotation_entries(bands) values), each with rows m
/// and columns n from -l to l. Recurrence from band to band (after Ivanic & Ruedenberg 1996), exact to a few roundings
/// a band; O(bands^3). `rotation` is orthogonal to 1e-6; what it lacks grows l times in band l.
void rotation_blocks(const Rotation& rotation, int bands, std::span<double> blocks);

/// Throws std::logic_error unless `rotation` is orthogonal to 1e-6 (the norm of R R^T - 1): float input is, NaN is not.
inline void check_orthogonal(const Rotation& rotation) {
  const auto& [x, y, z] = rotation.rows;
  const double xx = dot(x, x) - 1, yy = dot(y, y) - 1, zz = dot(z, z) - 1;
  const double xy = dot(x, y), yz = dot(y, z), xz = dot(x, z);
  check(xx * xx + yy * yy + zz * zz + 2 * (xy * xy + yz * yz + xz * xz) <= 1e-6 * 1e-6,
        "a rotation must be orthogonal");
}

/// Whether `rotation` turns about the Z axis alone, without a mirror.
inline bool is_about_z(const Rotation& rotation) {
  const auto& [x, y, z] = rotation.rows;
  return x.z == 0 && y.z == 0 && z.x == 0 && z.y == 0 && z.z > 0 && x.x * y.y > x.y * y.x;
}

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
[[gnu::always_inline]] inline Sh<T, N> rotate_few_bands(const Sh<T, N>& sh, const Rotation& rotation) {
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

/// The same for `count` functions of 4 to 6 bands, one behind the other: R = Z(a) Y(b) Z(c), and Y(b) is Z(-b) between
/// two swaps of y and z, which are constant matrices (Pinchon & Hoggan 2007). Does not check the rotation. `to` may be
/// `from`.
void rotate_by_turns(const Rotation& rotation, int bands, int count, std::span<const float> from, std::span<float> to);
void rotate_by_turns(const Rotation& rotation, int bands, int count, std::span<const double> from,
                     std::span<double> to);

template <class T, int N>
Sh<T, N> rotate_by_turns(const Sh<T, N>& sh, const Rotation& rotation) {
  Sh<T, N> result = sh;  // not zeros, for which g++ takes an instruction of 10 ns
  if constexpr (std::is_floating_point_v<T>) {
    rotate_by_turns(rotation, N, 1, sh.values(), result.values());
  } else {
    constexpr std::size_t kCount = coefficient_count(N);
    std::array<ScalarOf<T>, 3 * kCount> channels;
    for (std::size_t i = 0; i < kCount; ++i) {
      channels[i] = sh[i].r;
      channels[kCount + i] = sh[i].g;
      channels[2 * kCount + i] = sh[i].b;
    }
    rotate_by_turns(rotation, N, 3, std::span<const ScalarOf<T>>(channels), channels);
    for (std::size_t i = 0; i < kCount; ++i) result[i] = {channels[i], channels[kCount + i], channels[2 * kCount + i]};
  }
  return result;
}

/// (rotate(f, R))(d) = f(R^T d). For one function; ShRotation for many by the same rotation, rotate_batch (batch.h) for
/// many at once. O(bands^3), O(bands^2) about Z. Up to 6 static bands it takes no heap and computes in T's own
/// precision. Throws std::logic_error where R is not orthogonal to 1e-6.
template <class T, int N>
Sh<T, N> rotate(const Sh<T, N>& sh, const Rotation& rotation) {
  check_orthogonal(rotation);
  check(sh.bands() >= 1, "rotate needs at least one band");
  if constexpr (1 <= N && N <= 3) {
    return rotate_few_bands(sh, rotation);
  } else {
    if (is_about_z(rotation)) return rotate_about_z(sh, rotation.rows[0].x, rotation.rows[1].x);
    if constexpr (N != kDynamic && N <= kMaxStaticBands) {
      return rotate_by_turns(sh, rotation);
    } else {
      return ShRotation<N>(rotation, sh.bands()).apply(sh);
    }
  }
}

}  // namespace zonal
