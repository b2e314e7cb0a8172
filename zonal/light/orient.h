#pragma once

#include "zonal/math/vec.h"

namespace zonal {

/// A turn of the world in the order a photographer thinks: first roll about the view axis +X, then pitch (up is
/// positive), then yaw about the vertical (to the left, from +X toward +Y, is positive). Degrees. Multiples of 90 are
/// exact.
Rotation turned(double yaw_deg, double pitch_deg = 0, double roll_deg = 0);

}  // namespace zonal
