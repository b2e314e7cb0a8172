#include "zonal/sphere/cube.h"

#include "zonal/base/check.h"
#include "zonal/sphere/solid_triangle.h"

namespace zonal {
namespace {

/// The cell of each face +X -X +Y -Y +Z -Z.
struct Cells {
  int columns, rows;
  std::array<Texel, 6> cell;
  bool back_turned;
};

Cells cells_of(Layout layout) {
  switch (layout) {
    case Layout::kCubeStack:
      return {1, 6, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}, false};
    case Layout::kCubeRow:
      return {6, 1, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}, false};
    case Layout::kCubeCross:
      return {4, 3, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}, false};
    case Layout::kCubeCrossVertical:
      return {3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}}, true};
    case Layout::kCubeCrossVerticalUnrotated:
      return {3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}}, false};
    default:
      check(false, "not a cube layout");
      return {};
  }
}

}  // namespace

Cube::Cube(Layout layout, int face_size) : face_size_(face_size) {
  check(face_size > 0, "a cube's face must have texels");
  const Cells cells = cells_of(layout);
  columns_ = cells.columns;
  rows_ = cells.rows;
  face_in_cell_.fill(-1);
  for (int face = 0; face < 6; ++face) {
    const auto [column, row] = cells.cell[face];
    places_[face] = {column * face_size, row * face_size, face == 5 && cells.back_turned ? -1 : 1};
    face_in_cell_[row * columns_ + column] = face;
  }
}

double Cube::solid_angle(int x, int y) const {
  if (face_at(center_of({x, y})) < 0) return 0;
  // Two triangles in the plane at distance 1. Half turns do not change a solid angle, so the face's rotation is
  // ignored.
  const double step = 2.0 / face_size_;
  const double u0 = (2 * (x % face_size_) - face_size_) / static_cast<double>(face_size_), u1 = u0 + step;
  const double v0 = (2 * (y % face_size_) - face_size_) / static_cast<double>(face_size_), v1 = v0 + step;
  const Vec3 a{u0, v0, 1}, b{u1, v0, 1}, c{u1, v1, 1}, d{u0, v1, 1};
  return solid_triangle(a, b, c, step * step) + solid_triangle(a, c, d, step * step);
}

Texel Cube::nearest(Vec3 toward) const {
  const PixelPoint p = *position(toward);
  return {static_cast<int>(p.x), static_cast<int>(p.y)};
}

Texel Cube::wrap(int face, int x, int y) const {
  const Place& from = places_[face];
  const int last = face_size_ - 1;
  int i = x - from.x, j = y - from.y;
  if (i >= 0 && i <= last && j >= 0 && j <= last) return {x, y};
  if (from.sign < 0) i = last - i, j = last - j;

  // Beyond a corner there is no face: leave over the left or right edge.
  const bool over_side = i < 0 || i > last;
  if (over_side) j = std::clamp(j, 0, last);
  const int across = over_side ? i : j;
  const double along = (2 * (over_side ? j : i) + 1) / static_cast<double>(face_size_) - 1;
  const int depth = std::min(across < 0 ? -1 - across : across - face_size_, last);
  const double edge = across < 0 ? -1 : 1;

  // Folded over the edge, the place (edge, along) keeps its distance along the edge, and lies (2 depth + 1)/N beyond it
  // on the adjacent face, whose plane is spanned by this face's normal.
  const Vec3 normal = sampler_direction({face, 0, 0});
  const Vec3 on_edge = sampler_direction(over_side ? FacePoint{face, edge, along} : FacePoint{face, along, edge});
  const auto [to_face, u, v] = face_point(on_edge - ((2 * depth + 1) / static_cast<double>(face_size_)) * normal);

  const Place& to = places_[to_face];
  return {to.x + static_cast<int>((0.5 * to.sign * u + 0.5) * face_size_),
          to.y + static_cast<int>((0.5 * to.sign * v + 0.5) * face_size_)};
}

bool Cube::regular(int face, int x, int y, int size) const {
  const int i = x - places_[face].x, j = y - places_[face].y;
  return i >= 0 && j >= 0 && i + size <= face_size_ && j + size <= face_size_;
}

}  // namespace zonal
