#pragma once

#include "zonal/light/orient.h"
#include "zonal/sphere/projection.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// The eye goes around the object as if the hand held the object: a drag over the whole height turns it by half a turn.
void orbit(OrbitCamera&, double dx_px, double dy_px, int height_px);
/// One step of a wheel toward the object is a tenth of the distance.
void zoom(OrbitCamera&, double steps);
/// What of the light is ahead of the eye follows the hand: a drag over the whole width turns it by half a turn about
/// the vertical, then one over the whole height by half a turn about the eye's own horizontal axis. To a thousandth of
/// a degree, so that settings stay short.
Turn dragged_light(const Turn&, const OrbitCamera&, double dx_px, double dy_px, ImageSize);
/// The same angle in [-180, 180].
double wrapped_deg(double angle_deg);

}  // namespace zonal
