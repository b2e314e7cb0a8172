#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"

namespace zonal {

// The maps that Tokoi's program makes ("Irradiance mapping (2)", 2015), as it makes them: docs/notes/fisheye.md says
// what is wrong with them. The photograph's values are averaged as they are; the program is given the codes of its
// file.

/// What a paraboloid map shows outside of its circle, below the horizon.
enum class FisheyeOutside {
  kGround,    ///< the ground's colour: as published
  kExtended,  ///< means like all others: the formula of the direction holds to the corners, 109.5 degrees from the
              ///< zenith
  kTwo,       ///< a second map for the lower half beside the first, 2:1; outside of the circles as kExtended
};

struct PublishedOptions {
  double shininess = 1;
  Rgb ground = {};
  int size_px = 128;  ///< of a map's edge, 2 or more
  FisheyeOutside outside = FisheyeOutside::kGround;
  /// Results are cut to 8 bits: rounded, but the ground outside of the circle cut off. For values in 0..1.
  bool grey_levels = false;
};

/// Directions of a paraboloid map's pixels, row by row, as published: u = x/(size - 1) - 1/2, v = 1/2 - y/(size - 1),
/// as if the outermost pixels' centres lay on the map's edge. The circle's centre is the zenith; right and up are those
/// of the photograph. `lower`: of the second map, around the nadir with the same right and up (Heidrich & Seidel 1998).
std::vector<Vec3> published_paraboloid_directions(int size_px, bool lower = false);

/// The program of the article: a mean over the square around the photograph's circle for each pixel of a paraboloid
/// map. The article's centre (xc, yc) is that of a pixel: a Lens's centre is (xc + 1/2, yc + 1/2). O(pixels * texels).
/// Throws as fisheye_means() does.
Image<Rgb> published_paraboloid(const Environment& photograph, const PublishedOptions&, const Run& = {});

/// Its first version, with which the maps were made that its author published with it: an equidistant map like the
/// photograph, and means over a square of the photograph's size that moves with the pixel. Outside of the circle the
/// ground; `outside` is not used. There the circle's centre is the picture's and its radius half the width less half a
/// pixel.
Image<Rgb> first_published_disc(const Environment& photograph, const PublishedOptions&, const Run& = {});

/// What OpenGL reads from a published paraboloid map (with kTwo: a pair) in each direction of another picture: texel
/// centres at (x + 1/2)/size, linear between them, the ground as border colour; of a pair the edge goes on, for its
/// maps meet at the circles, which touch the squares' edges.
Environment read_paraboloid(const Image<Rgb>& map, Rgb ground, const Projection&, ImageSize);

}  // namespace zonal
