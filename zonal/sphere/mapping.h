#pragma once

#include <optional>
#include <utility>
#include <variant>

#include "zonal/math/vec.h"
#include "zonal/sphere/cube.h"
#include "zonal/sphere/disc.h"
#include "zonal/sphere/dual_disc.h"
#include "zonal/sphere/equirect.h"
#include "zonal/sphere/octahedral.h"
#include "zonal/sphere/pixel.h"
#include "zonal/sphere/projection.h"

namespace zonal {

/// Where the circle of a fisheye, mirror ball, sphere map or angular map lies in a picture of this size, with the
/// lens's defaults filled in; of a dual fisheye, the left one. Throws Error{kUsage} where that is impossible.
PixelCircle circle_of(const Projection&, ImageSize);

/// The geometry of one picture: a projection and a size. The one place where texels and directions meet.
///
/// Neighbours. A picture consists of *charts*: the six faces of a cube, the two discs of a dual map, else the whole
/// picture. To interpolate at a direction d without a seam: p = *position(d), c = chart(p); the texels around p are (x,
/// y), (x+1, y), ... with x = floor(p.x - ½), y = floor(p.y - ½); wrap(c, x, y) names the texel that really lies there
/// on the sphere, and regular(c, x, y) says whether bilinear weights in the chart are right for the block (where they
/// are not, weights can be solved from the texels' directions).
class Mapping {
 public:
  /// Throws Error{kInput} when the size does not fit the projection (the hint names the sizes that would), and
  /// Error{kUsage} when the lens is impossible.
  Mapping(const Projection&, ImageSize);

  const Projection& projection() const { return projection_; }
  ImageSize size() const { return size_; }

  /// The unit direction that a point of the picture shows; nullopt where it shows nothing (outside a circle, in a
  /// cross's gap).
  std::optional<Vec3> direction(PixelPoint) const;
  /// Where the picture shows a unit direction; nullopt where it does not. direction(*position(d)) == d to rounding (to
  /// its square root at the rim of a mirror ball, sphere map or orthographic half sphere, where the radius stops
  /// growing).
  std::optional<PixelPoint> position(Vec3 toward) const;
  /// The solid angle of texel (x, y) in steradians, exact to rounding; over a full picture they sum to 4π. Texels cut
  /// by a circle's rim count with the part inside. Two overlapping circles (dual fisheye over 180°) own a hemisphere
  /// each.
  double solid_angle(int x, int y) const;

  /// The direction that stands for a texel: that of its centre or, where a circle's rim cuts the texel and leaves the
  /// centre outside, of the point of the rim nearest to the centre. nullopt where the texel shows nothing.
  std::optional<Vec3> texel_direction(int x, int y) const;
  /// The texel whose centre the picture shows and that is nearest to a unit direction: the one that contains it, or one
  /// at the rim where the picture does not show the direction.
  Texel nearest(Vec3 toward) const;
  /// True when position() has an answer for every direction.
  bool covers_sphere() const;

  /// The chart that a point of the picture belongs to.
  int chart(PixelPoint) const;
  /// The texel that lies at (x, y) of a chart continued up to two texels beyond its edge (across a cube's edge, an
  /// octahedral fold, a pole, to a dual map's other disc or the far side of a full disc); (x, y) itself inside. At a
  /// cube's corner, where only three faces meet, the missing fourth repeats one of the others. Always a texel whose
  /// centre the picture shows.
  Texel wrap(int chart, int x, int y) const;
  /// Whether the block of size x size texels with top left (x, y) lies in one smooth piece of the chart: all centres
  /// shown, none across a cube edge, an octahedral fold or crease, or a rim. (Equirectangular: also across the seam,
  /// and across a pole when the width is even.)
  bool regular(int chart, int x, int y, int size = 2) const;

  /// Calls f with the concrete map, so that a loop over texels dispatches once. Every map has the members above.
  template <class F>
  decltype(auto) visit(F&& f) const {
    return std::visit(std::forward<F>(f), map_);
  }

 private:
  using Map = std::variant<Equirect, Cube, Octahedral, EqualAreaOctahedral, Disc, DualDisc>;

  static Map make(const Projection&, ImageSize);

  Projection projection_;
  ImageSize size_;
  Map map_;
};

}  // namespace zonal
