#pragma once

#include "zonal/base/run.h"
#include "zonal/image/image.h"

namespace zonal {

/// The surfaces that the ambient light of the technique "lambert" can be reflected by, in the order of the choices of
/// the control "ambient_brdf" and of the bands of ambient_reflectance_picture().
enum class AmbientBrdf { kLambert, kPhong, kBlinnPhong, kGgx };
inline constexpr int kAmbientBrdfs = 4;

inline constexpr int kAmbientColumns = 64, kAmbientRows = 16;  ///< of a band

/// Ambient reflectances R_A(v) (light/ambient_reflectance.h): kAmbientRows rows for each BRDF, n.v = (x + 1/2)/
/// kAmbientColumns across. Down a band, from its first row to its last, the parameter goes from 0 to 1: nothing for
/// Lambert, 512^p the exponent of Phong and Blinn-Phong, p the perceptual roughness of GGX (0.01 in the row of 0). Red
/// and green are what a surface of reflectance f0 at normal incidence is to be given, f0 * r + g: the others know no
/// Fresnel term, and g is 0. Unit reflectance for Lambert, so that r is to be multiplied by the albedo. Throws
/// Error{kCancelled}.
Image<Rgb> ambient_reflectance_picture(const Run& = {});

}  // namespace zonal
