#pragma once

#include <span>
#include <vector>

#include "zonal/sh/per_band.h"
#include "zonal/sh/sh.h"
#include "zonal/sh/zonal.h"

namespace zonal {

/// A_l: the band factors of the clamped cosine of unit integral, max(c, 0)/pi: 1, 2/3, 1/4, 0, -1/24, 0, 1/64 ... for
/// l = 0..bands-1. Exact to rounding for any l (Ramamoorthi & Hanrahan 2001, eq. 8, over pi).
std::vector<double> cosine_factors(int bands);
/// The same for l = 0..factors.size()-1.
void cosine_factors(std::span<double> factors);

/// Irradiance E on a surface as a function of its normal, from radiance. Evaluate it at n and multiply by albedo/pi. No
/// heap on static bands.
template <class T, int N>
Sh<T, N> irradiance(const Sh<T, N>& radiance) {
  PerBand<double, N> factors = per_band<double, N>(radiance.bands());
  cosine_factors(factors);
  for (double& factor : factors) factor *= kPi;
  return convolve(radiance, factors);
}

/// E/pi: the radiance that a white matte surface (albedo 1) reflects, as a function of its normal. No heap on static
/// bands.
template <class T, int N>
Sh<T, N> irradiance_over_pi(const Sh<T, N>& radiance) {
  PerBand<double, N> factors = per_band<double, N>(radiance.bands());
  cosine_factors(factors);
  return convolve(radiance, factors);
}

}  // namespace zonal
