#pragma once

#include "zonal/view/view_state.h"

namespace zonal {

/// The eye goes around the object as if the hand held the object: a drag over the whole height turns it by half a turn.
void orbit(OrbitCamera&, double dx_px, double dy_px, int height_px);
/// One step of a wheel toward the object is a tenth of the distance.
void zoom(OrbitCamera&, double steps);
/// The light follows the hand: a drag to the right over the whole width turns it by half a turn. In [-180, 180].
double dragged_light_yaw_deg(double yaw_deg, double dx_px, int width_px);
/// The same angle in [-180, 180].
double wrapped_deg(double angle_deg);

}  // namespace zonal
