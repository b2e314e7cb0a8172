#pragma once

#include <span>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"

namespace zonal {

// Means of a fisheye photograph of the sky under Phong's lobe max(p.q, 0)^shininess, as sums over its pixels: the
// program of Tokoi 2015 ("Irradiance mapping (2)"), and what it should be. A shininess of 1 gives irradiance over pi.
// docs/notes/fisheye.md has the formulas.

/// How much of the sphere a pixel stands for.
enum class FisheyeWeights {
  /// sin(a)/a with a the angle between the pixel and q: as published, where a is called the zenith angle.
  kAngleToLobe,
  /// The solid angle: sin(T)/T with T the pixel's zenith angle, exact at the circle's rim.
  kSolidAngle,
};

/// How the ground, which the photograph does not show, takes part.
enum class FisheyeGround {
  /// The pixels between the circle and the square around it: as published. They are a fifth of the lower half sphere.
  kSquareCorners,
  /// Everything that is not sky, by the lobe's integral.
  kWhole,
};

struct FisheyeMeansOptions {
  double shininess = 1;  ///< in [0, 1e4]: lobes narrower than a pixel have no mean on its grid
  Rgb ground = {};
  FisheyeWeights weights = FisheyeWeights::kSolidAngle;
  FisheyeGround ground_by = FisheyeGround::kWhole;
};

/// The mean around each of these unit directions, below the horizon too. Where a square's corners are all too far from
/// the lobe to count, the ground. Direct sums: O(pixels * directions). The same bits for any number of threads.
///
/// All choices but (kSolidAngle, kWhole) take equidistant lenses of 180 degrees only: Error{kUsage} for others, for a
/// layout that is no fisheye and for a shininess outside of its range. Throws Error{kCancelled}.
std::vector<RgbD> fisheye_means(const Environment& photograph, const FisheyeMeansOptions&, std::span<const Vec3> toward,
                                const Run& = {});

}  // namespace zonal
