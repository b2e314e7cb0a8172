#pragma once

#include <cmath>

#include "zonal/math/vec.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// Where a picture's charts are smooth enough for a cubic through 4 x 4 texels. Elsewhere weights are solved from the
/// texels' directions (sample_solve.h).
class SmoothCharts {
 public:
  SmoothCharts(const Projection&, ImageSize);

  /// Whether the 4 x 4 texels around a direction at `p` qualify. `map` is what Mapping::visit() gives.
  template <class Map>
  bool hold_around(const Map& map, Vec3 toward, PixelPoint p) const {
    const int margin = std::abs(toward.z) > cos_pole_ ? pole_margin_ : margin_;
    const int x = static_cast<int>(std::floor(p.x - 0.5)), y = static_cast<int>(std::floor(p.y - 0.5));
    return map.regular(map.chart(p), x - margin, y - margin, 2 * margin + 2);
  }

 private:
  int margin_ = 1;  ///< texels around the inner four that must be regular too
  int pole_margin_ = 1;
  double cos_pole_ = 2;  ///< no direction is nearer to a pole than this
};

}  // namespace zonal
