#include "zonal/light/reference.h"

#include "zonal/base/parallel.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

namespace {

struct Sum {
  RgbD light;
  double weight = 0;
};

}  // namespace

std::vector<RgbD> convolve_at(const Environment& environment, const Lobe& lobe, std::span<const Vec3> directions,
                              const Run& run) {
  const Image<Rgb>& map = environment.radiance;
  const Mapping mapping(environment.projection, {map.width(), map.height()});
  constexpr int kRowsPerBlock = 16;
  const std::vector<Sum> sums = reduce_blocks(
      run, "reference", map.height(), kRowsPerBlock, std::vector<Sum>(directions.size()),
      [&](Block rows) {
        std::vector<Sum> part(directions.size());
        mapping.visit([&](const auto& geometry) {
          for (int y = rows.begin; y < rows.end; ++y) {
            for (int x = 0; x < map.width(); ++x) {
              const auto toward_texel = geometry.texel_direction(x, y);
              if (!toward_texel) continue;
              const double solid_angle = geometry.solid_angle(x, y);
              const RgbD radiance(map(x, y));
              for (std::size_t i = 0; i < directions.size(); ++i) {
                const Vec3 gap = *toward_texel - directions[i];
                const double weight = solid_angle * lobe.kernel_from_versine(0.5 * dot(gap, gap));
                part[i].light += weight * radiance;
                part[i].weight += weight;
              }
            }
          }
        });
        return part;
      },
      [](std::vector<Sum>& totals, const std::vector<Sum>& part) {
        for (std::size_t i = 0; i < part.size(); ++i) {
          totals[i].light += part[i].light;
          totals[i].weight += part[i].weight;
        }
      });
  std::vector<RgbD> means;
  for (const Sum& sum : sums) means.push_back((mapping.covers_sphere() ? 1 / sum.weight : 1) * sum.light);
  return means;
}

}  // namespace zonal
