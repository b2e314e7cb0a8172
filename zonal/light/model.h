#pragma once

#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

// Radiance around a point as coefficients, from the lights a scene is made of: what a picture of them, infinitely
// sharp, would project to. Exact in every band. Directions need not be unit vectors. All throw Error{kUsage} for a
// direction that is zero, for numbers that are not finite and for angles outside their domain; bands >= 1, or
// std::logic_error. They add: ambient_sh(...) + directional_sh(...). For a fixed number of bands:
// with_bands<3>(cast<Rgb>(...)). Polygons: model_polygon.h; the sky: model_daylight.h; scaling to a stated effect:
// normalise.h.

/// All light from one direction. `irradiance` is that of a surface facing it.
Sh<RgbD> directional_sh(Vec3 toward_light, RgbD irradiance, int bands);

/// The same radiance from everywhere.
Sh<RgbD> ambient_sh(RgbD radiance, int bands);

/// `sky` from the half around `up`, `ground` from the other. Its irradiance is exactly
/// pi (ground + (sky - ground)(1 + n.up)/2).
Sh<RgbD> hemisphere_sh(Vec3 up, RgbD sky, RgbD ground, int bands);

/// A disc of half_angle radians in [0, pi] around a direction (Sloan 2008, A3).
Sh<RgbD> cone_sh(Vec3 toward_light, double half_angle, RgbD radiance, int bands);

/// A disc that fades to its rim, `radiance` in its middle; half_angle in (0, pi] (Sloan 2008, A4).
Sh<RgbD> smooth_cone_sh(Vec3 toward_light, double half_angle, RgbD radiance, int bands);

/// A glowing ball whose centre lies `to_center` from the lit point; radius in the same unit. Around the lit point it is
/// ambient light.
Sh<RgbD> sphere_sh(Vec3 to_center, double radius, RgbD radiance, int bands);

/// Irradiance by a uniform cone or sphere of radiance 1 and half_angle in [0, pi], on a surface whose normal lies
/// `from_normal` radians in [0, pi] from its middle; what is below the horizon is cut off. In closed form: pi
/// sin^2(half_angle) cos(from_normal) while all of it is above (Lambert 1760), else Snyder 1996, with absolute error
/// 4e-15.
double cone_irradiance(double half_angle, double from_normal);

}  // namespace zonal
