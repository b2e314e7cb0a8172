#pragma once

#include <vector>

#include "zonal/sh/sh.h"
#include "zonal/sh/window.h"

namespace zonal {

/// A window, and what is known of the function under it.
struct NonNegativeWindow {
  Window window;
  double minimum_found = 0;       ///< the least value found (of all channels)
  double guaranteed_minimum = 0;  ///< no value anywhere is below this: see certified_minimum()
};

struct NonNegativeOptions {
  WindowKind family = WindowKind::kHann;  ///< kHann, kLanczos (to its first power) or kLaplacian
  /// A function counts as non-negative when no value is below -tolerance times its mean; above 0.
  double tolerance = 1e-5;
};

/// The weakest window of a family that makes a function non-negative everywhere, with the proof; colours share one.
/// None when the function already is. To make the irradiance non-negative give it irradiance(radiance): windows and
/// convolution commute. A function can rise and sink again as the window grows, so strengths are tried from weak to
/// strong, each at most a few times the last, and the first that will do is refined to one part in 10^5.
/// Throws Error{kInput} when no window can help (a negative mean; for the Laplacian, which never removes a band wholly,
/// also a mean of zero), or a coefficient is not finite; Error{kUsage} for another family.
NonNegativeWindow nonnegative_window(const std::vector<Sh<double>>& channels, const NonNegativeOptions& = {});

template <class T, int N>
NonNegativeWindow nonnegative_window(const Sh<T, N>& sh, const NonNegativeOptions& options = {}) {
  if constexpr (std::is_same_v<T, ScalarOf<T>>) {
    return nonnegative_window(std::vector<Sh<double>>{with_bands(cast<double>(sh), sh.bands())}, options);
  } else {
    std::vector<Sh<double>> channels;
    for (const auto channel : {&T::r, &T::g, &T::b}) {
      Sh<double>& one = channels.emplace_back(sh.bands());
      for (std::size_t i = 0; i < sh.size(); ++i) one[i] = sh[i].*channel;
    }
    return nonnegative_window(channels, options);
  }
}

}  // namespace zonal
