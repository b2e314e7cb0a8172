#pragma once

#include <functional>

#include "zonal/math/vec.h"

namespace zonal {

/// How a surface with normal +Z scatters: the radiance it sends towards a viewer for each unit of irradiance from a
/// direction, in 1/sr. Both unit vectors point away from the surface and above it (z > 0). Isotropic, or looked at
/// with the viewer in the half plane y = 0, x >= 0. A plain function: it may be called from several threads at once.
using Brdf = std::function<RgbD(Vec3 toward_light, Vec3 toward_viewer)>;

/// How the two directions' masking by the microsurface go together.
enum class Masking {
  kHeightCorrelated,  ///< Heitz 2014, eq. 99: what engines use
  kSeparable,         ///< G1(l) G1(v) (Walter et al. 2007, eq. 23): darker, above all where both graze
};

// All throw Error{kUsage} for a parameter outside its domain.

/// albedo/pi. albedo in [0, 1].
Brdf lambert_brdf(RgbD albedo);

/// (s + 2)/2pi (r.l)^s with r the mirror direction of v (Lafortune & Willems 1994): reflects all that arrives at normal
/// incidence and loses at the horizon elsewhere. exponent in [0, 1e7].
Brdf phong_brdf(double exponent);

/// (s + 2)(s + 4)/(8 pi (2^(-s/2) + s)) (n.h)^s (Blinn 1977; normalised to reflect all at normal incidence). exponent
/// in [0, 1e7].
Brdf blinn_phong_brdf(double exponent);

/// D G F/(4 n.l n.v) with Trowbridge-Reitz's D (Walter et al. 2007, "GGX") and Schlick's F from f0. Single scattering.
/// alpha in [1e-4, 1], f0 in [0, 1].
Brdf ggx_brdf(double alpha, RgbD f0 = {1, 1, 1}, Masking = Masking::kHeightCorrelated);

}  // namespace zonal
