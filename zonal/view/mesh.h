#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "zonal/math/vec.h"

namespace zonal {

/// A point of a surface, as the shaders take it.
struct Vertex {
  float position[3] = {}, normal[3] = {}, uv[2] = {};
};

/// Triangles, counterclockwise from outside, within the unit ball about the origin; +Z up.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// Shapes without a file, for light to be seen on. `detail` is the number of steps around, at least 8.
Mesh sphere_mesh(int detail = 96);
/// The (2, 3) torus knot: every direction of normal, and parts before parts.
Mesh torus_knot_mesh(int detail = 256);
/// A ball with bumps deep enough to stand before each other.
Mesh bumpy_mesh(int detail = 192);

/// A sign for light: a solid arrow along -Z, its tip at the origin, its tail at +Z 1; a cone on a cylinder.
Mesh arrow_mesh(int detail = 32);

/// "sphere", "torus-knot", "bumpy".
std::span<const std::string_view> mesh_shape_names();
/// std::logic_error for another name.
Mesh mesh_shape(std::string_view name);

}  // namespace zonal
