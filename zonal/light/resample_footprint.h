#pragma once

#include "zonal/math/vec.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// How finely a target texel is cut so that its samples meet every source texel below it.
struct Footprint {
  int across = 1, down = 1;  ///< samples along the texel's sides
  bool cubic = true;         ///< source texels are about as large as target texels: curves between them matter
  bool shown = false;        ///< false: no texel that was looked at shows anything

  friend Footprint largest(const Footprint& a, const Footprint& b);
};

/// The footprint of a target texel over the source, from the sides of both texels. Where source texels are slivers
/// (near a panorama's poles) their side is taken as the root of their area, but at least a quarter of the longer side.
/// `supersample` > 0 overrides the count.
Footprint footprint(const Mapping& target, const Mapping& source, const Rotation& source_from_target, Texel,
                    int supersample);

}  // namespace zonal
