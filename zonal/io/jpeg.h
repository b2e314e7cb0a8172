#pragma once

#include <optional>

#include "zonal/io/picture.h"

namespace zonal {

/// JPEG, grey or colour, baseline or progressive. Taken as sRGB unless the options say linear. nullopt: not this
/// format. Throws Error{kInput}: broken, truncated, too large, CMYK.
std::optional<Picture> load_jpeg(ByteReader&, const LoadOptions&, const Run&);

}  // namespace zonal
