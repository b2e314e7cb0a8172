#pragma once

#include <array>

#include "zonal/base/run.h"
#include "zonal/image/image.h"
#include "zonal/light/environment.h"

namespace zonal {

/// Sizes of the maps of reflection space.
struct ReflectionSpaceOptions {
  std::array<double, 4> roughnesses = {0.3, 0.5, 0.7, 1};  ///< perceptual, of the layers; ascending in [0.2, 1]
  int views = 7;              ///< directions of the eye along each side of an octahedral square, its edges included
  int map_px = 14;            ///< texels along each side of a map
  int environment_rows = 32;  ///< of the panorama that is summed over
};

/// What a rough GGX surface mirrors, for a few directions of the eye (Cabral, Olano & Nemec 1999, whose maps are made
/// for one eye each, warped to the actual one and blended). A layer for each roughness, one below the other; in a layer
/// views x views tiles, tile (i, j) for the eye at (i, j)/(views - 1) of an octahedral square, and in a tile texel (x,
/// y) for the mean direction m of the lobe at (x, y)/(map_px - 1) of another. So neither blending nor filtering leaves
/// the square. A texel is the light through the lobe as this eye sees it, leaning and stretched toward grazing angles,
/// with the normal that makes m its mean direction (light/lobe_lean.h), over the light through the lobe of an eye above
/// the surface, n = v = m, which the split sum's map of the same roughness has: a colour near 1, to multiply that map
/// by. How much is reflected (Fresnel and masking) is left to the split sum's table.
///
/// Measured in the viewer against the exact sum, RMS over a ball in light with hard edges: off by 9 % at roughness 0.3,
/// 6 at 0.5 and 0.6, 3 at 0.7, 2.4 at 1 (split sum: 13 to 17 %). By numerical experiment in a sunset and a city, eyes
/// alone (49 of them) cost 1 to 3 %, where maps indexed by the mirrored direction lost 4 to 6 % with 81; texels of 13
/// degrees cost 5 to 10 % as light and under 2 % as quotients; between two layers it is 2 to 4 %.
///
/// Where a small lamp or the sun holds most of the light, texels are wider than what they show. In a studio, a
/// city, a sunset, a quarry in the sun and a modelled clear day it is off by 10 to 48 % at roughness 0.5 (split sum:
/// 24 to 76), 5 to 25 at 0.7 (31 to 125) and 4 to 15 at 1 (42 to 202); at 0.3 by 26 to 82 %, no better than the split
/// sum.
///
/// Sums over all texels, no random numbers: O(layers views² map_px² texels), 0.3 s of processor and 150 kB with shared
/// exponents as the options are. Quotients above kMostQuotient become that. Where the eye grazes (n.v below 0.05) the
/// texel is that of 0.05. Throws Error{kUsage} outside the domain, Error{kCancelled}.
Image<Rgb> reflection_space_maps(const Environment&, const ReflectionSpaceOptions& = {}, const Run& = {});
inline constexpr float kMostQuotient = 16;

/// LobeLean::lean in radians, red: columns n.v from 0 to 1, rows perceptual roughness from 0 (0.01 in its place) to 1.
Image<Rgb> lean_picture();

}  // namespace zonal
