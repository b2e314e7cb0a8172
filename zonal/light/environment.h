#pragma once

#include "zonal/image/image.h"
#include "zonal/sphere/projection.h"

namespace zonal {

/// All light that arrives at a point: linear, scene-referred radiance, and how the picture shows the sphere.
/// World frame: right-handed, +Z up, +X in the centre of a panorama.
struct Environment {
  Image<Rgb> radiance;
  Projection projection = {};
};

}  // namespace zonal
