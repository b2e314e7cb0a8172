#include "zonal/report/basis_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/sh/gradient.h"

namespace zonal {
namespace {

constexpr Rgb kPositive = {0.72f, 0.045f, 0.03f}, kNegative = {0.05f, 0.14f, 0.78f};
constexpr int kSupersample = 3;
constexpr double kFill = 0.94;  // of the picture, by the farthest point

/// Screen right, screen up and toward the viewer.
struct View {
  Vec3 right, up, toward;
};

View view_of(const BasisShapeOptions& options) {
  const double azimuth = radians(options.azimuth_deg), elevation = radians(options.elevation_deg);
  const Vec3 toward = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                       std::sin(elevation)};
  const Vec3 right = {-std::sin(azimuth), std::cos(azimuth), 0};
  return {right, cross(toward, right), toward};
}

struct Vertex {
  Vec3 position;  ///< screen right, screen up, toward the viewer; in units of the function
  Rgb color;
};

Rgb shaded(Vec3 normal, bool negative) {
  static const Vec3 kToLight = normalize({-0.5, 0.75, 0.8});
  static const Vec3 kHalfway = normalize(kToLight + Vec3{0, 0, 1});
  const double matte = 0.22 + 0.78 * std::max(0.0, dot(normal, kToLight));
  const double gloss = 0.25 * std::pow(std::max(0.0, dot(normal, kHalfway)), 40);
  const Rgb lit = static_cast<float>(matte) * (negative ? kNegative : kPositive);
  return lit + static_cast<float>(gloss) * Rgb{1, 1, 1};
}

Vertex vertex_at(const Sh<double>& f, Vec3 direction, const View& view) {
  const auto [value, slope] = evaluate_with_gradient(f, direction);
  const bool negative = value < 0;
  const double radius = std::abs(value);
  // The surface r(d) d has the normal r d - grad r.
  const Vec3 normal = radius * direction + (negative ? 1.0 : -1.0) * slope;
  const double size = length(normal);
  const Vec3 unit = size > 0 ? (1 / size) * normal : direction;
  const auto on_screen = [&](Vec3 v) { return Vec3{dot(v, view.right), dot(v, view.up), dot(v, view.toward)}; };
  return {on_screen(radius * direction), shaded(on_screen(unit), negative)};
}

/// Pixels with the distance of what they show.
class Canvas {
 public:
  Canvas(int size_px, double reach, Rgb paper)
      : color_(size_px, size_px, paper),
        depth_(size_px, size_px, -std::numeric_limits<double>::infinity()),
        unit_(kFill * size_px / 2 / reach) {}

  void triangle(const Vertex& a, const Vertex& b, const Vertex& c) {
    const std::array<Vec3, 3> p = {placed(a), placed(b), placed(c)};
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (area == 0) return;
    const auto [x_first, x_last] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [y_first, y_last] = std::minmax({p[0].y, p[1].y, p[2].y});
    for (int y = pixel(y_first); y <= pixel(y_last); ++y) {
      for (int x = pixel(x_first); x <= pixel(x_last); ++x) {
        std::array<double, 3> share;
        for (int i = 0; i < 3; ++i) {
          const Vec3 &from = p[(i + 1) % 3], &to = p[(i + 2) % 3];
          share[i] = ((to.x - from.x) * (y + 0.5 - from.y) - (to.y - from.y) * (x + 0.5 - from.x)) / area;
        }
        if (std::min({share[0], share[1], share[2]}) < 0) continue;
        const double depth = share[0] * p[0].z + share[1] * p[1].z + share[2] * p[2].z;
        if (depth <= depth_(x, y)) continue;
        depth_(x, y) = depth;
        color_(x, y) = static_cast<float>(share[0]) * a.color + static_cast<float>(share[1]) * b.color +
                       static_cast<float>(share[2]) * c.color;
      }
    }
  }

  /// The mean of each block of pixels.
  Image<Rgb> shrunk(int factor) const {
    const int size = color_.width() / factor;
    Image<Rgb> result(size, size);
    for (int y = 0; y < size * factor; ++y) {
      for (int x = 0; x < size * factor; ++x) {
        result(x / factor, y / factor) += (1.0f / static_cast<float>(factor * factor)) * color_(x, y);
      }
    }
    return result;
  }

 private:
  Vec3 placed(const Vertex& v) const {
    const double middle = color_.width() / 2.0;
    return {middle + unit_ * v.position.x, middle - unit_ * v.position.y, unit_ * v.position.z};
  }
  int pixel(double at) const { return std::clamp(static_cast<int>(std::floor(at)), 0, color_.width() - 1); }

  Image<Rgb> color_;
  Grid<double> depth_;
  double unit_;
};

/// Vertices in rings from pole to pole: enough that a facet is a few pixels at most, however many the lobes.
Grid<Vertex> mesh_of(const Sh<double>& f, const View& view, int size_px) {
  const int rings = std::max(48, size_px * 3 / 4);
  Grid<Vertex> mesh(2 * rings + 1, rings + 1);
  for (int j = 0; j <= rings; ++j) {
    const double theta = kPi * j / rings;
    for (int i = 0; i < mesh.width(); ++i) {
      const double phi = kPi * i / rings;
      mesh(i, j) =
          vertex_at(f, {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}, view);
    }
  }
  return mesh;
}

}  // namespace

Image<Rgb> basis_shape(const Sh<double>& f, const BasisShapeOptions& options) {
  check(options.size_px >= 1, "a shape needs pixels");
  for (const double value : f.values()) check(std::isfinite(value), "a shape needs finite coefficients");
  const Grid<Vertex> mesh = mesh_of(f, view_of(options), options.size_px);
  double reach = options.reach;
  if (reach == 0) {
    for (const Vertex& vertex : mesh.values()) reach = std::max(reach, length(vertex.position));
  }
  Canvas canvas(kSupersample * options.size_px, reach > 0 ? reach : 1, options.paper);
  for (int j = 0; j + 1 < mesh.height(); ++j) {
    for (int i = 0; i + 1 < mesh.width(); ++i) {
      canvas.triangle(mesh(i, j), mesh(i + 1, j), mesh(i, j + 1));
      canvas.triangle(mesh(i + 1, j), mesh(i + 1, j + 1), mesh(i, j + 1));
    }
  }
  return canvas.shrunk(kSupersample);
}

}  // namespace zonal
