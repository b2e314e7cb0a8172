#pragma once

#include <optional>

#include "zonal/image/align_grey.h"

namespace zonal {

/// The shift of `moving` against `fixed`, pictures of one size, to about two texels of pictures halved until their
/// shorter side is 32 to 63: the beginning of an alignment. Median threshold bitmaps (Ward 2003): both are cut at the
/// same percentile of their own brightness, which does not depend on the exposure; texels near the threshold do not
/// count; the shift, up to `largest_shift_px`, with the smallest share of different bits is taken. Ward cuts at the
/// median (here also at other percentiles, where the median is black or white), looks one texel around at that level,
/// and goes on to finer ones. nullopt: all black or all white, there is nothing to compare.
std::optional<Shift> align_bitmaps(const Grey& fixed, const Grey& moving, int largest_shift_px);

/// How often a picture is halved until its shorter side is under twice `smallest_side`.
int halvings(int width, int height, int smallest_side);
inline constexpr int kCoarsestSide = 32;

}  // namespace zonal
