#include "zonal/sphere/octahedral.h"

#include <array>
#include <cstddef>

#include "zonal/sphere/solid_triangle.h"

namespace zonal {
namespace {

struct Point {
  double u = 0, v = 0;
};

/// A convex polygon in the quadrant u, v >= 0.
struct Polygon {
  std::array<Point, 6> points;
  int count = 0;
  void add(Point p) { points[static_cast<std::size_t>(count++)] = p; }
};

/// The part with u + v <= 1 (Sutherland & Hodgman 1974).
Polygon below_diagonal(const Polygon& whole) {
  Polygon part;
  for (int i = 0; i < whole.count; ++i) {
    const Point a = whole.points[i], b = whole.points[(i + 1) % whole.count];
    const double da = (1 - a.u) - a.v, db = (1 - b.u) - b.v;
    if (da >= 0) part.add(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      const double t = da / (da - db);
      part.add({a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)});
    }
  }
  return part;
}

/// A quadrant mirrored in its diagonal, which takes the half that shows the lower hemisphere to the same octant's
/// mirror image above the equator: the same solid angle. Reversed, so that it keeps its orientation.
Polygon folded(Polygon p) {
  for (Point& q : p.points) q = {1 - q.v, 1 - q.u};
  std::reverse(p.points.begin(), p.points.begin() + p.count);
  return p;
}

/// In an octant the map is a central projection to the plane x + y + z = 1, so straight edges are arcs of great
/// circles, and the determinant of three points is twice their triangle's area in (u, v).
double solid_angle_in_octant(const Polygon& p) {
  const auto lift = [](Point q) { return Vec3{q.u, q.v, (1 - q.u) - q.v}; };
  double sum = 0;
  for (int i = 1; i + 1 < p.count; ++i) {
    const auto [a, b, c] = std::array{p.points[0], p.points[i], p.points[i + 1]};
    const double determinant = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    sum += solid_triangle(lift(a), lift(b), lift(c), determinant);
  }
  return sum;
}

struct Span {
  double low = 0, high = 0;
};

/// A texel's extent in |u|: the middle texel of an odd side lies on both sides of the crease and gives two spans.
struct Spans {
  std::array<Span, 2> spans;
  int count = 0;
};
Spans spans_of(int index, int side) {
  const double low = (2 * index - side) / static_cast<double>(side);
  const double high = (2 * index + 2 - side) / static_cast<double>(side);
  if (low >= 0) return {{{{low, high}, {}}}, 1};
  if (high <= 0) return {{{{-high, -low}, {}}}, 1};
  return {{{{0, -low}, {0, high}}}, 2};
}

}  // namespace

double Octahedral::solid_angle(int x, int y) const {
  const Spans across = spans_of(x, side_), down = spans_of(y, side_);
  double sum = 0;
  for (int i = 0; i < across.count; ++i) {
    for (int j = 0; j < down.count; ++j) {
      const auto [u0, u1] = across.spans[i];
      const auto [v0, v1] = down.spans[j];
      const Polygon rectangle{{{{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}, {}, {}}}, 4};
      sum += solid_angle_in_octant(below_diagonal(rectangle));
      sum += solid_angle_in_octant(below_diagonal(folded(rectangle)));
    }
  }
  return sum;
}

Texel OctahedralSquare::wrap(int /*chart*/, int x, int y) const {
  if (x < 0 || x >= side_) {
    x = x < 0 ? -1 - x : 2 * side_ - 1 - x;
    y = side_ - 1 - y;
  }
  if (y < 0 || y >= side_) {
    y = y < 0 ? -1 - y : 2 * side_ - 1 - y;
    x = side_ - 1 - x;
  }
  return {std::clamp(x, 0, side_ - 1), std::clamp(y, 0, side_ - 1)};
}

bool OctahedralSquare::regular(int /*chart*/, int x, int y, int size) const {
  if (x < 0 || y < 0 || x + size > side_ || y + size > side_) return false;
  // Twice the texel centres relative to the middle of the square: whole numbers, so the creases are decided exactly.
  const int u0 = 2 * x + 1 - side_, u1 = u0 + 2 * (size - 1);
  const int v0 = 2 * y + 1 - side_, v1 = v0 + 2 * (size - 1);
  if ((u0 < 0 && u1 > 0) || (v0 < 0 && v1 > 0)) return false;
  const auto [near_u, far_u] = std::minmax({std::abs(u0), std::abs(u1)});
  const auto [near_v, far_v] = std::minmax({std::abs(v0), std::abs(v1)});
  return far_u + far_v <= side_ || near_u + near_v >= side_;
}

}  // namespace zonal
