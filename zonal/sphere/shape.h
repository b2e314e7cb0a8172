#pragma once

#include <string>

#include "zonal/sphere/projection.h"

namespace zonal {

/// What sizes a layout can have, as the beginning of a sentence.
std::string shape_in_words(Layout);

/// A size that fits the layout, of about as many texels as `size`.
ImageSize nearest_size(Layout, ImageSize size);

}  // namespace zonal
