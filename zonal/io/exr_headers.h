#pragma once

#include "zonal/io/picture.h"

namespace zonal {

/// By its first four bytes; the reader is at the start afterwards.
bool is_exr(ByteReader&);

/// Walks the headers of an OpenEXR file and throws Error{kInput} where a number in them would make a reader take memory
/// that the file or the options cannot justify. OpenEXR itself allocates by those numbers before it shows them.
void check_exr_headers(ByteReader&, const LoadOptions&);

}  // namespace zonal
