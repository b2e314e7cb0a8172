#include "zonal/view/reflection_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/light/lobe.h"
#include "zonal/light/lobe_lean.h"
#include "zonal/light/resample.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr int kLanes = 16;

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

Rgb mean_through_lobe(const Lights& lights, Vec3 view, Vec3 normal, float alpha) {
  const auto f = [](double value) { return static_cast<float>(value); };
  const float nx = f(normal.x), ny = f(normal.y), nz = f(normal.z), vx = f(view.x), vy = f(view.y), vz = f(view.z);
  const float a2 = alpha * alpha, nv = std::max(f(dot(normal, view)), 1e-3f);
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

/// What is there over what the split sum's map has there.
Rgb quotient(Rgb seen, Rgb above) {
  const auto channel = [](float a, float b) { return b > 0 ? std::min(a / b, kMostQuotient) : 1.0f; };
  return {channel(seen.r, above.r), channel(seen.g, above.g), channel(seen.b, above.b)};
}

void check_options(const ReflectionSpaceOptions& options) {
  const auto& all = options.roughnesses;
  if (all.front() >= 0.2 && all.back() <= 1 && std::ranges::is_sorted(all, std::less_equal()) && options.views >= 2 &&
      options.map_px >= 2) {
    return;
  }
  throw Error(ErrorKind::kUsage, "maps of reflection space of a size or a roughness that they cannot have",
              "ascending roughnesses from 0.2 to 1, two views and two texels a side at least");
}

/// Edges of an octahedral square are folded: the far half repeats the near one.
std::array<int, 2> folded(int x, int y, int nodes) {
  const int last = nodes - 1;
  if ((x == 0 || x == last) && (y == 0 || y == last)) return {0, 0};
  if ((x == 0 || x == last) && 2 * y > last) return {x, last - y};
  if ((y == 0 || y == last) && 2 * x > last) return {last - x, y};
  return {x, y};
}

}  // namespace

Image<Rgb> reflection_space_maps(const Environment& environment, const ReflectionSpaceOptions& options,
                                 const Run& run) {
  check_options(options);
  const Lights lights = lights_of(resample(environment, {Layout::kEquirect}, options.environment_rows, {}, run));
  const Mapping square({Layout::kOctahedral}, {1, 1});
  const int views = options.views, px = options.map_px, side = views * px,
            layers = static_cast<int>(options.roughnesses.size());
  const auto direction = [&](int x, int y, int nodes) {
    return *square.direction({x / (nodes - 1.0), y / (nodes - 1.0)});
  };
  std::vector<float> alphas;
  std::vector<LobeLean> leans;
  std::vector<Image<Rgb>> above;
  for (const double roughness : options.roughnesses) {
    const float alpha = alphas.emplace_back(static_cast<float>(alpha_from_roughness(roughness)));
    leans.emplace_back(alpha);
    Image<Rgb>& map = above.emplace_back(px, px);
    for (int y = 0; y < px; ++y) {
      for (int x = 0; x < px; ++x) {
        const Vec3 mean = direction(x, y, px);
        map(x, y) = mean_through_lobe(lights, mean, mean, alpha);
      }
    }
  }
  Image<Rgb> atlas(side, layers * side);
  const auto each_texel = [&](int row, bool repeats, auto&& set) {
    const int top = row - row % side;  // of the layer
    for (int column = 0; column < side; ++column) {
      const auto [i, j] = folded(column / px, (row - top) / px, views);
      const auto [x, y] = folded(column % px, row % px, px);
      const int from_column = i * px + x, from_row = top + j * px + y;
      const bool original = from_column == column && from_row == row;
      if (original != repeats) set(column, from_column, from_row);
    }
  };
  for_each_block(run, "reflection space", layers * side, 4, [&](Block block) {
    for (int row = block.begin; row < block.end; ++row) {
      const auto layer = static_cast<std::size_t>(row / side);
      each_texel(row, false, [&](int column, int, int) {
        const Vec3 view = direction(column / px, row % side / px, views);
        const Vec3 normal = leans[layer].normal(view, direction(column % px, row % px, px));
        atlas(column, row) =
            quotient(mean_through_lobe(lights, view, normal, alphas[layer]), above[layer](column % px, row % px));
      });
    }
  });
  for (int row = 0; row < layers * side; ++row) {
    each_texel(row, true, [&](int column, int x, int y) { atlas(column, row) = atlas(x, y); });
  }
  return atlas;
}

Image<Rgb> lean_picture() {
  constexpr int kColumns = 64, kRows = 21;
  constexpr double kSmoothest = 0.01;
  Image<Rgb> picture(kColumns, kRows);
  for (int y = 0; y < kRows; ++y) {
    const LobeLean lean(alpha_from_roughness(std::max(kSmoothest, y / (kRows - 1.0))));
    for (int x = 0; x < kColumns; ++x) {
      picture(x, y).r = static_cast<float>(lean.lean(std::acos(x / (kColumns - 1.0))));
    }
  }
  return picture;
}

}  // namespace zonal
