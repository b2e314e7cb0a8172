#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "zonal/math/vec.h"
#include "zonal/sphere/frame.h"
#include "zonal/sphere/pixel.h"
#include "zonal/sphere/radial_law.h"

namespace zonal {

/// The part [x0, x1) x [y0, y1) of a picture.
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The circle (or upright ellipse) in which a disc lies, in pixels.
struct PixelCircle {
  double center_x = 0, center_y = 0, radius_x = 0, radius_y = 0;
};

/// One azimuthal map: mirror ball, sphere map, angular map, fisheye, half of a dual map. A direction at the angle θ
/// from the centre's lies at radius r(θ). The members are those of Mapping; positions near the rim of a ball or of an
/// orthographic half sphere, where r hardly depends on θ, hold a direction to the square root of rounding only.
class Disc {
 public:
  /// `box` is the part of the picture that belongs to the disc, `theta_owned` how far from its centre the disc's solid
  /// angles count: less than the law's where another disc shows the rest.
  Disc(const PictureAxes&, const RadialLaw&, const PixelCircle&, PixelBox box, double theta_owned);
  Disc(const PictureAxes& axes, const RadialLaw& law, const PixelCircle& circle, PixelBox box)
      : Disc(axes, law, circle, box, law.theta_max()) {}

  std::optional<Vec3> direction(PixelPoint p) const {
    if (!(p.x >= box_.x0 && p.x <= box_.x1 && p.y >= box_.y0 && p.y <= box_.y1)) return std::nullopt;
    const DiscPoint q = to_disc(p);
    const double r = length(q);
    if (!(r <= 1 + kRimSlack)) return std::nullopt;
    return toward(q, law_.polar(std::min(r, 1.0)));
  }

  std::optional<PixelPoint> position(Vec3 d) const {
    const DiscPoint side{dot(axes_.right, d), -dot(axes_.up, d)};
    const double sine = length(side);
    const double r = law_.radius(dot(axes_.center, d), sine);
    if (!(r <= 1 + kRimSlack)) return std::nullopt;
    // At the pole opposite to the centre every place of the rim is right.
    return inside_box(sine > 0 ? to_pixels({side.x * (r / sine), side.y * (r / sine)}) : to_pixels({r, 0}));
  }

  double solid_angle(int x, int y) const;
  std::optional<Vec3> texel_direction(int x, int y) const;
  Texel nearest(Vec3) const;
  bool covers_sphere() const;

  int chart(PixelPoint) const { return 0; }
  Texel wrap(int chart, int x, int y) const;
  bool regular(int chart, int x, int y, int size) const;

  bool contains_circle() const;
  const RadialLaw& law() const { return law_; }
  double cosine_from_center(Vec3 d) const { return dot(axes_.center, d); }
  /// Whether the centre of texel (x, y), anywhere, lies in the disc.
  bool shows_center(int x, int y) const { return direction(center_of({x, y})).has_value(); }
  /// The direction at the centre of a texel outside the circle if the map went on there: as far beyond the rim in angle
  /// as the place of the same distance inside the rim is before it.
  Vec3 direction_beyond(int x, int y) const;
  /// The texel that holds a point or, where its centre is not shown, the first on the way to the disc's centre that is.
  Texel shown_near(PixelPoint) const;

 private:
  // A radius has a few roundings of pixel coordinates behind it; this is far more, and far less than a texel.
  static constexpr double kRimSlack = 1e-12;

  DiscPoint to_disc(PixelPoint p) const {
    return {(p.x - circle_.center_x) / circle_.radius_x, (p.y - circle_.center_y) / circle_.radius_y};
  }
  PixelPoint to_pixels(DiscPoint q) const {
    return {circle_.center_x + q.x * circle_.radius_x, circle_.center_y + q.y * circle_.radius_y};
  }
  Vec3 toward(DiscPoint q, RadialLaw::Polar polar) const {
    return polar.cosine * axes_.center + (polar.sine_over_radius * q.x) * axes_.right -
           (polar.sine_over_radius * q.y) * axes_.up;
  }
  std::optional<PixelPoint> inside_box(PixelPoint) const;

  PictureAxes axes_;
  RadialLaw law_, owned_law_;
  PixelCircle circle_;
  double owned_radius_;  // of the circle up to theta_owned, in the disc's units
  PixelBox box_;
};

/// The solid angle of the rectangle [low, high] of the disc's plane, clipped to the unit circle.
double clipped_solid_angle(const RadialLaw&, DiscPoint low, DiscPoint high);

}  // namespace zonal
