#pragma once

#include <array>

#include "zonal/light/extract.h"
#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

// The closed forms for one ambient light and one, two or three others in known directions (Sloan 2008, A5, corrected).
// One channel, no bounds on the sign; fit_lights() is the general verb, this is what it comes to in these cases. They
// are the least squares over the sphere of what the metric looks at. Directions need not be unit vectors. All throw
// Error{kInput} when a coefficient is not finite, Error{kUsage} for fewer than two bands, for a direction that is zero,
// and where two lights (two equal directions; with two bands two opposite ones, too) or all three cannot be told apart.

template <int N>
struct ClosedFit {
  std::array<double, N> irradiance = {};  ///< E of each light on a surface that faces it
  double ambient = 0;                     ///< radiance
};
// The paper's c is in units of a light that makes a facing white surface reflect 1 in the bands used: irradiance = c
// normalising_factor(delta_zonal(bands)), 16pi/17 for 3 and 4 bands. Its a is the ambient radiance.

/// c from the bands above the mean, then the ambient from the mean: E = (D.L)/(D.D), D a light of irradiance 1.
ClosedFit<1> fit_one_light(const Sh<double>& radiance, Vec3 direction, ExtractMetric = ExtractMetric::kIrradiance);
/// Both at once, from the two normal equations with the mean in all products. The same answer; here to show it.
ClosedFit<1> fit_one_light_coupled(const Sh<double>& radiance, Vec3 direction,
                                   ExtractMetric = ExtractMetric::kIrradiance);
ClosedFit<2> fit_two_lights(const Sh<double>& radiance, const std::array<Vec3, 2>& directions,
                            ExtractMetric = ExtractMetric::kIrradiance);
ClosedFit<3> fit_three_lights(const Sh<double>& radiance, const std::array<Vec3, 3>& directions,
                              ExtractMetric = ExtractMetric::kIrradiance);

}  // namespace zonal
