#pragma once

#include <span>

#include "zonal/image/image.h"
#include "zonal/image/tonemap.h"
#include "zonal/math/vec.h"

namespace zonal {

/// A place on the sphere to be seen in a picture: a circle of `half_angle` radians around it, and its number beside.
struct PanoramaMark {
  Vec3 direction;         ///< unit
  double half_angle = 0;  ///< radians, 0 to pi; circles too small to be seen are drawn larger
  int number = 0;         ///< >= 0
};

/// An equirectangular panorama of linear radiance as a picture for the screen (exposed so that its middle tones show),
/// with the marks on it. Circles are those of the sphere: curves near the poles, whole across the seam. Lines and
/// digits are bright with a dark border, so that they show on anything. Panoramas under 1024 pixels wide are enlarged
/// by whole numbers until they are not. Values that are not finite show as black. The panorama must not be empty.
/// O(pixels * marks).
Image<Rgb8> marked_panorama(const Image<Rgb>& panorama, std::span<const PanoramaMark>);

}  // namespace zonal
