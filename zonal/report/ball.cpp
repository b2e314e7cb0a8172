#include "zonal/report/ball.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"

namespace zonal {
namespace {

/// The map's direction shown at (right, up), both in units of the ball's radius. Points outside count as on the rim.
Vec3 shown_direction(BallKind kind, double right, double up) {
  const double radius = std::hypot(right, up);
  if (radius > 1) {
    right /= radius;
    up /= radius;
  }
  const Vec3 normal = {std::sqrt(std::max(0.0, 1 - right * right - up * up)), right, up};
  if (kind == BallKind::kDiffuse) return normal;
  const Vec3 toward_viewer = {1, 0, 0};
  return normalize(2 * dot(normal, toward_viewer) * normal - toward_viewer);
}

}  // namespace

Image<Rgb> draw_ball(const std::function<Rgb(Vec3)>& light, BallKind kind, const BallOptions& options) {
  check(options.size_px > 0 && options.supersample > 0, "a ball needs a positive size and at least one sample");
  const int size = options.size_px, n = options.supersample;
  const double radius = size / 2.0, margin_px = 2;
  Image<Rgb> ball(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (std::hypot(x + 0.5 - radius, y + 0.5 - radius) > radius + margin_px) continue;
      RgbD sum;
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          const double right = (x + (i + 0.5) / n) / radius - 1;
          const double up = 1 - (y + (j + 0.5) / n) / radius;
          sum += RgbD(light(shown_direction(kind, right, up)));
        }
      }
      ball(x, y) = Rgb((1.0 / (n * n)) * sum);
    }
  }
  return ball;
}

}  // namespace zonal
