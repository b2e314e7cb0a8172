#pragma once

#include <array>
#include <optional>

#include "zonal/sphere/disc.h"

namespace zonal {

/// Two discs side by side that look opposite ways: dual paraboloid, dual fisheye. Each owns the half sphere around its
/// centre; what it shows beyond (a fisheye over 180°) can be read and written, but counts nothing. A chart is a disc.
/// The members are those of Mapping.
class DualDisc {
 public:
  /// `split` is the first column of the right disc.
  DualDisc(const Disc& left, const Disc& right, int split) : discs_{left, right}, split_(split) {}

  std::optional<Vec3> direction(PixelPoint p) const { return discs_[chart(p)].direction(p); }
  std::optional<PixelPoint> position(Vec3 d) const {
    const int owner = owner_of(d);
    if (const auto p = discs_[owner].position(d)) return p;
    return discs_[1 - owner].position(d);
  }
  double solid_angle(int x, int y) const { return discs_[chart(center_of({x, y}))].solid_angle(x, y); }
  std::optional<Vec3> texel_direction(int x, int y) const {
    return discs_[chart(center_of({x, y}))].texel_direction(x, y);
  }
  Texel nearest(Vec3 d) const {
    const auto p = position(d);
    return p ? discs_[chart(*p)].shown_near(*p) : discs_[owner_of(d)].nearest(d);
  }
  bool covers_sphere() const {
    return discs_[0].law().theta_max() >= kPi / 2 && discs_[0].contains_circle() && discs_[1].contains_circle();
  }

  int chart(PixelPoint p) const { return p.x < split_ ? 0 : 1; }
  Texel wrap(int chart, int x, int y) const {
    return discs_[chart].shows_center(x, y) ? Texel{x, y} : nearest(discs_[chart].direction_beyond(x, y));
  }
  bool regular(int chart, int x, int y, int size) const { return discs_[chart].regular(0, x, y, size); }

 private:
  int owner_of(Vec3 d) const { return discs_[0].cosine_from_center(d) >= 0 ? 0 : 1; }

  std::array<Disc, 2> discs_;
  int split_;
};

}  // namespace zonal
