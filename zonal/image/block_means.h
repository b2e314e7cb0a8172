#pragma once

#include "zonal/image/image.h"

namespace zonal {

/// A smaller copy: every block of factor x factor texels as their mean, at the right and bottom edges of those that are
/// there. `factor` is 1 or more.
Image<Rgb> block_means(const Image<Rgb>&, int factor);

}  // namespace zonal
