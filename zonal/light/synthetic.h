#pragma once

#include <functional>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/math/vec.h"
#include "zonal/sphere/projection.h"

namespace zonal {

/// Built-in environments, in any projection. Texels that show nothing are black; a texel whose centre shows nothing but
/// whose area does takes the mean of what it shows. Throw Error{kInput} when the size does not fit the projection.

/// A function of direction as a picture: the mean of supersample² points inside each texel (1: its centre).
Environment paint(const Projection&, ImageSize, const std::function<Rgb(Vec3 toward)>& radiance, int supersample = 1,
                  const Run& = {});

/// The same radiance from everywhere.
Environment furnace(const Projection&, ImageSize, Rgb radiance = {1, 1, 1});

/// The linear sky 1 + x + y/2, grey: three SH coefficients hold it exactly.
Environment gradient(const Projection&, ImageSize);

struct SunOptions {
  Vec3 toward_sun = {0.6, 0, 0.8};  ///< unit
  double diameter_deg = 0.53;       ///< (0, 180]
  Rgb sky = {1, 1, 1};              ///< radiance everywhere outside the disc
  double contrast = 1e5;            ///< radiance of the disc relative to the sky
};
/// A uniform disc in a uniform sky. The disc's energy over the picture is exactly its radiance times its solid angle
/// (what is added over the sky sums to (contrast - 1) * sky * 2π(1 - cos radius)), at any size, also under one texel.
Environment sun(const Projection&, ImageSize, const SunOptions& = {}, const Run& = {});

/// Squares of `step_deg` in longitude and latitude, alternately black and `white`; anti-aliased.
Environment checker(const Projection&, ImageSize, double step_deg = 15, Rgb white = {1, 1, 1}, const Run& = {});

/// Labelled axes: each sixth of the sphere has its colour and its name (+X, -X, +Y, ...) upright for a viewer at the
/// origin, over a grid of 15 degrees. Values in 0..1. Mirrored, flipped or turned pictures are seen at a glance.
Environment testcard(const Projection&, ImageSize, const Run& = {});

struct DaylightOptions {
  double elevation_deg = 35;                 ///< of the sun, (0, 90]
  double azimuth_deg = 0;                    ///< of the sun, from +X toward +Y
  double turbidity = 3;                      ///< haze: 2 very clear .. 10 hazy
  Rgb ground_albedo = {0.2f, 0.18f, 0.15f};  ///< of the level Lambertian ground below the horizon
  bool sun = true;                           ///< include the sun's disc
};
/// Clear sky, sun disc and lit ground after Preetham, Shirley & Smits 1999, radiance as linear Rec. 709 in kcd/m²
/// (luminance(rgb) is the luminance in thousand candela per square metre: zenith about 1..10, the sun about 1e6).
/// Throws Error{kUsage} when the sun is not above the horizon or the turbidity is outside 2..10.
Environment daylight_sky(const Projection&, ImageSize, const DaylightOptions& = {}, const Run& = {});

}  // namespace zonal
