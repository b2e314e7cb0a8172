#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "zonal/math/vec.h"
#include "zonal/sphere/frame.h"
#include "zonal/sphere/pixel.h"
#include "zonal/sphere/projection.h"

namespace zonal {

/// A point of a cube's face: faces are +X -X +Y -Y +Z -Z, u runs right and v down over [-1, 1].
struct FacePoint {
  int face = 0;
  double u = 0, v = 0;
};

/// The direction of a point of a face in the sampler's axes, not normalised (the table of the OpenGL and Direct3D
/// specifications). Also beyond the face's edge, |u| or |v| over 1.
constexpr Vec3 sampler_direction(FacePoint p) {
  const auto [face, u, v] = p;
  switch (face) {
    case 0:
      return {1, -v, -u};
    case 1:
      return {-1, -v, u};
    case 2:
      return {u, 1, v};
    case 3:
      return {u, -1, -v};
    case 4:
      return {u, -v, 1};
    default:
      return {-u, -v, -1};
  }
}

/// The inverse: the face of the longest component (x before y before z where they are equal).
inline FacePoint face_point(Vec3 d) {
  const double ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
  if (ax >= ay && ax >= az) return {d.x > 0 ? 0 : 1, -d.z / d.x, -d.y / ax};
  if (ay >= az) return {d.y > 0 ? 2 : 3, d.x / ay, d.z / d.y};
  return {d.z > 0 ? 4 : 5, d.x / d.z, -d.y / az};
}

/// Six faces in one picture, in any of the layouts whose names begin with kCube. A chart is a face. The members are
/// those of Mapping.
class Cube {
 public:
  /// `layout` must be one of the kCube ones.
  Cube(Layout layout, int face_size);

  std::optional<Vec3> direction(PixelPoint p) const {
    if (!(p.x >= 0 && p.x <= columns_ * face_size_ && p.y >= 0 && p.y <= rows_ * face_size_)) return std::nullopt;
    const int face = face_at(p);
    if (face < 0) return std::nullopt;
    const Place& place = places_[face];
    const double u = place.sign * (2 * (p.x - place.x) / face_size_ - 1);
    const double v = place.sign * (2 * (p.y - place.y) / face_size_ - 1);
    return normalize(world_from_sampler(sampler_direction({face, u, v})));
  }

  std::optional<PixelPoint> position(Vec3 d) const {
    const auto [face, u, v] = face_point(sampler_from_world(d));
    const Place& place = places_[face];
    return PixelPoint{within(place.x, place.sign * u), within(place.y, place.sign * v)};
  }

  double solid_angle(int x, int y) const;
  std::optional<Vec3> texel_direction(int x, int y) const { return direction(center_of({x, y})); }
  Texel nearest(Vec3 toward) const;
  bool covers_sphere() const { return true; }

  /// 0 in a cross's gap.
  int chart(PixelPoint p) const { return std::max(0, face_at(p)); }
  Texel wrap(int face, int x, int y) const;
  bool regular(int face, int x, int y, int size) const;

 private:
  /// Where a face lies: its top left texel, and -1 where it is rotated by half a turn.
  struct Place {
    int x = 0, y = 0, sign = 1;
  };

  /// -1 in a gap.
  int face_at(PixelPoint p) const {
    const int column = std::clamp(static_cast<int>(p.x / face_size_), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(p.y / face_size_), 0, rows_ - 1);
    return face_in_cell_[row * columns_ + column];
  }

  /// A face's right and lower edge belong to the next cell of the picture, which shows something else: stay just
  /// inside.
  double within(int start, double s) const {
    const double p = start + (0.5 * s + 0.5) * face_size_;
    const double end = start + face_size_;
    return p < end ? p : std::nextafter(end, 0.0);
  }

  int face_size_ = 0, columns_ = 0, rows_ = 0;
  std::array<Place, 6> places_;
  std::array<int, 12> face_in_cell_;
};

}  // namespace zonal
