#include "zonal/report/bake.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "zonal/base/error.h"
#include "zonal/image/compare.h"
#include "zonal/light/convolve.h"
#include "zonal/light/dfg.h"
#include "zonal/light/partial.h"
#include "zonal/light/project.h"
#include "zonal/light/render.h"
#include "zonal/light/resample.h"
#include "zonal/report/bake_pictures.h"
#include "zonal/report/bake_verify.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr Projection kCube = {Layout::kCubeStack};
constexpr int kSmallestLevelPx = 16;
constexpr int kMostFits = 6;
// A lobe that is sharper shows the environment itself, and has no parameter in its domain.
constexpr double kSharpest = 0.01;

/// Wall time of the stages, one after the other.
class Stopwatch {
 public:
  explicit Stopwatch(std::vector<Timing>& timings) : timings_(timings) {}
  void done(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    timings_.push_back({stage, std::chrono::duration<double>(now - last_).count()});
    last_ = now;
  }

 private:
  std::vector<Timing>& timings_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void require(bool ok, const std::string& message, const std::string& hint) {
  if (!ok) throw Error(ErrorKind::kUsage, message, hint);
}

void check_options(const BakeOptions& options, int levels) {
  require(options.size_px >= 1 && options.size_px <= 8192, "the size must be 1 to 8192 pixels", "256 is usual");
  require(levels >= 1 && (options.size_px >> (levels - 1)) >= 1,
          std::to_string(levels) + " levels do not fit into " + std::to_string(options.size_px) + " pixels",
          "halve until 1 is reached");
  require(options.irradiance_px >= 1 && options.irradiance_px <= 8192, "the irradiance map must have 1 to 8192 pixels",
          "64 is plenty");
  require(options.bands >= 1 && options.bands <= 1024, "the number of bands must be 1 to 1024",
          "3 is usual for irradiance");
}

/// The environment and, where only a part of it is shown, its mask, ready for the same lobes.
class Convolver {
 public:
  Convolver(const Environment& environment, const Environment* shown, const std::vector<Lobe>& lobes, const Run& run)
      : light_(environment, lobes, {}, run) {
    if (shown) mask_.emplace(*shown, lobes, ConvolveOptions{}, run);
  }

  Convolved render(int lobe, ImageSize size, const Run& run) const {
    Convolved result = light_.render(lobe, kCube, size, run);
    if (mask_) renormalise(result, mask_->render(lobe, kCube, size, run));
    return result;
  }

 private:
  Convolution light_;
  std::optional<Convolution> mask_;
};

void scale(Environment& map, float factor) {
  for (Rgb& texel : map.radiance.values()) texel = factor * texel;
}

/// How close irradiance from few bands comes to the exact map.
ShFit fit_with(int bands, const Sh<RgbD>& radiance, const Environment& exact, const std::vector<double>& solid_angles,
               double maximum, const Run& run) {
  const ImageSize size{exact.radiance.width(), exact.radiance.height()};
  ShFit fit{bands, render(irradiance(with_bands(radiance, bands)), exact.projection, size, run)};
  const Comparison error = compare(fit.irradiance.radiance, exact.radiance, solid_angles);
  if (maximum > 0) fit.rms = error.rmse / maximum, fit.worst = error.max_error / maximum;
  return fit;
}

std::vector<ShFit> fits_of(const Sh<RgbD>& radiance, const Environment& exact, const Run& run) {
  const auto& map = exact.radiance;
  const Mapping mapping(exact.projection, {map.width(), map.height()});
  std::vector<double> solid_angles;
  double maximum = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      solid_angles.push_back(mapping.solid_angle(x, y));
      maximum = std::max(maximum, static_cast<double>(max_channel(map(x, y))));
    }
  }
  std::vector<ShFit> fits;
  for (int bands = 1; bands <= kMostFits; ++bands)
    fits.push_back(fit_with(bands, radiance, exact, solid_angles, maximum, run));
  return fits;
}

}  // namespace

int default_levels(int size_px) {
  int levels = 1;
  while ((size_px >> levels) >= kSmallestLevelPx) ++levels;
  return levels;
}

