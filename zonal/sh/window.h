#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <vector>

#include "zonal/sh/per_band.h"
#include "zonal/sh/sh.h"

namespace zonal {

enum class WindowKind { kNone, kHann, kLanczos, kLaplacian, kLaplacianFraction };
/// What a window that looks at the function does with colours: one weight for all three, or one for each.
enum class WindowChannels { kJoint, kEach };

/// A factor for each band that takes the ringing out of a truncated function (Sloan 2008). A plain value. The factories
/// throw Error{kUsage} when a parameter is outside the domain stated with them.
class Window {
 public:
  /// Every factor is 1.
  static Window none() { return {}; }
  /// (1 + cos(pi l/width))/2 below band `width`, 0 from it on; width > 0 in bands, not necessarily whole. With width =
  /// bands, every band is used and the next would be zero.
  static Window hann(double width_bands);
  /// (sin(pi l/width)/(pi l/width))^power below band `width`, 0 from it on; width > 0, power > 0.
  static Window lanczos(double width_bands, double power = 1);
  /// 1/(1 + weight (l(l+1))^2), weight >= 0: the function g that minimises |g - f|^2 + weight * squared_laplacian(g).
  static Window laplacian(double weight);
  /// The Laplacian window that reduces the squared Laplacian *to* this fraction of what it was, fraction in [1e-12, 1].
  static Window laplacian_fraction(double fraction, WindowChannels channels = WindowChannels::kJoint);

  WindowKind kind() const { return kind_; }
  /// Width in bands, weight or fraction; 0 for none.
  double amount() const { return amount_; }
  double power() const { return power_; }
  WindowChannels channels() const { return channels_; }

  bool operator==(const Window&) const = default;

 private:
  WindowKind kind_ = WindowKind::kNone;
  double amount_ = 0;
  double power_ = 1;
  WindowChannels channels_ = WindowChannels::kJoint;
};

/// The sum over m of the squared coefficients of each band, for each channel. Its total is the integral of f^2.
template <class T, int N>
PerBand<WideOf<T>, N> band_energies(const Sh<T, N>& sh) {
  PerBand<WideOf<T>, N> energies = per_band<WideOf<T>, N>(sh.bands());
  for (int l = 0; l < sh.bands(); ++l) {
    WideOf<T> sum = {};
    for (const T& value : sh.band(l)) sum += static_cast<WideOf<T>>(value) * static_cast<WideOf<T>>(value);
    energies[static_cast<std::size_t>(l)] = sum;
  }
  return energies;
}

/// The integral over the sphere of the square of the function's Laplacian, for each channel: the sum over l and all m
/// of (l(l+1) f_lm)^2.
template <class T, int N>
WideOf<T> squared_laplacian(const Sh<T, N>& sh) {
  WideOf<T> sum = {};
  double l = 0;
  for (const WideOf<T>& energy : band_energies(sh)) {
    sum += (l * l * (l + 1) * (l + 1)) * energy;
    ++l;
  }
  return sum;
}

/// The weight with which the Laplacian window reduces a function of these band energies to `fraction` of its squared
/// Laplacian; 0 when there is nothing to reduce (a constant or zero function). Newton's method from zero, which rises
/// to the root and cannot pass it; to rounding. Throws Error{kUsage} for a fraction outside [1e-12, 1], Error{kInput}
/// for energies that are not finite.
double laplacian_weight(std::span<const double> band_energies, double fraction);

/// The factor of band l >= 0, for windows that do not look at the function: all but the Laplacian by fraction
/// (std::logic_error).
double window_factor(const Window&, int l);
/// The factors of the bands l = 0..bands-1, likewise.
std::vector<double> window_factors(const Window&, int bands);

/// The function with its bands scaled by the window. O(bands^2); no heap on static bands.
template <class T, int N>
Sh<T, N> window(const Sh<T, N>& sh, const Window& with) {
  constexpr bool kOneChannel = std::is_same_v<T, ScalarOf<T>>;
  if constexpr (!kOneChannel) {
    if (with.channels() == WindowChannels::kEach) {
      Sh<T, N> result(sh.bands());
      Sh<ScalarOf<T>, N> one(sh.bands());
      for (const auto channel : {&T::r, &T::g, &T::b}) {
        for (std::size_t i = 0; i < sh.size(); ++i) one[i] = sh[i].*channel;
        one = window(one, with);
        for (std::size_t i = 0; i < sh.size(); ++i) result[i].*channel = one[i];
      }
      return result;
    }
  }
  Window settled = with;
  if (with.kind() == WindowKind::kLaplacianFraction) {
    PerBand<double, N> energies = per_band<double, N>(sh.bands());
    std::ranges::transform(band_energies(sh), energies.begin(), [](const WideOf<T>& energy) -> double {
      if constexpr (kOneChannel) {
        return energy;
      } else {
        return energy.r + energy.g + energy.b;
      }
    });
    settled = Window::laplacian(laplacian_weight(energies, with.amount()));
  }
  Sh<T, N> result = sh;
  for (int l = 0; l < sh.bands(); ++l) {
    const auto factor = static_cast<ScalarOf<T>>(window_factor(settled, l));
    for (T& value : result.band(l)) value = factor * value;
  }
  return result;
}

/// Where to trust the function as it is. Sloan's figure has these values; he calls them a matter of taste.
struct ContentWindow {
  double threshold = 0.07;  ///< cosine of the angle from the dominant light at which the window acts fully; below 1
  double power = 0.8;       ///< shape of the blend; above 0
};

/// The weight of the function without window, in [0, 1], at a reflected direction (or, for matte surfaces, a normal):
/// max(0, (d.r - t)/(1 - t))^p (Sloan 2008). 1 toward the dominant light, where sharpness shows; 0 away from it, where
/// ringing does. The windowed function has the rest of the weight. Both directions are unit.
double unwindowed_weight(Vec3 toward_dominant_light, Vec3 reflected, const ContentWindow& = {});

}  // namespace zonal
