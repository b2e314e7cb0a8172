#pragma once

#include <cstdint>

#include "zonal/image/image.h"
#include "zonal/math/vec.h"

namespace zonal {

/// A display pixel, sRGB-encoded.
struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb8&) const = default;
};

/// How radiance becomes a picture. Radiance 2^-exposure_ev is middle of the curve's straight part; `white` (after
/// exposure) is the smallest luminance shown as full white.
struct Tonemap {
  double exposure_ev = 0;  ///< factor 2^ev
  double white = 8;        ///< > 0
};

/// The extended curve of Reinhard et al. 2002 (eq. 4), L (1 + L/white²) / (1 + L), on luminance; colours brighter than
/// the display move toward grey of their luminance until they fit, so hues stay. Negative and NaN channels show as 0.
Rgb8 tonemap(Rgb radiance, const Tonemap&);
Image<Rgb8> tonemap(const Image<Rgb>& radiance, const Tonemap&);

/// The exposure that puts the log-mean luminance of the texels brighter than black at 0.18 (same paper, eq. 1). 0 when
/// all is black.
double auto_exposure_ev(const Image<Rgb>& radiance);

/// A colour for a value in 0..1 (clamped; NaN is magenta), from black over blue, red, yellow to white. Computed so that
/// CIE lightness L* is proportional to the value: equal steps look equal, also in grey.
Rgb8 false_color(double value);
Image<Rgb8> false_color(const Image<float>& values, double full_scale);

}  // namespace zonal
