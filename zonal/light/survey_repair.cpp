#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "zonal/light/survey.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

bool is_finite(Rgb c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

/// Of the finite ones among the eight texels around, over every seam of the picture; black when there are none.
Rgb neighbours_mean(const Environment& e, const Mapping& mapping, Texel t) {
  RgbD sum;
  int count = 0;
  const int chart = mapping.chart(center_of(t));
  for (int k = 0; k < 9; ++k) {
    const Texel n = mapping.wrap(chart, t.x + k % 3 - 1, t.y + k / 3 - 1);
    const Rgb c = e.radiance(n.x, n.y);
    if (n == t || !is_finite(c)) continue;
    sum += RgbD(c);
    ++count;
  }
  return count > 0 ? Rgb((1.0 / count) * sum) : Rgb{};
}

}  // namespace

Repairs repair(Environment& e) {
  const Mapping mapping(e.projection, {e.radiance.width(), e.radiance.height()});
  Repairs repairs;
  std::vector<std::pair<Texel, Rgb>> replaced;  // applied at the end, so that the order of texels does not matter
  for (int y = 0; y < e.radiance.height(); ++y) {
    for (int x = 0; x < e.radiance.width(); ++x) {
      Rgb& c = e.radiance(x, y);
      if (!is_finite(c)) {
        replaced.emplace_back(Texel{x, y}, mapping.texel_direction(x, y) ? neighbours_mean(e, mapping, {x, y}) : Rgb{});
      } else if (c.r < 0 || c.g < 0 || c.b < 0) {
        ++repairs.negative;
      }
    }
  }
  for (const auto& [t, radiance] : replaced) e.radiance(t.x, t.y) = radiance;
  repairs.non_finite = static_cast<std::int64_t>(replaced.size());
  for (Rgb& c : e.radiance.values()) c = {std::max(c.r, 0.0f), std::max(c.g, 0.0f), std::max(c.b, 0.0f)};
  return repairs;
}

}  // namespace zonal
