#pragma once

#include <functional>

#include "zonal/image/image.h"
#include "zonal/math/vec.h"

namespace zonal {

struct UnfoldedCubeOptions {
  int face_px = 48;
  double full_scale = 0;  ///< the size of a value in full colour; 0: the largest on the cube
  int steps = 5;          ///< a line at each multiple of full_scale/steps between the full scales, zero included
  Rgb paper = {};         ///< where the cross shows no face
};

/// A function on the sphere as a cube that is cut open (kCubeCross), 4 x 3 faces of pixels in linear light: red where
/// it is positive, blue where it is negative, green at zero, white lines of equal value at even steps, so that they
/// lie closer where the function changes faster. f must be finite.
Image<Rgb> unfolded_cube(const std::function<double(Vec3 toward)>& f, const UnfoldedCubeOptions& = {});

/// The colour of a value in -1..1 (clamped), linear light: blue, green at zero, red.
Rgb signed_color(double value);

}  // namespace zonal
