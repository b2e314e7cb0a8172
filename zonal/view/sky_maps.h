#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/image.h"
#include "zonal/light/environment.h"

namespace zonal {

/// What the program of Tokoi 2015 ("Irradiance mapping (2)") makes of a sky, and what it should be, for any ground: a
/// mean is linear in the ground's radiance g, M(q) = maps + shares g.
struct SkyMaps {
  std::vector<double> shininess;  ///< as asked for
  /// Paraboloid maps over black ground, the zenith's beside the nadir's, each size_px a side, laid out as the published
  /// ones: two rows of them for each shininess, published over corrected.
  Image<Rgb> maps;
  /// The ground's share of the upper left quarter of the same maps (the others mirror it), a row for each shininess:
  /// red as published, green corrected.
  Image<Rgb> shares;
  RgbD sky_mean, ground_mean;  ///< of the upper and of the lower half of the sphere, by solid angle
};

/// The upper half of an environment is taken for an equidistant fisheye photograph of 180 degrees, the zenith in the
/// middle, of sky_photograph_px() pixels a side. Light in the environment's unit. docs/notes/fisheye.md has the
/// formulas. Sums over the photograph's pixels for each texel: O(photograph * maps * shininess). Throws Error{kUsage}
/// for an odd or too small size and a shininess outside of [0, 1e4], Error{kInput} for values that are not finite,
/// Error{kCancelled}.
SkyMaps sky_maps(const Environment&, const std::vector<double>& shininess, int size_px, const Run& = {});

/// Twice a map's edge: a map's widest texels, those at the zenith, span 2.5 of the photograph's pixels.
int sky_photograph_px(int size_px);

}  // namespace zonal
