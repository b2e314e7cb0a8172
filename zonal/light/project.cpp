#include "zonal/light/project.h"

#include <vector>

#include "zonal/base/parallel.h"
#include "zonal/sh/eval.h"
#include "zonal/sht/transform.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr int kRowsPerBlock = 16;

/// Sums over texels of what they hold and of 1.
struct Sums {
  Sh<RgbD> light;
  Sh<double> one;
  explicit Sums(int bands) : light(bands), one(bands) {}
};

/// Texel by texel, for pictures whose rows are no rings.
Sums sum_texels(const Environment& environment, int bands, const Run& run) {
  const Image<Rgb>& map = environment.radiance;
  const Mapping mapping(environment.projection, {map.width(), map.height()});
  return reduce_blocks(
      run, "texels", map.height(), kRowsPerBlock, Sums(bands),
      [&](Block rows) {
        Sums sums(bands);
        std::vector<double> values(sums.one.size());
        for (int y = rows.begin; y < rows.end; ++y) {
          for (int x = 0; x < map.width(); ++x) {
            const std::optional<Vec3> toward = mapping.texel_direction(x, y);
            if (!toward) continue;
            const double solid_angle = mapping.solid_angle(x, y);
            const RgbD light = solid_angle * static_cast<RgbD>(map(x, y));
            basis(bands, *toward, std::span<double>(values));
            for (std::size_t i = 0; i < values.size(); ++i) {
              sums.light[i] += values[i] * light;
              sums.one[i] += values[i] * solid_angle;
            }
          }
        }
        return sums;
      },
      [](Sums& total, const Sums& part) {
        total.light += part.light;
        total.one += part.one;
      });
}

}  // namespace

Sh<RgbD> project(const Environment& environment, int bands, const Run& run) {
  check(bands >= 1, "project: bands must be at least 1");
  if (environment.projection.layout != Layout::kEquirect) {
    Sums sums = sum_texels(environment, bands, run);
    const Mapping mapping(environment.projection, {environment.radiance.width(), environment.radiance.height()});
    if (!mapping.covers_sphere()) return std::move(sums.light);
    const RgbD mean = 1 / sums.one[0] * sums.light[0];
    for (std::size_t i = 1; i < sums.light.size(); ++i) sums.light[i] = sums.light[i] - sums.one[i] * mean;
    return std::move(sums.light);
  }
  Sh<RgbD> light = analyze(environment.radiance, bands, RingWeights::kTexelArea, run);
  const RingGrid grid{environment.radiance.width(), environment.radiance.height()};
  const std::vector<double> one = grid.response_to_one(RingWeights::kTexelArea, bands);
  const RgbD mean = 1 / one[0] * light[0];
  for (int l = 1; l < bands; ++l) light(l, 0) = light(l, 0) - one[l] * mean;
  return light;
}

}  // namespace zonal
