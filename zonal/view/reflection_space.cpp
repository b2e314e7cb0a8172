#include "zonal/view/reflection_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/light/lobe.h"
#include "zonal/light/resample.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr int kLanes = 16;
constexpr double kLeastCosine = 0.05;

/// The texels of a panorama as directions and powers; padded to whole lanes by texels without light.
struct Lights {
  std::vector<float> x, y, z, area, r, g, b;
};

Lights lights_of(const Environment& environment) {
  const Image<Rgb>& image = environment.radiance;
  const Mapping mapping(environment.projection, {image.width(), image.height()});
  Lights lights;
  const auto add = [&](Vec3 d, double area, Rgb radiance) {
    lights.x.push_back(static_cast<float>(d.x));
    lights.y.push_back(static_cast<float>(d.y));
    lights.z.push_back(static_cast<float>(d.z));
    lights.area.push_back(static_cast<float>(area));
    const Rgb power = static_cast<float>(area) * radiance;
    lights.r.push_back(power.r);
    lights.g.push_back(power.g);
    lights.b.push_back(power.b);
  };
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      add(*mapping.texel_direction(x, y), mapping.solid_angle(x, y), image(x, y));
    }
  }
  while (lights.x.size() % kLanes != 0) add({0, 0, 1}, 0, {});
  return lights;
}

/// The normal half way between two directions, but never seen at a flatter angle than kLeastCosine.
Vec3 normal_between(Vec3 view, Vec3 mirrored) {
  const Vec3 sum = view + mirrored;
  if (length(sum) >= 2 * kLeastCosine) return normalize(sum);
  Vec3 across = mirrored - dot(mirrored, view) * view;
  if (length(across) < 1e-9) across = cross(view, std::abs(view.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0});
  return kLeastCosine * view + std::sqrt(1 - kLeastCosine * kLeastCosine) * normalize(across);
}

Rgb mean_through_lobe(const Lights& lights, Vec3 view, Vec3 normal, float alpha) {
  const auto f = [](double value) { return static_cast<float>(value); };
  const float nx = f(normal.x), ny = f(normal.y), nz = f(normal.z), vx = f(view.x), vy = f(view.y), vz = f(view.z);
  const float a2 = alpha * alpha, nv = std::max(f(dot(normal, view)), f(kLeastCosine));
  const float masked_view = std::sqrt(nv * nv * (1 - a2) + a2);
  // Sums in lanes, so that the compiler can work on many texels at once.
  std::array<float, kLanes> weight = {}, r = {}, g = {}, b = {};
  for (std::size_t i = 0; i < lights.x.size(); i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const float x = lights.x[i + k], y = lights.y[i + k], z = lights.z[i + k];
      const float nl = std::max(nx * x + ny * y + nz * z, 0.0f), lv = vx * x + vy * y + vz * z;
      const float nh2 = (nl + nv) * (nl + nv) / std::max(2 + 2 * lv, 1e-6f);
      const float d = nh2 * (a2 - 1) + 1;
      const float w = nl / (d * d * (nl * masked_view + nv * std::sqrt(nl * nl * (1 - a2) + a2)));
      weight[k] += w * lights.area[i + k];
      r[k] += w * lights.r[i + k];
      g[k] += w * lights.g[i + k];
      b[k] += w * lights.b[i + k];
    }
  }
  double total = 0;
  RgbD sum;
  for (std::size_t k = 0; k < kLanes; ++k) {
    total += weight[k];
    sum += RgbD(r[k], g[k], b[k]);
  }
  return total > 0 ? Rgb((1 / total) * sum) : Rgb();
}

}  // namespace

Image<Rgb> reflection_space_maps(const Environment& environment, const ReflectionSpaceOptions& options,
                                 const Run& run) {
  if (!(options.roughness >= 0.2 && options.roughness <= 1) || options.views < 2 || options.map_px < 2) {
    throw Error(ErrorKind::kUsage, "maps of reflection space of a size or a roughness that they cannot have",
                "a roughness from 0.2 to 1, two views and two texels a side at least");
  }
  const Lights lights = lights_of(resample(environment, {Layout::kEquirect}, options.environment_rows, {}, run));
  const auto alpha = static_cast<float>(alpha_from_roughness(options.roughness));
  const Mapping square({Layout::kOctahedral}, {1, 1});
  const int views = options.views, px = options.map_px;
  const auto direction = [&](int x, int y, int nodes) {
    return *square.direction({x / (nodes - 1.0), y / (nodes - 1.0)});
  };
  // Edges of a square are folded: the far half repeats the near one.
  const auto folded = [](int x, int y, int nodes) -> std::array<int, 2> {
    const int last = nodes - 1;
    if ((x == 0 || x == last) && (y == 0 || y == last)) return {0, 0};
    if ((x == 0 || x == last) && 2 * y > last) return {x, last - y};
    if ((y == 0 || y == last) && 2 * x > last) return {last - x, y};
    return {x, y};
  };
  Image<Rgb> atlas(views * px, views * px);
  const auto each_texel = [&](int row, bool repeats, auto&& set) {
    for (int column = 0; column < views * px; ++column) {
      const auto [i, j] = folded(column / px, row / px, views);
      const auto [x, y] = folded(column % px, row % px, px);
      const int from_column = i * px + x, from_row = j * px + y;
      const bool original = from_column == column && from_row == row;
      if (original != repeats) set(column, from_column, from_row);
    }
  };
  for_each_block(run, "reflection space", views * px, 4, [&](Block block) {
    for (int row = block.begin; row < block.end; ++row) {
      each_texel(row, false, [&](int column, int, int) {
        const Vec3 view = direction(column / px, row / px, views);
        const Vec3 normal = normal_between(view, direction(column % px, row % px, px));
        atlas(column, row) = mean_through_lobe(lights, view, normal, alpha);
      });
    }
  });
  for (int row = 0; row < views * px; ++row) {
    each_texel(row, true, [&](int column, int x, int y) { atlas(column, row) = atlas(x, y); });
  }
  return atlas;
}

}  // namespace zonal
