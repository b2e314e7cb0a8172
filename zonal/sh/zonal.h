#pragma once

#include <span>
#include <utility>
#include <vector>

#include "zonal/sh/eval.h"
#include "zonal/sh/per_band.h"
#include "zonal/sh/sh.h"

namespace zonal {

// A function k(d.n) of the angle to an axis n is written in one of two ways:
//   factors lambda_l = 2 pi int k(c) P_l(c) dc: what convolving with it does to band l (1 for l = 0 when k integrates
//   to 1); zonal coefficients z_l: its coefficients of m = 0 when n is +Z.
// They differ by sqrt((2l+1)/4pi) (Funk 1916, Hecke 1918).

/// z_l = lambda_l sqrt((2l+1)/4pi).
std::vector<double> zonal_from_factors(std::span<const double> factors);
/// lambda_l = z_l sqrt(4pi/(2l+1)).
std::vector<double> factors_from_zonal(std::span<const double> zonal);
/// The same into `factors`, of the same size.
void factors_from_zonal(std::span<const double> zonal, std::span<double> factors);

/// The function with these zonal coefficients at cosine c of the angle to its axis.
double evaluate_zonal(std::span<const double> zonal, double c);

/// Scales band l by factors[l]: convolution with the function of those factors. Needs a factor for each band.
template <class T, int N>
constexpr Sh<T, N> convolve(Sh<T, N> sh, std::span<const double> factors) {
  check(factors.size() >= static_cast<std::size_t>(sh.bands()), "one factor for each band");
  for (int l = 0; l < sh.bands(); ++l) {
    const auto factor = static_cast<ScalarOf<T>>(factors[static_cast<std::size_t>(l)]);
    for (T& value : sh.band(l)) value = factor * value;
  }
  return sh;
}

/// The function with these zonal coefficients turned from +Z to a unit direction; as many bands as there are
/// coefficients. f_lm = sqrt(4pi/(2l+1)) z_l y_lm(toward) (Sloan 2008). No heap up to 6 static bands.
template <int N = kDynamic>
Sh<double, N> zonal_toward(std::span<const double> zonal, Vec3 toward) {
  Sh<double, N> sh(static_cast<int>(zonal.size()));
  basis(sh.bands(), toward, sh.values());
  PerBand<double, N> factors = per_band<double, N>(sh.bands());
  factors_from_zonal(zonal, factors);
  return convolve(std::move(sh), factors);
}

}  // namespace zonal
