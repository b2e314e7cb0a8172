#pragma once

#include "zonal/math/vec.h"

namespace zonal {

/// A turn of the world in the order a photographer thinks: first roll about the view axis +X, then pitch (up is
/// positive), then yaw about the vertical (to the left, from +X toward +Y, is positive). Degrees. Multiples of 90 are
/// exact.
Rotation turned(double yaw_deg, double pitch_deg = 0, double roll_deg = 0);

/// The angles of turned(), in degrees.
struct Turn {
  double yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
  bool operator==(const Turn&) const = default;
};
inline Rotation turned(const Turn& turn) { return turned(turn.yaw_deg, turn.pitch_deg, turn.roll_deg); }

/// The angles that turned() makes this rotation of: pitch in [-90, 90], the others in [-180, 180]. Where +X is turned
/// straight up or down, yaw and roll are about one axis: all of it is yaw then.
Turn turn_of(const Rotation&);

}  // namespace zonal
