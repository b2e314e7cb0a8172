#pragma once

#include <optional>

#include "zonal/io/picture.h"

namespace zonal {

/// Portable float map (Debevec): "PF" colour or "Pf" grey, bottom row first, little-endian for a negative scale and
/// big-endian for a positive one; values are multiplied by |scale|. nullopt: not this format. Throws Error{kInput}:
/// broken, truncated, too large.
std::optional<Picture> load_pfm(ByteReader&, const LoadOptions&, const Run&);

/// Writes "PF", little-endian, scale 1: bit-exact.
SaveReport write_pfm(const Image<Rgb>&, OutputFile&, const SaveOptions&);

}  // namespace zonal
