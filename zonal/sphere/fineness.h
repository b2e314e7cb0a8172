#pragma once

#include "zonal/sphere/projection.h"

namespace zonal {

/// Six faces, however they lie.
bool is_cube(Layout);

/// The number of rows of a panorama that is about as fine as this picture.
int panorama_rows(const Projection&, ImageSize);

}  // namespace zonal
