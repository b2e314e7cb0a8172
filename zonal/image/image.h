#pragma once

#include "zonal/base/grid.h"
#include "zonal/math/vec.h"

namespace zonal {

/// A picture is a grid; texel (x, y) is centred at (x + 1/2, y + 1/2), the top row is y = 0.
template <class T>
using Image = Grid<T>;

}  // namespace zonal
