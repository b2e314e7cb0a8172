#pragma once

namespace zonal {

/// How a photograph lies on the picture it was aligned with: what the picture shows at the point p, the photograph has
/// at
///
///     q = c + R (p - c) + (dx, dy),
///
/// in pixels, c being the centre of both; R turns by `rotation_deg` from x (right) toward y (down), clockwise as seen.
struct Placement {
  double dx = 0, dy = 0, rotation_deg = 0;
  bool operator==(const Placement&) const = default;
};

/// A point of a picture in pixels; texel (x, y) is centred at (x + 1/2, y + 1/2).
struct PicturePoint {
  double x = 0, y = 0;
};

/// A placement as a function of points, in pictures centred at `center`.
class Placing {
 public:
  Placing(const Placement&, PicturePoint center);
  /// Exact where nothing turns and the point, the centre and the move are multiples of a half.
  PicturePoint operator()(PicturePoint p) const {
    const double x = p.x - center_.x, y = p.y - center_.y;
    return {center_.x + cosine_ * x - sine_ * y + dx_, center_.y + sine_ * x + cosine_ * y + dy_};
  }

 private:
  PicturePoint center_;
  double cosine_, sine_, dx_, dy_;
};

/// First one, then the other: placed(composed(b, a), p) = placed(b, placed(a, p)).
Placement composed(const Placement& second, const Placement& first);
Placement inverse(const Placement&);

/// Whether a placement only moves, and by whole texels: then every texel keeps its code.
bool is_whole(const Placement&);
/// The move by whole texels that differs from a placement by at most `tolerance_px` everywhere in a picture of this
/// size; the placement itself where there is none.
Placement settled(const Placement&, int width, int height, double tolerance_px);

}  // namespace zonal
