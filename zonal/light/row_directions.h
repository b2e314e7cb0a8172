#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "zonal/math/vec.h"
#include "zonal/sphere/cube.h"
#include "zonal/sphere/frame.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// The directions of one row of a picture as three arrays, for loops over lanes. A texel whose centre shows nothing has
/// shown[x] = 0 and the direction +Z.
struct RowDirections {
  explicit RowDirections(int width) : x(width), y(width), z(width), shown(width) {}

  void set_row(const Mapping& mapping, int row) {
    if (mapping.projection().layout == Layout::kCubeStack) {
      set_cube_row(mapping.size().width, row);
      return;
    }
    mapping.visit([&](const auto& map) {
      for (int i = 0; i < static_cast<int>(x.size()); ++i) {
        const auto direction = map.direction({i + 0.5, row + 0.5});
        const Vec3 d = direction.value_or(Vec3{0, 0, 1});
        x[i] = d.x, y[i] = d.y, z[i] = d.z;
        shown[i] = direction.has_value();
      }
    });
  }

  void blacken_hidden(std::span<Rgb> texels) const {
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if (!shown[i]) texels[i] = Rgb{};
    }
  }

  std::vector<double> x, y, z;
  std::vector<char> shown;

 private:
  /// The most common target: before its length is taken out, the direction is a straight line along the row.
  void set_cube_row(int face_size, int row) {
    const int face = row / face_size;
    const double v = (2 * (row % face_size) + 1.0) / face_size - 1;
    const Vec3 start = world_from_sampler(sampler_direction({face, -1, v}));
    const Vec3 step = world_from_sampler(sampler_direction({face, 1, v})) - start;
    for (int i = 0; i < face_size; ++i) {
      const double t = (i + 0.5) / face_size;
      const double dx = start.x + t * step.x, dy = start.y + t * step.y, dz = start.z + t * step.z;
      const double scale = 1 / std::sqrt(dx * dx + dy * dy + dz * dz);
      x[i] = scale * dx, y[i] = scale * dy, z[i] = scale * dz;
    }
    std::fill(shown.begin(), shown.end(), true);
  }
};

}  // namespace zonal
