#pragma once

#include <optional>

#include "zonal/io/picture.h"

namespace zonal {

/// Truevision TGA 1 and 2: palette, true colour and grey, plain and run-length coded (types 1, 2, 3, 9, 10, 11), 8 to
/// 32 bits, all four origins. The format has no magic number: its 18 header bytes must make sense together, so it is
/// asked last. nullopt: not this format. Throws Error{kInput}: truncated, too large.
std::optional<Picture> load_tga(ByteReader&, const LoadOptions&, const Run&);

}  // namespace zonal
