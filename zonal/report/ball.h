#pragma once

#include <functional>

#include "zonal/image/image.h"
#include "zonal/math/vec.h"

namespace zonal {

/// How a ball shows a map.
enum class BallKind {
  kMirror,   ///< each point shows the map in the direction into which it reflects the viewer (prefiltered maps too)
  kDiffuse,  ///< each point shows the map in the direction of its normal (irradiance)
};

struct BallOptions {
  int size_px = 160;    ///< edge of the picture; the ball touches it
  int supersample = 1;  ///< samples along each side of a pixel; sharp maps need 3
};

/// Draws a ball in front of a far viewer (orthographic), lit by `light` (a value for a unit direction), linear. The
/// viewer stands on the +X side and looks toward -X, with +Z up and +Y to the right: what the panorama has in its
/// centre appears in the middle of the mirror, left and right exchanged as a mirror does. The picture is square: the
/// rim's values go on for two pixels outside the disc, so that whoever cuts the disc out gets a clean edge; beyond them
/// it is black.
Image<Rgb> draw_ball(const std::function<Rgb(Vec3)>& light, BallKind kind, const BallOptions& options = {});

}  // namespace zonal
