#pragma once

#include "zonal/image/image.h"
#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

struct BasisShapeOptions {
  int size_px = 160;
  double azimuth_deg = 30, elevation_deg = 20;  ///< of the viewer, from +X toward +Y and above the horizon
  double reach = 0;  ///< the value that touches the picture's edge; 0: the largest size of the function
  Rgb paper = {};
};

/// A function as a distorted sphere: each direction's point lies as far from the centre as the function is large there,
/// red where it is positive and blue where it is negative. Seen from afar (orthographic) with +Z up, lit from the
/// viewer's upper left; linear light. Coefficients must be finite; a function that is zero everywhere shows nothing.
Image<Rgb> basis_shape(const Sh<double>&, const BasisShapeOptions& = {});

}  // namespace zonal
