#include <array>
#include <cmath>
#include <cstdint>

#include "zonal/base/check.h"
#include "zonal/view/mesh.h"

namespace zonal {
namespace {

constexpr double kHeadRadius = 0.16, kHeadLength = 0.42, kShaftRadius = 0.06;

/// Half of the outline: radius and height.
struct Outline {
  double r, z;
};
constexpr std::array<Outline, 5> kOutline = {
    {{0, 0}, {kHeadRadius, kHeadLength}, {kShaftRadius, kHeadLength}, {kShaftRadius, 1}, {0, 1}}};

}  // namespace

Mesh arrow_mesh(int detail) {
  check(detail >= 8, "a shape of at least eight steps around");
  Mesh mesh;
  const auto f = [](double x) { return static_cast<float>(x); };
  // Each piece of the outline goes around by itself: its normals are not those of the next one.
  for (std::size_t piece = 0; piece + 1 < kOutline.size(); ++piece) {
    const Outline from = kOutline[piece], to = kOutline[piece + 1];
    const double dr = to.r - from.r, dz = to.z - from.z, length = std::hypot(dr, dz);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i <= detail; ++i) {
      const double turn = static_cast<double>(i) / detail, c = std::cos(2 * kPi * turn), s = std::sin(2 * kPi * turn);
      for (const Outline& end : {from, to}) {
        mesh.vertices.push_back({{f(end.r * c), f(end.r * s), f(end.z)},
                                 {f(dz / length * c), f(dz / length * s), f(-dr / length)},
                                 {f(turn), f(end.z)}});
      }
    }
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(detail); ++i) {
      const std::uint32_t a = first + 2 * i, b = a + 1, c = a + 2, d = a + 3;
      for (const std::uint32_t index : {a, c, b, b, c, d}) mesh.indices.push_back(index);
    }
  }
  return mesh;
}

}  // namespace zonal
