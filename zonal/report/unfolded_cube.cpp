#include "zonal/report/unfolded_cube.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/base/grid.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr Rgb kNegative = {0.02f, 0.07f, 0.75f}, kZero = {0.06f, 0.36f, 0.07f}, kPositive = {0.75f, 0.03f, 0.02f};
constexpr double kLineWidthPx = 1.2;

/// The function at the corners of a face's pixels, and where the face lies in the cross.
struct Face {
  Grid<double> corners;
  int left = 0, top = 0;
};

Face sampled_face(const std::function<double(Vec3)>& f, int face, int face_px, const Mapping& cross) {
  Face result{Grid<double>(face_px + 1, face_px + 1)};
  for (int y = 0; y <= face_px; ++y) {
    for (int x = 0; x <= face_px; ++x) {
      const FacePoint p = {face, 2.0 * x / face_px - 1, 2.0 * y / face_px - 1};
      const double value = f(normalize(world_from_sampler(sampler_direction(p))));
      check(std::isfinite(value), "an unfolded cube needs finite values");
      result.corners(x, y) = value;
    }
  }
  const PixelPoint center = *cross.position(world_from_sampler(sampler_direction({face, 0, 0})));
  result.left = static_cast<int>(center.x / face_px) * face_px;
  result.top = static_cast<int>(center.y / face_px) * face_px;
  return result;
}

/// How much of a pixel a line of equal value covers. `slope` is the change over one pixel.
double line_cover(double value, double slope, double step, int steps) {
  // No line where the function stands still: it would be an area.
  if (!(slope > 1e-9 * step)) return 0;
  // The full scales themselves are touched in points, not crossed.
  const double level = std::clamp(std::round(value / step), 1.0 - steps, steps - 1.0);
  return std::clamp(0.5 + kLineWidthPx / 2 - std::abs(value - level * step) / slope, 0.0, 1.0);
}

}  // namespace

Rgb signed_color(double value) {
  const auto t = static_cast<float>(std::clamp(std::abs(value), 0.0, 1.0));
  return (1 - t) * kZero + t * (value < 0 ? kNegative : kPositive);
}

Image<Rgb> unfolded_cube(const std::function<double(Vec3 toward)>& f, const UnfoldedCubeOptions& options) {
  check(options.face_px >= 1 && options.steps >= 1, "an unfolded cube needs pixels and steps");
  const ImageSize size = image_size(Layout::kCubeCross, options.face_px);
  const Mapping cross({Layout::kCubeCross}, size);
  std::array<Face, 6> faces;
  double full = options.full_scale;
  for (int face = 0; face < 6; ++face) {
    faces[face] = sampled_face(f, face, options.face_px, cross);
    if (options.full_scale > 0) continue;
    for (const double value : faces[face].corners.values()) full = std::max(full, std::abs(value));
  }
  if (full == 0) full = 1;

  Image<Rgb> picture(size.width, size.height, options.paper);
  for (const auto& [corners, left, top] : faces) {
    for (int y = 0; y < options.face_px; ++y) {
      for (int x = 0; x < options.face_px; ++x) {
        const double a = corners(x, y), b = corners(x + 1, y), c = corners(x, y + 1), d = corners(x + 1, y + 1);
        const double value = (a + b + c + d) / 4, slope = std::hypot(b + d - a - c, c + d - a - b) / 2;
        const auto cover = static_cast<float>(line_cover(value, slope, full / options.steps, options.steps));
        picture(left + x, top + y) = (1 - cover) * signed_color(value / full) + cover * Rgb{1, 1, 1};
      }
    }
  }
  return picture;
}

}  // namespace zonal
