#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace zonal {

/// How a flat picture shows the sphere. Names on the command line are those of name_of().
enum class Layout {
  kEquirect,           ///< latitude-longitude, 2:1, +Z up, +X in the centre, -Y right of it
  kCubeStack,          ///< six faces +X -X +Y -Y +Z -Z from top to bottom, 1:6 (vertical strip; six files in memory)
  kCubeRow,            ///< the same from left to right, 6:1 (horizontal strip)
  kCubeCross,          ///< horizontal cross, 4:3
  kCubeCrossVertical,  ///< vertical cross, 3:4, -Z at the bottom rotated by half a turn
  kCubeCrossVerticalUnrotated,  ///< vertical cross, 3:4, -Z at the bottom as it is
  kOctahedral,                  ///< Meyer et al. 2010
  kOctahedralEqualArea,         ///< Clarberg 2008, as in pbrt-v4
  kMirrorBall,                  ///< orthographic photograph of a mirrored ball
  kSphereMap,                   ///< the same picture, as in OpenGL's GL_SPHERE_MAP
  kAngular,                     ///< angular map ("light probe", Debevec 1998), the full sphere in a disc
  kDualParaboloid,              ///< two paraboloids side by side, 2:1 (Heidrich & Seidel 1998)
  kFisheye,                     ///< one circle, described by a Lens
  kDualFisheye,                 ///< two circles side by side, each described by the Lens, looking opposite ways
};

/// How a fisheye lens maps the angle from its axis to the distance from the centre.
enum class LensModel { kEquidistant, kEquisolid, kStereographic, kOrthographic };

/// A fisheye's lens, and where the circle of a fisheye, mirror ball, sphere map or angular map lies in the picture.
/// Centre and radii in pixels; centre (0, 0): the centre of the picture; radius_x_px 0: the largest circle that fits
/// around the centre; radius_y_px 0: the same as radius_x_px. A dual fisheye's lens is measured in the left half; the
/// right circle lies at the same place of the right half. `model` and `fov_deg` describe fisheyes alone; fov_deg is
/// the whole angle: over 0, at most 360 (equidistant, equisolid), under 360 (stereographic), at most 180
/// (orthographic).
struct Lens {
  LensModel model = LensModel::kEquidistant;
  double fov_deg = 180;
  double center_x_px = 0, center_y_px = 0;
  double radius_x_px = 0, radius_y_px = 0;
  bool operator==(const Lens&) const = default;
};

struct Projection {
  Layout layout = Layout::kEquirect;
  Lens lens = {};  ///< used where has_circle()
  bool operator==(const Projection&) const = default;
};

std::string_view name_of(Layout);
std::string_view name_of(LensModel);
std::optional<Layout> layout_named(std::string_view name);
std::optional<LensModel> lens_model_named(std::string_view name);
std::span<const Layout> all_layouts();

/// Whether a lens describes a layout: how it maps angles, and where its circle lies.
bool is_fisheye(Layout);
/// Whether a layout is a circle (or two) that may be placed in a larger picture: the fisheyes, the balls and the
/// angular map.
bool has_circle(Layout);

struct ImageSize {
  int width = 0, height = 0;
  bool operator==(const ImageSize&) const = default;
};

/// The size of a picture in this layout whose natural unit (equirectangular height, cube face edge, disc diameter,
/// octahedral side) is `size_px`.
ImageSize image_size(Layout, int size_px);

/// The natural unit of a picture of this size; nullopt where the shape does not fit the layout. Exact shapes only, but
/// for kEquirect, which accepts 2:1 within 1 % (stitchers trim a few rows), and the fisheyes, which accept any (dual:
/// an even width).
std::optional<int> natural_size(Layout, ImageSize);
/// The same for a projection: a circle that the lens places may lie in a picture of any shape, and its natural unit is
/// its larger diameter, rounded.
std::optional<int> natural_size(const Projection&, ImageSize);

/// What the shape and the name of a picture suggest, and why, in words for the user.
struct Guess {
  Projection projection;
  std::string reason;
};
/// Words of the name win over the shape. nullopt: nothing suggests anything (a square without a telling name may be an
/// angular map, a mirror ball, an octahedron or a fisheye: nobody can tell, so the user must).
std::optional<Guess> guess_projection(ImageSize, std::string_view file_name);

}  // namespace zonal
