#pragma once

#include <span>

#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

// How bright must a light be so that a white matte surface which faces it, unshadowed, reflects a radiance of one? The
// factor c with which its coefficients are to be scaled: c = 1/(E/pi) there (Sloan 2008, "normalisation"). Evaluated in
// the bands that are used the answer is not that of the light itself: a delta in 3 bands needs 16pi/17, in 5 bands
// 32pi/31, in truth pi. All throw Error{kUsage} where the surface would reflect nothing, or less.

/// From zonal coefficients, over their bands, on a surface facing their axis.
double normalising_factor(std::span<const double> zonal);

/// From any radiance, over its bands, on a surface with normal `facing`. For a colour take one channel, or its
/// luminance.
double normalising_factor(const Sh<double>& radiance, Vec3 facing);

/// Over all bands, for a directional light of irradiance 1: pi.
double directional_normalising_factor();
/// Over all bands, for cone_zonal(half_angle): 1/sin^2(half_angle) up to pi/2, then 1. half_angle in (0, pi].
double cone_normalising_factor(double half_angle);
/// Over all bands, for smooth_cone_zonal(half_angle). half_angle in (0, pi]. 1e-14 relative at any angle.
double smooth_cone_normalising_factor(double half_angle);

}  // namespace zonal
