#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/view/mesh.h"

namespace zonal {
namespace {

Vec3 at(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

// A closed surface of revolution: its volume by the divergence theorem is that of the polygon turned around, and each
// normal is on the outer side of its face.
TEST(MeshShapes, AnArrowIsAConeOnACylinderFacingOutward) {
  const Mesh arrow = arrow_mesh(32);
  double volume = 0, head = 0, shaft = 1, top = 0;
  for (std::size_t i = 0; i < arrow.indices.size(); i += 3) {
    const Vertex &a = arrow.vertices[arrow.indices[i]], &b = arrow.vertices[arrow.indices[i + 1]],
                 &c = arrow.vertices[arrow.indices[i + 2]];
    const Vec3 face = cross(at(b.position) - at(a.position), at(c.position) - at(a.position));
    volume += dot(at(a.position), cross(at(b.position), at(c.position))) / 6;
    if (length(face) < 1e-9) continue;  // at the ends, where a quad is a triangle
    for (const Vertex* v : {&a, &b, &c}) {
      EXPECT_NEAR(length(at(v->normal)), 1, 1e-6);
      EXPECT_GT(dot(normalize(face), at(v->normal)), 0.98);
    }
  }
  for (const Vertex& v : arrow.vertices) {
    const double r = std::hypot(v.position[0], v.position[1]);
    head = std::max(head, r);
    if (r > 0.01) shaft = std::min(shaft, r);
    top = std::max(top, 1.0 * v.position[2]);
    EXPECT_GE(v.position[2], 0);
  }
  EXPECT_EQ(top, 1);
  double base = 1;  // where the head ends
  for (const Vertex& v : arrow.vertices) {
    if (std::hypot(v.position[0], v.position[1]) > 0.99 * head) base = v.position[2];
  }
  const double circle = 32 / 2.0 * std::sin(2 * kPi / 32);  // pi, of a polygon
  EXPECT_NEAR(volume, circle * (head * head * base / 3 + shaft * shaft * (1 - base)), 1e-6);
  EXPECT_GT(volume, 0.01);
}

}  // namespace
}  // namespace zonal
