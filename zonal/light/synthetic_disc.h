#pragma once

#include "zonal/light/environment.h"
#include "zonal/math/vec.h"

namespace zonal {

/// Adds a uniform disc of light. Each texel gets the part of it that the disc covers; the parts along the edge are
/// scaled so that the light added over the picture is exactly radiance * 2π(1 - cos radius) where the picture shows all
/// of the disc.
void add_disc(Environment&, Vec3 center, double radius, RgbD radiance);

}  // namespace zonal
