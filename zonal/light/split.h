#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/math/vec.h"

namespace zonal {

/// A compact bright source that was taken out of a picture: a uniform disc far away.
struct SplitLight {
  Vec3 direction;         ///< unit, of its vector irradiance in luminance (the centroid of its energy)
  double half_angle = 0;  ///< radians, of the disc of its greatest luminance that holds its energy; at most pi
  RgbD irradiance;        ///< on a receiver that faces it
  RgbD energy;            ///< integral of the radiance taken out over solid angle
  double share = 0;       ///< of the whole picture's energy in luminance
  /// The disc is so large that a texel lies wholly inside. If not, half_angle is an upper bound: a source smaller than
  /// the texels cannot be measured better than they.
  bool resolved = false;
};

struct SplitOptions {
  int max_lights = 8;         ///< the strongest; >= 0
  double threshold = 16;      ///< a source is brighter than so many times the mean luminance of the rest; >= 1
  double min_share = 0.005;   ///< a source has at least this share of the energy; 0..1
  double max_size_sr = 0.06;  ///< a source is at most so large, and no wider than such a disc (half angle 7.9 degrees)
};

/// A sum over the sphere, by exact texel solid angles at the texels' directions.
struct SphereSum {
  RgbD energy;                 ///< integral of the radiance
  std::array<Vec3, 3> vector;  ///< integral of the radiance times direction, in r, g and b
};

/// What was there, and what there is now. The lights count with their energy, and with their irradiance along their
/// direction.
struct SplitBalance {
  SphereSum whole, lights, rest;

  /// The largest difference of any channel between the whole and lights plus rest, over the whole's energy in that
  /// channel (where that is not positive, over the luminance's).
  double energy_difference() const;
  /// The same for the vector irradiance in luminance: the lights' directions are exact for it.
  double vector_difference() const;
  /// The largest of any channel: lights whose colours differ across them have one direction only.
  double vector_difference_rgb() const;
};

struct SplitEnvironment {
  Environment rest;                ///< the picture without the lights; the same bits outside of them
  std::vector<SplitLight> lights;  ///< the strongest first, by energy in luminance
  SplitBalance balance;
  double threshold_luminance = 0;  ///< what sources are brighter than
  int sources = 0;                 ///< how many there were to choose from, also beyond max_lights
  double range_before = 0;         ///< greatest luminance over the mean, of the whole
  double range_after = 0;          ///< and of the rest; both 0 for a black picture
  std::int64_t changed_texels = 0;
};

/// Takes the sun and other compact bright sources out of a picture, in its own projection, across all its seams.
///
/// A source is a connected set of texels brighter than the threshold and no larger than max_size_sr (the components of
/// level sets under a size, as in the area opening of Vincent 1993). Where it stands in something larger that is bright
/// too, its peak must be 4 times as bright as that, and what is twice as bright is taken. Two peaks are two sources
/// where the saddle between them is under a quarter of the lower one. The threshold is a multiple of the mean of the
/// texels that are under it themselves, the largest for which that holds, so that the sun does not raise it.
///
/// The texels of a source, and those around it that its edge or the ringing of a resampler beside it has touched, are
/// filled from the rim around: each with the mean of the rim weighted by solid angle over squared distance. On a
/// disc that is Poisson's integral, the solution of Laplace's equation (a membrane spanned by the rim); on any shape it
/// stays between the rim's least and greatest values in each channel. The light is the excess of what was there over
/// the fill, so that lights and rest add up to the whole to the rounding of the rest to floats.
///
/// A picture without such sources (a constant one, a black one) has no lights and comes back with the same bits.
/// Negative radiance stays where no source is and counts in every sum; it counts as 0 for the threshold. A channel in
/// which the excess of a source is not positive stays in the picture as it is.
///
/// The same bits for any number of threads. O(texels), and O(n m) for a source of n texels with a rim of m. Memory: the
/// picture and what is brighter than the threshold. Throws Error{kInput} when a value is not finite or the size does
/// not fit the projection, Error{kUsage} for options out of range, Error{kCancelled}.
SplitEnvironment split_lights(Environment, const SplitOptions& = {}, const Run& = {});

}  // namespace zonal
