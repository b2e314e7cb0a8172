#pragma once

#include <vector>

namespace zonal {

// Zonal coefficients z_l, l = 0..bands-1, of the shapes that lights have, about +Z: the coefficients of m = 0, all
// others being zero. zonal_toward() turns them to a direction. O(bands) unless said otherwise; any number of bands from
// 0 on. A negative number of bands is std::logic_error.

/// A light from one direction (Dirac's delta), of unit integral: z_l = sqrt((2l+1)/4pi).
std::vector<double> delta_zonal(int bands);

/// One in every direction.
std::vector<double> constant_zonal(int bands);

/// max(c, 0), c the cosine of the angle to +Z.
std::vector<double> clamped_cosine_zonal(int bands);

/// One in the upper half, zero in the lower.
std::vector<double> upper_half_zonal(int bands);

/// One within half_angle radians of +Z, zero outside: a disc, or a spherical light seen from outside. half_angle in
/// [0, pi]. Without cancellation: a few eps relative to sqrt(2l+1) z_0 at any angle, also tiny ones (Sloan 2008, A3,
/// for any l). Throws Error{kUsage} outside the domain.
std::vector<double> cone_zonal(double half_angle, int bands);

/// The smooth cone of Sloan 2008, A4: smooth_cone_profile() about +Z. half_angle in (0, pi]. By quadrature exact to
/// rounding at every angle, 1e-14 sqrt(2l+1) z_0; the closed forms lose all digits towards small angles. O(bands (20 +
/// half_angle bands)). Throws Error{kUsage} outside the domain.
std::vector<double> smooth_cone_zonal(double half_angle, int bands);

/// 2u^3 - 3u^2 + 1 for u = angle/half_angle in [0, 1], zero beyond: one on the axis, zero at the rim, level at both.
double smooth_cone_profile(double angle, double half_angle);

/// The half angle under which a sphere is seen from `distance` to its centre: asin(radius/distance), pi from inside.
/// Both in the same unit, radius >= 0, distance >= 0; throws Error{kUsage} otherwise and where both are zero.
double sphere_half_angle(double radius, double distance);

}  // namespace zonal
