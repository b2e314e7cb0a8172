#include "zonal/sphere/mapping.h"

#include <algorithm>
#include <string>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/sphere/shape.h"

namespace zonal {
namespace {

std::string text_of(ImageSize size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

void require_shape(const Projection& projection, ImageSize size) {
  if (natural_size(projection, size)) return;
  const Layout layout = projection.layout;
  throw Error(ErrorKind::kInput, "a picture of " + text_of(size) + " texels cannot be " + std::string(name_of(layout)),
              shape_in_words(layout) + "; the nearest such size is " + text_of(nearest_size(layout, size)));
}

double theta_max_of(const Lens& lens) {
  const bool half_sphere = lens.model == LensModel::kOrthographic;
  const bool never_whole = lens.model == LensModel::kStereographic;
  const double limit = half_sphere ? 180 : 360;
  if (!(lens.fov_deg > 0 && lens.fov_deg <= limit) || (never_whole && lens.fov_deg == limit)) {
    throw Error(ErrorKind::kUsage, "no " + std::string(name_of(lens.model)) + " lens has that field of view",
                "it must be over 0 and " + std::string(never_whole ? "under " : "at most ") +
                    (half_sphere ? "180" : "360") + " degrees");
  }
  return kPi * (lens.fov_deg / 360);  // exactly π/2 for 180 degrees
}

/// The lens's circle in the picture's part `box`, with the defaults filled in.
PixelCircle circle_of(const Lens& lens, PixelBox box) {
  const double width = box.x1 - box.x0, height = box.y1 - box.y0;
  const bool centered = lens.center_x_px == 0 && lens.center_y_px == 0;
  const double x = centered ? width / 2 : lens.center_x_px, y = centered ? height / 2 : lens.center_y_px;
  if (!(x > 0 && x < width && y > 0 && y < height)) {
    throw Error(ErrorKind::kUsage, "the circle's centre lies outside the picture",
                "give it in pixels from the top left corner, for a dual fisheye within the left half");
  }
  const double radius_x = lens.radius_x_px != 0 ? lens.radius_x_px : std::min({x, width - x, y, height - y});
  const double radius_y = lens.radius_y_px != 0 ? lens.radius_y_px : radius_x;
  if (!(radius_x >= 0.5 && radius_y >= 0.5 && std::isfinite(radius_x) && std::isfinite(radius_y))) {
    throw Error(ErrorKind::kUsage, "the circle's radius must be half a pixel or more", "give it in pixels");
  }
  return {box.x0 + x, box.y0 + y, radius_x, radius_y};
}

PixelBox whole(ImageSize size) { return {0, 0, size.width, size.height}; }

/// The circle that fills a square box.
PixelCircle filling(PixelBox box) { return circle_of({}, box); }

}  // namespace

PixelCircle circle_of(const Projection& projection, ImageSize size) {
  check(has_circle(projection.layout), "a projection without a circle was asked for it");
  const int across = projection.layout == Layout::kDualFisheye ? size.width / 2 : size.width;
  return circle_of(projection.lens, {0, 0, across, size.height});
}

Mapping::Map Mapping::make(const Projection& projection, ImageSize size) {
  require_shape(projection, size);
  const int natural = *natural_size(projection, size);
  const Lens& lens = projection.lens;
  switch (projection.layout) {
    case Layout::kEquirect:
      return Equirect(size);
    case Layout::kCubeStack:
    case Layout::kCubeRow:
    case Layout::kCubeCross:
    case Layout::kCubeCrossVertical:
    case Layout::kCubeCrossVerticalUnrotated:
      return Cube(projection.layout, natural);
    case Layout::kOctahedral:
      return Octahedral(natural);
    case Layout::kOctahedralEqualArea:
      return EqualAreaOctahedral(natural);
    case Layout::kMirrorBall:
    case Layout::kSphereMap:
      // A ball's normal halves the angle of reflection, and an orthographic camera sees its sine: r = sin(θ/2).
      return Disc(kBackwardMirrored, {LensModel::kEquisolid, kPi}, circle_of(projection, size), whole(size));
    case Layout::kAngular:
      return Disc(kForward, {LensModel::kEquidistant, kPi}, circle_of(projection, size), whole(size));
    case Layout::kFisheye:
      return Disc(kZenith, {lens.model, theta_max_of(lens)}, circle_of(projection, size), whole(size));
    case Layout::kDualParaboloid: {
      const RadialLaw law(LensModel::kStereographic, kPi / 2);
      const PixelBox left{0, 0, natural, natural}, right{natural, 0, 2 * natural, natural};
      return DualDisc({kForward, law, filling(left), left}, {kBackwardMirrored, law, filling(right), right}, natural);
    }
    case Layout::kDualFisheye: {
      const RadialLaw law(lens.model, theta_max_of(lens));
      const int half = size.width / 2;
      const PixelBox left{0, 0, half, size.height}, right{half, 0, size.width, size.height};
      return DualDisc({kForward, law, circle_of(lens, left), left, kPi / 2},
                      {kBackward, law, circle_of(lens, right), right, kPi / 2}, half);
    }
  }
  throw Error(ErrorKind::kUsage, "unknown projection");
}

Mapping::Mapping(const Projection& projection, ImageSize size)
    : projection_(projection), size_(size), map_(make(projection, size)) {}

std::optional<Vec3> Mapping::direction(PixelPoint p) const {
  return visit([&](const auto& map) { return map.direction(p); });
}

std::optional<PixelPoint> Mapping::position(Vec3 toward) const {
  return visit([&](const auto& map) { return map.position(toward); });
}

double Mapping::solid_angle(int x, int y) const {
  return visit([&](const auto& map) { return map.solid_angle(x, y); });
}

std::optional<Vec3> Mapping::texel_direction(int x, int y) const {
  return visit([&](const auto& map) { return map.texel_direction(x, y); });
}

Texel Mapping::nearest(Vec3 toward) const {
  return visit([&](const auto& map) { return map.nearest(toward); });
}

bool Mapping::covers_sphere() const {
  return visit([](const auto& map) { return map.covers_sphere(); });
}

int Mapping::chart(PixelPoint p) const {
  return visit([&](const auto& map) { return map.chart(p); });
}

Texel Mapping::wrap(int chart, int x, int y) const {
  return visit([&](const auto& map) { return map.wrap(chart, x, y); });
}

bool Mapping::regular(int chart, int x, int y, int size) const {
  return visit([&](const auto& map) { return map.regular(chart, x, y, size); });
}

}  // namespace zonal
