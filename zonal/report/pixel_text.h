#pragma once

#include <string_view>

#include "zonal/image/tonemap.h"

namespace zonal {

// A tiny font for legends inside pictures: capitals and figures of 3 x 5 dots, each `dot` pixels wide.

/// How wide a word is, in pixels; letters stand one dot apart.
int pixel_text_width(std::string_view word, int dot);
inline constexpr int kPixelTextDots = 5;  ///< high

/// Draws a word with its top left corner at (x, y); what does not fit into the picture is cut off. Small letters are
/// drawn as capitals; what is none of 0-9, A-Z and "/.%-" as a space.
void draw_pixel_text(Image<Rgb8>&, int x, int y, std::string_view word, int dot, Rgb8 ink);

}  // namespace zonal
