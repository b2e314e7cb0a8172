#include <array>
#include <cmath>
#include <functional>

#include "zonal/base/check.h"
#include "zonal/view/mesh.h"

namespace zonal {
namespace {

/// A surface over (u, v) in [0, 1]^2 as a grid of quads. The normal is the cross product of central differences, so a
/// shape is one function.
Mesh grid_mesh(int across, int down, const std::function<Vec3(double u, double v)>& at) {
  Mesh mesh;
  constexpr double kStep = 1e-4;
  for (int j = 0; j <= down; ++j) {
    for (int i = 0; i <= across; ++i) {
      const double u = static_cast<double>(i) / across, v = static_cast<double>(j) / down;
      // Off the poles of a ball, where all longitudes meet.
      const double inner = std::clamp(v, 2 * kStep, 1 - 2 * kStep);
      const Vec3 p = at(u, v), du = at(u + kStep, inner) - at(u - kStep, inner),
                 dv = at(u, inner + kStep) - at(u, inner - kStep);
      const Vec3 n = normalize(cross(dv, du));
      mesh.vertices.push_back({{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                               {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)},
                               {static_cast<float>(u), static_cast<float>(v)}});
    }
  }
  const auto row = static_cast<std::uint32_t>(across + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(down); ++j) {
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(across); ++i) {
      const std::uint32_t a = j * row + i, b = a + 1, c = a + row, d = c + 1;
      for (const std::uint32_t index : {a, c, b, b, c, d}) mesh.indices.push_back(index);
    }
  }
  return mesh;
}

/// u is the longitude, eastward; v runs from the top to the bottom.
Vec3 on_ball(double u, double v) {
  const double phi = 2 * kPi * u, theta = kPi * v;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Vec3 on_knot(double turn) {
  const double around = 2 * turn, beside = 3 * turn, r = 0.55 + 0.22 * std::cos(beside);
  return {r * std::cos(around), r * std::sin(around), 0.3 * std::sin(beside)};
}

constexpr std::array<std::string_view, 3> kNames = {"sphere", "torus-knot", "bumpy"};

}  // namespace

Mesh sphere_mesh(int detail) {
  check(detail >= 8, "a shape of at least eight steps around");
  return grid_mesh(detail, detail / 2, on_ball);
}

Mesh torus_knot_mesh(int detail) {
  check(detail >= 8, "a shape of at least eight steps around");
  constexpr double kThickness = 0.16;
  return grid_mesh(detail, detail / 8 + 8, [](double u, double v) {
    const double turn = 2 * kPi * u, step = 1e-4;
    const Vec3 center = on_knot(turn), along = normalize(on_knot(turn + step) - on_knot(turn - step));
    const Vec3 side = normalize(cross(along, {0, 0, 1})), up = cross(side, along);
    return center + kThickness * (std::cos(2 * kPi * v) * side + std::sin(2 * kPi * v) * up);
  });
}

Mesh bumpy_mesh(int detail) {
  check(detail >= 8, "a shape of at least eight steps around");
  return grid_mesh(detail, detail / 2, [](double u, double v) {
    const Vec3 d = on_ball(u, v);
    const double bumps = std::sin(5 * d.x + 1) * std::sin(6 * d.y) + std::sin(7 * d.z + 2) * std::cos(5 * d.x);
    return (0.72 + 0.14 * bumps) * d;
  });
}

std::span<const std::string_view> mesh_shape_names() { return kNames; }

Mesh mesh_shape(std::string_view name) {
  if (name == "sphere") return sphere_mesh();
  if (name == "torus-knot") return torus_knot_mesh();
  check(name == "bumpy", "there is no shape of this name");
  return bumpy_mesh();
}

}  // namespace zonal
