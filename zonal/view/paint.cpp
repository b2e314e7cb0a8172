#include "zonal/view/paint.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"

namespace zonal {

double brush_cover(double distance, double radius) {
  const double inside = 1 - distance * distance / (radius * radius);
  return inside > 0 ? inside * inside : 0;
}

Stroke::Stroke(Image<Rgb> before, const Brush& brush)
    : before_(std::move(before)), picture_(before_), covered_(before_.width(), before_.height()), brush_(brush) {
  check(before_.width() == before_.height() && brush.radius > 0,
        "a stroke of a brush with a size over a square picture");
}

void Stroke::move_to(double u, double v) {
  const Point from = last_.value_or(Point{u, v});
  last_ = {u, v};
  const int px = picture_.width();
  const double du = u - from.u, dv = v - from.v, square = du * du + dv * dv;
  const auto first = [&](double a, double b) {
    return static_cast<int>(std::clamp(std::floor((std::min(a, b) - brush_.radius) * px), 0.0, 1.0 * px));
  };
  const auto end = [&](double a, double b) {
    return static_cast<int>(std::clamp(std::ceil((std::max(a, b) + brush_.radius) * px), 0.0, 1.0 * px));
  };
  for (int y = first(from.v, v); y < end(from.v, v); ++y) {
    for (int x = first(from.u, u); x < end(from.u, u); ++x) {
      const double to_u = (x + 0.5) / px - from.u, to_v = (y + 0.5) / px - from.v;
      const double part = square > 0 ? std::clamp((to_u * du + to_v * dv) / square, 0.0, 1.0) : 0;
      const double cover = brush_cover(std::hypot(to_u - part * du, to_v - part * dv), brush_.radius);
      if (cover <= covered_(x, y)) continue;
      covered_(x, y) = static_cast<float>(cover);
      picture_(x, y) = Rgb((1 - cover) * RgbD(before_(x, y)) + cover * RgbD(brush_.light));
    }
  }
}

}  // namespace zonal
