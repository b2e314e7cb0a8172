#include "zonal/sphere/fineness.h"

#include <algorithm>
#include <cmath>

namespace zonal {

bool is_cube(Layout layout) { return name_of(layout).starts_with("cube"); }

int panorama_rows(const Projection& projection, ImageSize size) {
  const int natural = natural_size(projection, size).value_or(size.height);
  if (is_cube(projection.layout)) return 2 * natural;
  const bool fisheye = projection.layout == Layout::kFisheye || projection.layout == Layout::kDualFisheye;
  if (!fisheye) return natural;
  return std::max(1, static_cast<int>(std::lround(natural * 180 / projection.lens.fov_deg)));
}

}  // namespace zonal
