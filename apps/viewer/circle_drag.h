#pragma once

#include "zonal/sphere/disc.h"
#include "zonal/sphere/projection.h"

namespace zonal {

// A fisheye photograph's circle under a pointer. Everything in the picture's pixels, (0, 0) its top left corner.

/// What of a circle a pointer has hold of: its middle, or the end of one of its radii.
enum class CircleHandle { kNone, kCenter, kRight, kLeft, kTop, kBottom };

/// Where a handle is; the centre for kNone.
PixelPoint place_of(const PixelCircle&, CircleHandle);

/// The nearest handle within `reach_px`; the centre everywhere else inside of the circle; else none.
CircleHandle handle_at(const PixelCircle&, PixelPoint, double reach_px);

/// The circle that a drag by (dx, dy) makes of the one that it began with: its centre moves, or one radius grows, the
/// centre staying; a `round` circle's other radius becomes the same. Within the limits of limited_circle().
PixelCircle dragged_circle(const PixelCircle& before, CircleHandle, double dx, double dy, bool round,
                           ImageSize picture);

/// The nearest circle that a lens can have drawn in a picture: the centre on it, half a pixel at least from its edge;
/// the radii from one pixel to the picture's longer edge.
PixelCircle limited_circle(PixelCircle, ImageSize picture);

}  // namespace zonal
