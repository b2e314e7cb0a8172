#pragma once

#include <span>
#include <vector>

#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

// Lights out of a probe: an environment that is known by its coefficients, as one constant light and a few others
// (Sloan 2008, "extracting conventional lights"). Derivation: docs/notes/extract.md.

/// What the lights are fitted to: the radiance of the probe, or its irradiance, which is what matte surfaces show.
enum class ExtractMetric { kRadiance, kIrradiance };

/// One light found in an environment.
struct ExtractedLight {
  Vec3 direction;         ///< unit, toward the light
  RgbD irradiance;        ///< E on a surface that faces it
  double half_angle = 0;  ///< radians, of a uniform disc, at most pi/2; 0: a light from one direction
};

/// A local maximum of the probe's luminance.
struct ExtractMaximum {
  Vec3 direction;
  double luminance = 0;  ///< of the radiance there, Rec. 709
  bool taken = false;    ///< a light was put there (and may have been moved by refining)
};

struct ExtractedLights {
  RgbD ambient;                        ///< radiance of the constant light beside them
  std::vector<ExtractedLight> lights;  ///< the brightest first, by luminance
  /// What is left of the probe over the probe, both without their mean: 1 for no light, 0 for a perfect fit or a
  /// constant probe. "Size" is the root of the sum of squares over coefficients, each multiplied by its cosine factor
  /// in the irradiance metric, and over channels, weighted like luminance.
  double residual = 0;
  std::vector<ExtractMaximum> maxima;  ///< all that were found, the highest first; empty where none were looked for
};

struct ExtractOptions {
  int lights = 1;  ///< at most so many
  ExtractMetric metric = ExtractMetric::kIrradiance;
  bool refine = false;      ///< move the directions to where the fit is best; else they are maxima
  bool cones = false;       ///< the half angles are unknowns too; else 0
  bool nonnegative = true;  ///< no light and no ambient below zero in any channel; else the sign is free
};

/// The lights that explain the probe best. The ambient light always takes up what the others leave of the mean, so no
/// energy is lost or made.
///
/// Directions: those maxima of the luminance of the radiance that reduce the residual most, one after the other, so
/// that the lobes a truncated bright light leaves beside it are not taken for lights. Intensities: least squares over
/// all lights and the ambient at once, channel by channel, over the directions they share. `nonnegative` makes it a
/// constrained least squares (active set, Lawson & Hanson 1974), solved exactly, not a clamp; only a probe of negative
/// mean has a negative ambient then, and no lights in that channel. With `refine` or `cones` a quasi-Newton method
/// (L-BFGS) moves directions or angles, at each step with the best intensities (variable projection, Golub & Pereyra
/// 1973); with `refine` places where something is left are tried beside the maxima. The residual never grows by asking
/// for more lights, for `refine` or for `cones`. It is a local search: a better set of lights may exist.
///
/// Fewer lights come back than were asked for where the probe has fewer maxima, or where another would reduce the
/// residual by less than 1e-6. A constant or black probe has none, and no maxima are looked for. For 6 bands and 3
/// lights a millisecond or two, with `refine` and `cones` some ten. For 2..300 bands. Throws Error{kInput} when a
/// coefficient is not finite, Error{kUsage} for fewer than two bands or a negative number of lights.
ExtractedLights extract_lights(const Sh<RgbD>& radiance, const ExtractOptions& = {});

/// The same fit for lights whose directions are known, in their order; N lights in general. Directions need not be unit
/// vectors; of two equal ones the later gets nothing. Throws as above, and Error{kUsage} for a direction that is zero.
ExtractedLights fit_lights(const Sh<RgbD>& radiance, std::span<const Vec3> directions,
                           ExtractMetric metric = ExtractMetric::kIrradiance, bool nonnegative = true);

/// The light again as coefficients of radiance. bands >= 1. Throws Error{kUsage} for a half angle outside [0, pi/2] or
/// what is not finite.
Sh<RgbD> project(const ExtractedLights&, int bands);

}  // namespace zonal
