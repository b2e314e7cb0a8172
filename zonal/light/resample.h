#pragma once

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/math/vec.h"
#include "zonal/sphere/projection.h"

namespace zonal {

/// What a picture that shows a part of the sphere only (a fisheye) has in the directions it does not show.
enum class Uncovered {
  kRimMean,   ///< the mean of the texels along its rim
  kConstant,  ///< ResampleOptions::ground
  kNearest,   ///< the nearest texel that is shown
  kBlack,     ///< nothing; see coverage() for renormalising
};

struct ResampleOptions {
  /// Turns the light: what the source shows at d, the result shows at world_from_source * d.
  Rotation world_from_source = {};
  /// Samples along each side of a target texel; 0: as many as it takes to meet every source texel under it.
  int supersample = 0;
  Uncovered uncovered = Uncovered::kRimMean;
  Rgb ground = {};  ///< radiance for Uncovered::kConstant
};

/// The same light in another picture. A target texel is the mean over its footprint, of the source interpolated
/// seamlessly (sample.h); texels that show nothing (outside a circle, in a cross's gap) are black.
///
/// A constant stays constant to rounding. The mean is centred on the texel's direction, so a linear sky is exact to the
/// square of the texels' size, and so is the energy of smooth light. A texel that outshines the map (a sun) keeps its
/// energy to the rounding of texel coordinates as floats (1e-4 of it at 2048). Nothing is negative where the source is
/// not. The same projection, size and no rotation return the same bits.
///
/// O(texels of both). Throws Error{kInput} when a size does not fit its projection, Error{kCancelled}.
Environment resample(const Environment&, const Projection& to, ImageSize, const ResampleOptions& = {}, const Run& = {});

/// The same; `size_px` is the natural unit of the layout (equirectangular height, cube face edge, disc diameter, side).
Environment resample(const Environment&, const Projection& to, int size_px, const ResampleOptions& = {},
                     const Run& = {});

/// The part of the sphere that a picture shows, 0..1, by exact texel solid angles.
double coverage(const Projection&, ImageSize);

/// Mean radiance along the rim of a picture that shows a part of the sphere, weighted by solid angle; the mean of all
/// of it when nothing is hidden.
Rgb rim_mean(const Environment&);

}  // namespace zonal
