#pragma once

namespace zonal {

// The ambient reflectance R_A(v) (ambient_reflectance.h) of the cosine-power surfaces of brdf.h, fast enough for
// tables: the integral around the lobe's axis has a closed form, so one over the angle from the axis is left. n_dot_v
// in (0, 1], exponent in [0, 1e4]; absolute error under 1e-6. 1 at normal incidence. Throw Error{kUsage} outside the
// domain.

/// Of phong_brdf(exponent): light goes around the mirror direction r, and max(n.l, 0) is integrated over each circle.
double phong_reflectance(double n_dot_v, double exponent);

/// Of blinn_phong_brdf(exponent): half vectors go around the normal, and so does the light that they mirror to v.
double blinn_phong_reflectance(double n_dot_v, double exponent);

}  // namespace zonal
