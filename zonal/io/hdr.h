#pragma once

#include <optional>

#include "zonal/io/picture.h"

namespace zonal {

/// Radiance HDR (Ward 1991, "Real Pixels"; file format as in the Radiance manual, picture(5)): rows flat, in the old or
/// in the new run-length code; all eight orientations; EXPOSURE and COLORCORR divided out. A channel is m * 2^(e - 136)
/// for mantissa m and exponent byte e > 0, without Radiance's own half step, as nearly every other program reads it:
/// 128, 128, 128, 129 is exactly 1. nullopt: not this format. Throws Error{kInput}: broken, truncated, too large, or
/// XYZE.
std::optional<Picture> load_hdr(ByteReader&, const LoadOptions&, const Run&);

/// Writes new run-length code, each channel rounded to the nearest step of the shared exponent (half a step is at most
/// 1/256 of the largest channel). Negative values and NaN become 0 and values above the largest exponent the largest:
/// both are counted.
SaveReport write_hdr(const Image<Rgb>&, OutputFile&, const SaveOptions&);

}  // namespace zonal
