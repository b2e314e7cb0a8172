#pragma once

#include <array>
#include <vector>

#include "zonal/image/align_grey.h"
#include "zonal/image/exposures.h"

namespace zonal {

/// A photograph's codes through a table, smoothed (1 2 1 along both axes: differences between texels are taken of it),
/// and its halves, the fine one first. NaN where something that went into a texel has no data: outside, or missing.
std::vector<Image<float>> align_pyramid(const Grey&, const Image<std::uint8_t>& missing,
                                        const std::array<float, kGreyLevels>& table, int halvings);

/// The value at a point (texel centres at halves) by a straight line along both axes; NaN near what has no data.
inline float value_at(const Image<float>& image, PicturePoint p) {
  const double x = p.x - 0.5, y = p.y - 0.5;
  if (!(x >= 0 && y >= 0 && x < image.width() - 1 && y < image.height() - 1)) return kNoCode;
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
  const float* upper = image.row(y0).data() + x0;
  const float* lower = image.row(y0 + 1).data() + x0;
  const float top = upper[0] + fx * (upper[1] - upper[0]), bottom = lower[0] + fx * (lower[1] - lower[0]);
  return top + fy * (bottom - top);
}

}  // namespace zonal
