#pragma once

#include <span>
#include <string>

#include "zonal/image/merge_exposures.h"
#include "zonal/image/tonemap.h"

namespace zonal {

/// An exposure time as photographers write it: "1/250 s", "0.6 s", "8 s"; three significant digits.
std::string exposure_words(double seconds);

/// Which exposure each texel of a merge mostly comes from, as a picture with its legend below: an exposure's colour
/// (from yellow, the shortest, over red to dark blue, the longest), its name and its share. Saturated texels are white,
/// black ones black, conflicting ones magenta, those without data grey. `names`: one for each exposure, of digits,
/// capitals and
/// "/.%-"; other letters are drawn as spaces.
Image<Rgb8> exposure_map(const Merge&, std::span<const std::string> names);

}  // namespace zonal
