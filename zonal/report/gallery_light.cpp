#include "zonal/report/gallery_light.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/image/color.h"
#include "zonal/light/project.h"
#include "zonal/light/resample.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

void check_finite(const Environment& probe) {
  const auto finite = [](Rgb c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); };
  if (std::ranges::all_of(probe.radiance.values(), finite)) return;
  throw Error(ErrorKind::kInput, "the probe has values that are not finite numbers", "repair them first (--fix)");
}

/// A probe that is constant but for the rounding of its pixels is constant: nobody should look for lights in that.
Sh<RgbD> without_rounding(Sh<RgbD> radiance) {
  double mean = 0, rest = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const double square = luminance(radiance[i] * radiance[i]);
    (i == 0 ? mean : rest) += square;
  }
  if (std::sqrt(rest) > 1e-6 * std::sqrt(mean)) return radiance;
  return with_bands(with_bands(radiance, 1), radiance.bands());
}

/// The viewer stands on the horizon, so that the light that dominates comes from 45 degrees to the right.
Rotation view_of(const Sh<RgbD>& radiance) {
  const Sh<double> light = luminance(radiance);
  const double x = light(1, 1), y = light(1, -1);
  if (!(std::hypot(x, y) > 1e-6 * std::abs(light[0]))) return {};  // light from above, or from everywhere
  return Rotation::about_z(std::atan2(y, x) - kPi / 4);
}

/// The mean, which every number of bands keeps, is shown at a third: few bands spread about it, however dark the most
/// of the probe is beside its lights. Black has no exposure.
double exposure_of(const Sh<RgbD>& radiance) {
  const double mean = luminance(radiance[0]) / (2 * std::sqrt(kPi));
  return mean > 0 ? std::clamp(std::log2(kShownMean / mean), -100.0, 100.0) : 0;
}

}  // namespace

ShownProbe shown_probe(const Environment& probe, const Run& run) {
  check_finite(probe);
  ShownProbe shown;
  shown.map = resample(probe, {Layout::kEquirect}, kProbeRows, {}, run);
  shown.radiance = without_rounding(project(shown.map, kGalleryBands, run));
  shown.curve.exposure_ev = exposure_of(shown.radiance);
  shown.world_from_view = view_of(shown.radiance);
  return shown;
}

std::function<Rgb(Vec3)> seen(const Sh<RgbD>& sh, const Rotation& world_from_view) {
  check(sh.bands() <= kGalleryBands, "the gallery shows few bands");
  return [fixed = with_bands<kGalleryBands>(sh), world_from_view](Vec3 toward) {
    return Rgb(evaluate(fixed, world_from_view * toward));
  };
}

std::function<double(Vec3)> seen(const Sh<double>& sh, const Rotation& world_from_view) {
  check(sh.bands() <= kGalleryBands, "the gallery shows few bands");
  return [fixed = with_bands<kGalleryBands>(sh), world_from_view](Vec3 toward) {
    return evaluate(fixed, world_from_view * toward);
  };
}

Sh<double> luminance(const Sh<RgbD>& sh) {
  Sh<double> light(sh.bands());
  for (std::size_t i = 0; i < sh.size(); ++i) light[i] = luminance(sh[i]);
  return light;
}

Image<Rgb8> displayed(const Image<Rgb>& linear) {
  Image<Rgb8> picture(linear.width(), linear.height());
  std::ranges::transform(linear.values(), picture.values().begin(), [](Rgb c) {
    return Rgb8{srgb8(c.r), srgb8(c.g), srgb8(c.b)};
  });
  return picture;
}

std::vector<GalleryFigure> gallery_lights(const Environment& probe, const Run& run) {
  const ShownProbe shown = shown_probe(probe, run);
  // In the order of the paper.
  const std::vector<std::function<GalleryFigure()>> draw = {
      [] { return rotating_light_figure(); },         [&] { return probe_bands_figure(shown); },
      [&] { return extracted_lights_figure(shown); }, [&] { return windowed_probe_figure(shown); },
      [] { return yellow_light_figure(); },           [] { return content_window_figure(); },
      [] { return hole_in_the_sky_figure(); },
  };
  std::vector<GalleryFigure> figures(draw.size());
  for_each_block(run, "gallery of lights", static_cast<int>(draw.size()), 1,
                 [&](Block block) { figures[block.index] = draw[block.index](); });
  return figures;
}

}  // namespace zonal
