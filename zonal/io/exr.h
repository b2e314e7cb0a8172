#pragma once

#include <optional>

#include "zonal/io/picture.h"

namespace zonal {

/// OpenEXR: scanlines and tiles (of mip and rip maps the largest level), half, float and integer channels, every
/// compression, one or many parts (the first flat one with colour or luminance), channels in a layer, luminance-chroma.
/// The pixels of the data window are read: environment maps are defined on it. Colour is left as stored: neither
/// divided by alpha nor converted from other primaries; notes say where that matters. Rows are decoded in blocks, on
/// the threads of `run`. nullopt: not this format. Throws Error{kInput}: broken, truncated, unfinished, too large,
/// deep, without colour; Error{kCancelled}.
std::optional<Picture> load_exr(ByteReader&, const LoadOptions&, const Run&);

/// Writes one ZIP-compressed part of R, G, B as float (bit-exact) or half; with half, values beyond 65504 are clipped
/// and counted.
SaveReport write_exr(const Image<Rgb>&, OutputFile&, const SaveOptions&);

}  // namespace zonal
