#include "zonal/sphere/disc.h"

#include "zonal/base/check.h"

namespace zonal {

Disc::Disc(const PictureAxes& axes, const RadialLaw& law, const PixelCircle& circle, PixelBox box, double theta_owned)
    : axes_(axes),
      law_(law),
      owned_law_(law.model(), std::min(theta_owned, law.theta_max())),
      circle_(circle),
      owned_radius_(theta_owned < law.theta_max() ? law.radius(std::cos(theta_owned), std::sin(theta_owned)) : 1),
      box_(box) {
  check(circle.radius_x > 0 && circle.radius_y > 0, "a disc needs a radius");
  check(
      circle.center_x >= box.x0 && circle.center_x <= box.x1 && circle.center_y >= box.y0 && circle.center_y <= box.y1,
      "a disc's centre must lie in its picture");
}

std::optional<PixelPoint> Disc::inside_box(PixelPoint p) const {
  // A circle that touches the border: rounding must not push its rim out of the picture, or into the other half of it.
  const double slack = 1e-9;  // pixels; a few roundings of coordinates up to 10^5
  const bool inside =
      p.x >= box_.x0 - slack && p.y >= box_.y0 - slack && p.x <= box_.x1 + slack && p.y <= box_.y1 + slack;
  if (!inside) return std::nullopt;
  const double end_x = std::nextafter(static_cast<double>(box_.x1), 0.0);
  const double end_y = std::nextafter(static_cast<double>(box_.y1), 0.0);
  return PixelPoint{std::clamp(p.x, static_cast<double>(box_.x0), end_x),
                    std::clamp(p.y, static_cast<double>(box_.y0), end_y)};
}

double Disc::solid_angle(int x, int y) const {
  const auto to_owned = [&](double px, double py) {
    const DiscPoint q = to_disc({px, py});
    return DiscPoint{q.x / owned_radius_, q.y / owned_radius_};
  };
  return clipped_solid_angle(owned_law_, to_owned(x, y), to_owned(x + 1, y + 1));
}

std::optional<Vec3> Disc::texel_direction(int x, int y) const {
  if (const auto center = direction(center_of({x, y}))) return center;
  if (solid_angle(x, y) <= 0) return std::nullopt;
  const DiscPoint q = to_disc(center_of({x, y}));
  const double r = length(q);
  return toward({q.x / r, q.y / r}, law_.polar(1));
}

Texel Disc::nearest(Vec3 d) const {
  if (const auto p = position(d)) return shown_near(*p);
  const DiscPoint side{dot(axes_.right, d), -dot(axes_.up, d)};
  const double sine = length(side);
  const double r = std::min(law_.radius(dot(axes_.center, d), sine), 1.0);
  return shown_near(to_pixels(sine > 0 ? DiscPoint{side.x * r / sine, side.y * r / sine} : DiscPoint{r, 0}));
}

Texel Disc::shown_near(PixelPoint p) const {
  const auto texel_at = [&](PixelPoint q) {
    return Texel{std::clamp(static_cast<int>(std::floor(q.x)), box_.x0, box_.x1 - 1),
                 std::clamp(static_cast<int>(std::floor(q.y)), box_.y0, box_.y1 - 1)};
  };
  const double dx = p.x - circle_.center_x, dy = p.y - circle_.center_y;
  const double distance = std::hypot(dx, dy);
  for (double left = distance; left > 0; left -= 0.5) {  // half a texel at a time meets every texel on the way
    const Texel t = texel_at({circle_.center_x + dx * (left / distance), circle_.center_y + dy * (left / distance)});
    if (shows_center(t.x, t.y)) return t;
  }
  return texel_at({circle_.center_x, circle_.center_y});
}

bool Disc::contains_circle() const {
  const double slack = 1e-9;  // as in inside_box
  return circle_.center_x - circle_.radius_x >= box_.x0 - slack &&
         circle_.center_x + circle_.radius_x <= box_.x1 + slack &&
         circle_.center_y - circle_.radius_y >= box_.y0 - slack &&
         circle_.center_y + circle_.radius_y <= box_.y1 + slack;
}

bool Disc::covers_sphere() const { return law_.theta_max() >= kPi && contains_circle(); }

Vec3 Disc::direction_beyond(int x, int y) const {
  const DiscPoint q = to_disc(center_of({x, y}));
  const double r = length(q);
  const double mirrored = std::max(0.0, 2 - r);
  const auto [cosine, sine_over_radius] = law_.polar(mirrored);
  const double theta = 2 * law_.theta_max() - std::atan2(sine_over_radius * mirrored, cosine);
  return toward(q, {std::cos(theta), std::sin(theta) / r});
}

Texel Disc::wrap(int /*chart*/, int x, int y) const {
  return shows_center(x, y) ? Texel{x, y} : nearest(direction_beyond(x, y));
}

bool Disc::regular(int /*chart*/, int x, int y, int size) const {
  // The disc and its box are convex: the corners decide.
  const int x1 = x + size - 1, y1 = y + size - 1;
  return shows_center(x, y) && shows_center(x1, y) && shows_center(x, y1) && shows_center(x1, y1);
}

}  // namespace zonal
