#include "zonal/sphere/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "zonal/base/check.h"
#include "zonal/sphere/shape.h"

namespace zonal {
namespace {

/// A picture of natural unit s is columns·s wide and rows·s high.
struct Format {
  Layout layout;
  std::string_view name;
  int columns, rows;
};
constexpr std::array kFormats = {
    Format{Layout::kEquirect, "equirect", 2, 1},
    Format{Layout::kCubeStack, "cube-stack", 1, 6},
    Format{Layout::kCubeRow, "cube-row", 6, 1},
    Format{Layout::kCubeCross, "cube-cross", 4, 3},
    Format{Layout::kCubeCrossVertical, "cube-cross-vertical", 3, 4},
    Format{Layout::kCubeCrossVerticalUnrotated, "cube-cross-vertical-unrotated", 3, 4},
    Format{Layout::kOctahedral, "octahedral", 1, 1},
    Format{Layout::kOctahedralEqualArea, "octahedral-equal-area", 1, 1},
    Format{Layout::kMirrorBall, "mirror-ball", 1, 1},
    Format{Layout::kSphereMap, "sphere-map", 1, 1},
    Format{Layout::kAngular, "angular", 1, 1},
    Format{Layout::kDualParaboloid, "dual-paraboloid", 2, 1},
    Format{Layout::kFisheye, "fisheye", 1, 1},
    Format{Layout::kDualFisheye, "dual-fisheye", 2, 1},
};

constexpr auto kLayouts = [] {
  std::array<Layout, kFormats.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = kFormats[i].layout;
  return all;
}();

struct ModelName {
  LensModel model;
  std::string_view name;
};
constexpr std::array kModels = {
    ModelName{LensModel::kEquidistant, "equidistant"},
    ModelName{LensModel::kEquisolid, "equisolid"},
    ModelName{LensModel::kStereographic, "stereographic"},
    ModelName{LensModel::kOrthographic, "orthographic"},
};

const Format& format_of(Layout layout) {
  const auto found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return f.layout == layout; });
  check(found != kFormats.end(), "no such layout");
  return *found;
}

}  // namespace

std::string_view name_of(Layout layout) { return format_of(layout).name; }

std::string_view name_of(LensModel model) {
  const auto found = std::find_if(kModels.begin(), kModels.end(), [&](const ModelName& m) { return m.model == model; });
  check(found != kModels.end(), "no such lens model");
  return found->name;
}

std::optional<Layout> layout_named(std::string_view name) {
  for (const Format& format : kFormats) {
    if (format.name == name) return format.layout;
  }
  return std::nullopt;
}

std::optional<LensModel> lens_model_named(std::string_view name) {
  for (const ModelName& model : kModels) {
    if (model.name == name) return model.model;
  }
  return std::nullopt;
}

std::span<const Layout> all_layouts() { return kLayouts; }

bool is_fisheye(Layout layout) { return layout == Layout::kFisheye || layout == Layout::kDualFisheye; }

bool has_circle(Layout layout) {
  return is_fisheye(layout) || layout == Layout::kMirrorBall || layout == Layout::kSphereMap ||
         layout == Layout::kAngular;
}

ImageSize image_size(Layout layout, int size_px) {
  const Format& format = format_of(layout);
  check(size_px > 0 && size_px <= std::numeric_limits<int>::max() / std::max(format.columns, format.rows),
        "a picture's natural size must be positive and its sides representable");
  return {format.columns * size_px, format.rows * size_px};
}

std::optional<int> natural_size(Layout layout, ImageSize size) {
  const auto [width, height] = size;
  if (width < 1 || height < 1) return std::nullopt;
  if (layout == Layout::kEquirect) {
    const double excess = std::abs(width - 2.0 * height);
    return excess <= 0.01 * width ? std::optional(height) : std::nullopt;
  }
  if (layout == Layout::kFisheye) return std::min(width, height);
  if (layout == Layout::kDualFisheye) return width % 2 == 0 ? std::optional(std::min(width / 2, height)) : std::nullopt;

  const Format& format = format_of(layout);
  const int unit = width / format.columns;
  const bool fits = width == format.columns * unit && height % format.rows == 0 && height / format.rows == unit;
  return fits ? std::optional(unit) : std::nullopt;
}

std::optional<int> natural_size(const Projection& projection, ImageSize size) {
  const Lens& lens = projection.lens;
  const double radius_px = std::max(lens.radius_x_px, lens.radius_y_px);
  const bool placed = lens.center_x_px != 0 || lens.center_y_px != 0 || radius_px > 0;
  if (!has_circle(projection.layout) || !placed) return natural_size(projection.layout, size);
  const std::optional<int> unit =
      natural_size(projection.layout == Layout::kDualFisheye ? Layout::kDualFisheye : Layout::kFisheye, size);
  if (!unit || !(radius_px > 0 && radius_px <= std::numeric_limits<int>::max() / 4)) return unit;
  return std::max(1, static_cast<int>(std::lround(2 * radius_px)));
}

std::string shape_in_words(Layout layout) {
  switch (layout) {
    case Layout::kEquirect:
      return "an equirectangular panorama is twice as wide as it is high";
    case Layout::kFisheye:
      return "a fisheye picture may have any size";
    case Layout::kDualFisheye:
      return "a dual fisheye picture has an even width, a half for each circle";
    default:
      break;
  }
  const Format& format = format_of(layout);
  if (has_circle(layout))
    return "a picture of this kind is a square, or shows a circle that --center and --radius place";
  if (format.columns == format.rows) return "a picture of this kind is a square";
  return "a picture of this kind is " + std::to_string(format.columns) + ":" + std::to_string(format.rows);
}

ImageSize nearest_size(Layout layout, ImageSize size) {
  const Format& format = format_of(layout);
  const double texels = std::max(1.0, static_cast<double>(size.width) * size.height);
  const double unit = std::sqrt(texels / (format.columns * format.rows));
  return image_size(layout, std::max(1, static_cast<int>(std::lround(unit))));
}

}  // namespace zonal
