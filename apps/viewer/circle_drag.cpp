#include "apps/viewer/circle_drag.h"

#include <algorithm>
#include <cmath>

namespace zonal {

PixelPoint place_of(const PixelCircle& circle, CircleHandle handle) {
  const double x = circle.center_x, y = circle.center_y;
  switch (handle) {
    case CircleHandle::kRight:
      return {x + circle.radius_x, y};
    case CircleHandle::kLeft:
      return {x - circle.radius_x, y};
    case CircleHandle::kTop:
      return {x, y - circle.radius_y};
    case CircleHandle::kBottom:
      return {x, y + circle.radius_y};
    case CircleHandle::kNone:
    case CircleHandle::kCenter:
      break;
  }
  return {x, y};
}

CircleHandle handle_at(const PixelCircle& circle, PixelPoint at, double reach_px) {
  CircleHandle nearest = CircleHandle::kNone;
  double least = reach_px;
  for (const CircleHandle handle :
       {CircleHandle::kCenter, CircleHandle::kRight, CircleHandle::kLeft, CircleHandle::kTop, CircleHandle::kBottom}) {
    const PixelPoint place = place_of(circle, handle);
    const double away = std::hypot(at.x - place.x, at.y - place.y);
    if (away > least) continue;
    least = away;
    nearest = handle;
  }
  if (nearest != CircleHandle::kNone) return nearest;
  const double radius =
      std::hypot((at.x - circle.center_x) / circle.radius_x, (at.y - circle.center_y) / circle.radius_y);
  return radius < 1 ? CircleHandle::kCenter : CircleHandle::kNone;
}

PixelCircle dragged_circle(const PixelCircle& before, CircleHandle handle, double dx, double dy, bool round,
                           ImageSize picture) {
  PixelCircle circle = before;
  switch (handle) {
    case CircleHandle::kNone:
      return before;
    case CircleHandle::kCenter:
      circle.center_x += dx;
      circle.center_y += dy;
      break;
    case CircleHandle::kRight:
    case CircleHandle::kLeft:
      circle.radius_x += handle == CircleHandle::kRight ? dx : -dx;
      if (round) circle.radius_y = circle.radius_x;
      break;
    case CircleHandle::kTop:
    case CircleHandle::kBottom:
      circle.radius_y += handle == CircleHandle::kBottom ? dy : -dy;
      if (round) circle.radius_x = circle.radius_y;
      break;
  }
  return limited_circle(circle, picture);
}

PixelCircle limited_circle(PixelCircle circle, ImageSize picture) {
  const double longest = std::max(picture.width, picture.height);
  circle.center_x = std::clamp(circle.center_x, 0.5, picture.width - 0.5);
  circle.center_y = std::clamp(circle.center_y, 0.5, picture.height - 0.5);
  circle.radius_x = std::clamp(circle.radius_x, 1.0, longest);
  circle.radius_y = std::clamp(circle.radius_y, 1.0, longest);
  return circle;
}

}  // namespace zonal
