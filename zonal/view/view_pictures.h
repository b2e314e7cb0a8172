#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/image.h"
#include "zonal/light/environment.h"
#include "zonal/math/vec.h"

namespace zonal {

// Pictures that the shaders look light up in, beside those that other verbs make.

/// The picture and its halvings down to one row, each texel the mean of the four (or two) under it.
std::vector<Image<Rgb>> halved_pictures(Image<Rgb>);

/// A sphere map without black outside the ball, where filtering would drag it in: the rim's light goes on.
Image<Rgb> sphere_map_picture(const Environment&, int size_px, const Run&);

/// Front and back paraboloid side by side; their corners show what a paraboloid of more than a hemisphere would.
Image<Rgb> dual_paraboloid_picture(const Environment&, int size_px, const Run&);

/// Bumps that tile: red and green are x and y of the tangent-space normal (along the texture coordinates, v downward),
/// halved and shifted to 0..1; blue is the height, 0..1, a whole of which is kBumpHeight widths of the tile.
Image<Rgb> bump_picture(int size_px);
inline constexpr double kBumpHeight = 1.25 / (2 * kPi);
inline constexpr int kBumpPx = 64;  ///< of view_data

/// Row by row from no window to the strongest: red, green and blue of six texels hold the factors of bands 0..2 and
/// 3..5 of the Hann, the Lanczos and the Laplacian window.
Image<Rgb> window_picture();

/// A highlight on a ball in the eye's frame (right, up, toward the eye), by (n.h)^40, ten times `light` at its peak.
Image<Rgb> highlight_picture(int size_px, RgbD light);

/// A highlight as somebody might draw it: a window of four panes at the upper left, bent like the ball, and its faint
/// reflection at the lower right. Three times `light` at its brightest.
Image<Rgb> drawn_highlight(int size_px, RgbD light);

}  // namespace zonal