Image<Rgb> multiscatter_from_standard(Image<Rgb> table) {
  for (Rgb& texel : table.values()) texel = {texel.g, texel.r + texel.g, texel.b};
  return table;
}

Bake bake(const Environment& environment, const Environment* shown, const BakeOptions& options, bool verified,
          const Run& run) {
  const int levels = options.levels > 0 ? options.levels : default_levels(options.size_px);
  check_options(options, levels);
  Bake result;
  Stopwatch watch(result.timings);

  std::vector<Lobe> lobes = {Lobe::cosine()};
  for (int i = 0; i < levels; ++i) {
    ChainLevel level;
    level.roughness = i == 0 ? 0 : roughness_of_level(options.roughness_map, i, levels);
    level.alpha = alpha_from_roughness(level.roughness);
    if (level.roughness >= kSharpest) lobes.push_back(lobe_for_roughness(options.lobe, level.roughness));
    result.chain.push_back(std::move(level));
  }
  const Convolver convolver(environment, shown, lobes, run);
  watch.done("analyse");

  int next_lobe = 1;
  std::vector<int> lobe_of_level;
  for (int i = 0; i < levels; ++i) {
    ChainLevel& level = result.chain[i];
    const ImageSize size = image_size(kCube.layout, options.size_px >> i);
    lobe_of_level.push_back(level.roughness >= kSharpest ? next_lobe++ : 0);
    if (lobe_of_level[i] == 0) {
      level.map = resample(environment, kCube, size, {}, run);
    } else {
      Convolved convolved = convolver.render(lobe_of_level[i], size, run);
      level.map = std::move(convolved.map), level.report = convolved.report;
    }
    if (i == 0) watch.done("environment cube");
  }
  watch.done("specular chain");

  Convolved convolved = convolver.render(0, image_size(kCube.layout, options.irradiance_px), run);
  result.irradiance = std::move(convolved.map), result.irradiance_report = convolved.report;
  // The centres of one-texel faces are the axes.
  const Environment axes = convolver.render(0, image_size(kCube.layout, 1), run).map;
  const Mapping axis_of(kCube, image_size(kCube.layout, 1));
  const Texel up = axis_of.nearest({0, 0, 1}), down = axis_of.nearest({0, 0, -1});
  result.irradiance_up = kPi * RgbD(axes.radiance(up.x, up.y));
  result.irradiance_down = kPi * RgbD(axes.radiance(down.x, down.y));
  scale(result.irradiance, static_cast<float>(kPi));
  result.irradiance_report.error_bound *= kPi;
  watch.done("irradiance");

  result.radiance = project(environment, std::max(options.bands, kMostFits), run);
  if (shown) {
    // What is left out is like the mean of the rest, for the coefficients as a whole.
    const double share = project(*shown, 1, run)(0, 0).r / std::sqrt(4 * kPi);
    if (share > 0) result.radiance *= 1 / share;
  }
  result.fits = fits_of(result.radiance, result.irradiance, run);
  result.radiance = with_bands(result.radiance, options.bands);
  watch.done("spherical harmonics");

  result.split_sum = dfg_table(options.table_px, DfgVariant::kStandard, run);
  watch.done("split-sum table");

  const int rows = std::min(kPagePanoramaHeight, std::max(16, environment.radiance.height()));
  result.panorama = resample(environment, {Layout::kEquirect}, rows, {}, run);
  watch.done("panorama");

  if (verified && !shown) {
    const bool bounded = environment.projection.layout == Layout::kEquirect;
    for (int i = 0; i < levels; ++i) {
      ChainLevel& level = result.chain[i];
      if (lobe_of_level[i] == 0) continue;
      level.verified = verify(environment, lobes[lobe_of_level[i]], level.map, level.report, {.bounded = bounded}, run);
    }
    result.irradiance_verified =
        verify(environment, lobes[0], result.irradiance, convolved.report, {.factor = kPi, .bounded = bounded}, run);
    watch.done("verification");
  }
  return result;
}

}  // namespace zonal
