#pragma once

#include <array>
#include <optional>

#include "zonal/sh/eval.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// Two bands and, of the third, one number: its part that is symmetric about the axis of the linear band (Roughton,
/// Sloan, Silvennoinen, Iwanicki & Shirley 2024, "ZH3"). Five numbers for nine, and turning it turns the two bands
/// only. Colours share the axis of their luminance, against fringes. T is float, double, Rgb or RgbD.
template <class T>
struct Zh3 {
  Sh<T, 2> linear;
  T zonal = {};  ///< the coefficient of m = 0 of the third band when the axis is +Z
  bool operator==(const Zh3&) const = default;
};

namespace zh3_detail {
inline double brightness(double value) { return value; }
inline double brightness(RgbD value) { return luminance(value); }

/// The direction in which the linear band rises, none where it is zero.
template <class T>
std::optional<Vec3> axis(const Sh<T, 2>& linear) {
  const auto along = [&](int m) { return brightness(static_cast<WideOf<T>>(linear(1, m))); };
  const Vec3 rise = {along(1), along(-1), along(0)};
  const double size = std::hypot(rise.x, rise.y, rise.z);
  if (size == 0) return std::nullopt;
  return Vec3{rise.x / size, rise.y / size, rise.z / size};
}

/// The third band's basis functions at the axis, of unit norm: the coefficients of the zonal function about it.
inline std::array<double, 5> zonal_band(Vec3 axis) {
  std::array<double, 9> y;
  basis_unrolled<3, double>(axis.x, axis.y, axis.z, y.data());
  std::array<double, 5> band;
  for (std::size_t i = 0; i < band.size(); ++i) band[i] = std::sqrt(4 * kPi / 5) * y[4 + i];
  return band;
}
}  // namespace zh3_detail

/// The nearest in the mean square, given the axis: of radiance, irradiance or what you like, of at least three bands.
/// With no linear band there is no axis, and the third band is lost.
template <class T, int N>
Zh3<T> zh3(const Sh<T, N>& sh) {
  check(sh.bands() >= 3, "ZH3 is made of at least three bands");
  Zh3<T> result = {.linear = with_bands<2>(sh)};
  if (const std::optional<Vec3> axis = zh3_detail::axis(result.linear)) {
    const std::array<double, 5> zonal = zh3_detail::zonal_band(*axis);
    WideOf<T> sum = {};
    for (std::size_t i = 0; i < zonal.size(); ++i) sum += zonal[i] * static_cast<WideOf<T>>(sh[4 + i]);
    result.zonal = static_cast<T>(sum);
  }
  return result;
}

/// The same when only two bands of *radiance* are known: the zonal number is guessed from how directional they are, by
/// the authors' fit to real lighting, z = |l1| (0.08 + 0.6 |l1|/l0), |l1| being the linear band along the axis. Zero
/// where the mean is not positive, as the fit says nothing there.
template <class T>
Zh3<T> zh3_guess(const Sh<T, 2>& radiance) {
  Zh3<T> result = {.linear = radiance};
  const std::optional<Vec3> axis = zh3_detail::axis(radiance);
  if (!axis) return result;
  const WideOf<T> along = axis->y * static_cast<WideOf<T>>(radiance(1, -1)) +
                          axis->z * static_cast<WideOf<T>>(radiance(1, 0)) +
                          axis->x * static_cast<WideOf<T>>(radiance(1, 1));
  const auto guess = [](double mean, double linear) {
    const double size = std::abs(linear);
    return mean > 0 ? size * (0.08 + 0.6 * size / mean) : 0;
  };
  if constexpr (std::is_same_v<T, ScalarOf<T>>) {
    result.zonal = static_cast<T>(guess(radiance(0, 0), along));
  } else {
    const auto mean = static_cast<RgbD>(radiance(0, 0));
    result.zonal = static_cast<T>(RgbD(guess(mean.r, along.r), guess(mean.g, along.g), guess(mean.b, along.b)));
  }
  return result;
}

/// The function as three bands, for every other verb.
template <class T>
Sh<T, 3> expand(const Zh3<T>& compact) {
  Sh<T, 3> sh = with_bands<3>(compact.linear);
  if (const std::optional<Vec3> axis = zh3_detail::axis(compact.linear)) {
    const std::array<double, 5> zonal = zh3_detail::zonal_band(*axis);
    for (std::size_t i = 0; i < zonal.size(); ++i) sh[4 + i] = static_cast<ScalarOf<T>>(zonal[i]) * compact.zonal;
  }
  return sh;
}

}  // namespace zonal
