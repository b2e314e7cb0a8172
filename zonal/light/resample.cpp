#include "zonal/light/resample.h"

#include <optional>

#include "zonal/base/check.h"
#include "zonal/base/parallel.h"
#include "zonal/light/resample_energy.h"
#include "zonal/light/resample_tiles.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

ImageSize size_of(const Environment& e) { return {e.radiance.width(), e.radiance.height()}; }

/// A mirror ball's picture and a sphere map are two names of one thing.
bool same_picture(const Projection& a, const Projection& b) {
  const auto is_ball = [](const Projection& p) {
    return p.layout == Layout::kMirrorBall || p.layout == Layout::kSphereMap;
  };
  return a == b || (is_ball(a) && is_ball(b) && a.lens == b.lens);
}

std::optional<Rgb> fill_for(const Environment& source, const Mapping& mapping, const ResampleOptions& options) {
  switch (options.uncovered) {
    case Uncovered::kRimMean:
      return mapping.covers_sphere() ? Rgb{} : rim_mean(source);
    case Uncovered::kConstant:
      return options.ground;
    case Uncovered::kNearest:
      return std::nullopt;
    case Uncovered::kBlack:
      break;
  }
  return Rgb{};
}

}  // namespace

Environment resample(const Environment& source, const Projection& to, ImageSize size, const ResampleOptions& options,
                     const Run& run) {
  check(options.supersample >= 0, "supersample must not be negative");
  const Mapping from(source.projection, size_of(source)), target(to, size);
  if (same_picture(source.projection, to) && size_of(source) == size &&
      options.world_from_source == Rotation::identity()) {
    return {source.radiance, to};
  }

  const Rotation source_from_target = transpose(options.world_from_source);
  const TileResampler tiles(source, target, source_from_target, options.supersample, fill_for(source, from, options),
                            run.isa);
  Environment result{Image<Rgb>(size.width, size.height), to};
  for_each_block(run, "resample", tiles.tiles_down(), 1, [&](Block block) {
    for (int column = 0; column < tiles.tiles_across(); ++column) {
      tiles.resample_tile(tiles.tile(column, block.index), result.radiance);
    }
  });
  if (target.covers_sphere()) keep_bright_texels(source, tiles, run, result);
  return result;
}

Environment resample(const Environment& source, const Projection& to, int size_px, const ResampleOptions& options,
                     const Run& run) {
  return resample(source, to, image_size(to.layout, size_px), options, run);
}

double coverage(const Projection& projection, ImageSize size) {
  const Mapping mapping(projection, size);
  double sum = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) sum += mapping.solid_angle(x, y);
  }
  return sum / (4 * kPi);
}

Rgb rim_mean(const Environment& e) {
  const Mapping mapping(e.projection, size_of(e));
  const auto shows = [&](int x, int y) { return mapping.direction(center_of({x, y})).has_value(); };
  RgbD rim, all;
  double rim_weight = 0, all_weight = 0;
  for (int y = 0; y < e.radiance.height(); ++y) {
    for (int x = 0; x < e.radiance.width(); ++x) {
      if (!shows(x, y)) continue;
      const double weight = mapping.solid_angle(x, y);
      const RgbD radiance(e.radiance(x, y));
      all += weight * radiance, all_weight += weight;
      // A rim texel has a neighbour that shows nothing; texels cut by the rim are left out, lenses blur into the black
      // there.
      if (shows(x - 1, y) && shows(x + 1, y) && shows(x, y - 1) && shows(x, y + 1)) continue;
      rim += weight * radiance, rim_weight += weight;
    }
  }
  if (mapping.covers_sphere() || rim_weight == 0) return all_weight > 0 ? Rgb((1 / all_weight) * all) : Rgb{};
  return Rgb((1 / rim_weight) * rim);
}

}  // namespace zonal
