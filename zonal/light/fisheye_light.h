#pragma once

#include <optional>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/convolve.h"
#include "zonal/light/environment.h"
#include "zonal/light/fisheye_published.h"

namespace zonal {

/// A paraboloid map of the half sphere around the zenith as this library has it: a stereographic fisheye that fills a
/// square, or (`extended`) whose corners are shown, too.
Projection sky_paraboloid(int size_px, bool extended);

/// The sky of a fisheye photograph over a ground of one colour, seen through Phong lobes: what the published program
/// computes, without its errors. The photograph becomes a panorama about as fine, and the lobes are zonal convolutions
/// with a bounded error. Any lens. Texel centres are those of Mapping.
class FisheyeLight {
 public:
  /// Throws Error{kUsage} for a layout that is no fisheye, Error{kInput} for values that are not finite,
  /// Error{kCancelled}.
  FisheyeLight(const Environment& photograph, Rgb ground, const std::vector<double>& shininess, FisheyeOutside outside,
               const Run& = {});

  /// The means around the texels' directions, for shininess[i].
  Convolved render(int i, const Projection&, ImageSize, const Run& = {}) const;
  /// As a paraboloid map laid out as the published ones are, with what the constructor was told outside of the circle.
  Image<Rgb> paraboloid(int i, int size_px, const Run& = {}) const;

 private:
  Rgb ground_;
  FisheyeOutside outside_;
  Convolution upright_;
  std::optional<Convolution> upside_down_;  // for the lower of two paraboloids: the nadir at the pole
};

}  // namespace zonal
