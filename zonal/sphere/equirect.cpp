#include "zonal/sphere/equirect.h"

#include <algorithm>

namespace zonal {

double Equirect::solid_angle(int /*x*/, int y) const {
  // (2π/w)(cos θ_top - cos θ_bottom) as a product, which does not cancel near the poles. The row is counted from its
  // nearer pole, so that both halves have the same bits.
  const int row = std::min(y, size_.height - 1 - y);
  const double half_step = kPi / (2.0 * size_.height);
  return (4 * kPi / size_.width) * std::sin((2 * row + 1) * half_step) * std::sin(half_step);
}

Texel Equirect::nearest(Vec3 toward) const {
  const PixelPoint p = *position(toward);
  return {std::min(static_cast<int>(p.x), size_.width - 1), std::min(static_cast<int>(p.y), size_.height - 1)};
}

Texel Equirect::wrap(int /*chart*/, int x, int y) const {
  // Over a pole a meridian goes on half a turn away.
  if (y < 0 || y >= size_.height) {
    y = y < 0 ? -1 - y : 2 * size_.height - 1 - y;
    x += size_.width / 2;
  }
  x %= size_.width;
  return {x < 0 ? x + size_.width : x, std::clamp(y, 0, size_.height - 1)};
}

bool Equirect::regular(int /*chart*/, int /*x*/, int y, int size) const {
  // With an odd width the texel half a turn away lies half a texel beside the meridian.
  const bool within = y >= 0 && y + size <= size_.height;
  return within || (size_.width % 2 == 0 && size <= size_.height);
}

}  // namespace zonal
