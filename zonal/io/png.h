#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "zonal/image/tonemap.h"
#include "zonal/io/picture.h"

namespace zonal {

/// PNG of every colour type and depth, interlaced or not. Taken as sRGB unless the options or the file (gAMA of 1) say
/// linear; other gAMA values and colour profiles are not applied, and a note says so. nullopt: not this format. Throws
/// Error{kInput}: broken, truncated, too large.
std::optional<Picture> load_png(ByteReader&, const LoadOptions&, const Run&);

/// Writes 8 or 16 bits a channel, rounded to nearest; values outside 0..1 and NaN are clipped and counted.
SaveReport write_png(const Image<Rgb>&, OutputFile&, const SaveOptions&);

/// A picture for the screen as the bytes of a PNG file.
std::vector<std::byte> encode_png(const Image<Rgb8>&);

}  // namespace zonal
