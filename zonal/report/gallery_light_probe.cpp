#include <fmt/format.h>

#include <array>
#include <cmath>

#include "zonal/light/sample.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/picture_sheet.h"
#include "zonal/report/sphere_disc.h"
#include "zonal/report/text.h"
#include "zonal/sh/eval.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr int kSizePx = 200;

double square(RgbD c) { return c.r * c.r + c.g * c.g + c.b * c.b; }

/// Integrals over the sphere by the texels of a probe.
struct Measured {
  double squared = 0;                           ///< of the radiance squared, all channels
  std::array<double, kGalleryBands> left = {};  ///< of what 1, 2, ... bands leave of it, squared
  double mean_luminance = 0;
};

Measured measure(const ShownProbe& probe) {
  const Image<Rgb>& texels = probe.map.radiance;
  const Mapping mapping(probe.map.projection, {texels.width(), texels.height()});
  Sh<double, kGalleryBands> y;
  Measured sum;
  for (int j = 0; j < texels.height(); ++j) {
    const double weight = mapping.solid_angle(0, j);
    for (int i = 0; i < texels.width(); ++i) {
      const RgbD radiance(texels(i, j));
      basis(kGalleryBands, *mapping.direction({i + 0.5, j + 0.5}), y.values());
      sum.squared += weight * square(radiance);
      sum.mean_luminance += weight / (4 * kPi) * luminance(radiance);
      RgbD fit;
      for (int l = 0; l < kGalleryBands; ++l) {
        for (int k = l * l; k < (l + 1) * (l + 1); ++k) fit += y[k] * probe.radiance[k];
        sum.left[static_cast<std::size_t>(l)] += weight * square(radiance - fit);
      }
    }
  }
  return sum;
}

}  // namespace

GalleryFigure probe_bands_figure(const ShownProbe& probe) {
  const Measured measured = measure(probe);
  const auto share_of = [&](double part) { return measured.squared > 0 ? part / measured.squared : 0; };

  // Texel areas integrate products of the basis to (pi bands/rows)^2/6.
  constexpr double kTolerance = 1e-3;

  GalleryFigure figure;
  SheetRow row;
  double held = 0;
  for (int bands = 1; bands <= kGalleryBands; ++bands) {
    const Sh<RgbD> fit = with_bands(probe.radiance, bands);
    const Image<Rgb> disc = draw_sphere_disc(seen(fit, probe.world_from_view), kSizePx);
    row.cells.push_back({tonemap(disc, probe.curve), fmt::format("{} band{}", bands, bands == 1 ? "" : "s")});
    for (const RgbD& value : fit.band(bands - 1)) held += square(value);
    figure.numbers.push_back(
        {fmt::format("Share of the squared radiance that {} band{} hold{}: 1 − error², against Σ c²", bands,
                     bands == 1 ? "" : "s", bands == 1 ? "s" : ""),
         "", measured.squared > 0 ? 1 - share_of(measured.left[static_cast<std::size_t>(bands - 1)]) : 0,
         share_of(held), kTolerance});
  }
  const Sampler sampler(probe.map);
  const Image<Rgb> disc = draw_sphere_disc([&](Vec3 d) { return sampler(probe.world_from_view * d); }, kSizePx, 3);
  row.cells.push_back({tonemap(disc, probe.curve), "the probe"});

  const double mean = luminance(probe.radiance[0]) / (2 * std::sqrt(kPi));
  figure.numbers.push_back({"Coefficients of 6 bands", "n²", static_cast<double>(probe.radiance.size()), 36, 0});
  figure.numbers.push_back({"First coefficient over 2√π, in luminance", "the mean", mean, measured.mean_luminance,
                            1e-6 * std::abs(measured.mean_luminance)});  // pixels are floats

  const PictureSheet sheet = {.name = "probe-bands",
                              .description =
                                  "Seven discs, each the whole sphere around the viewer: a light probe from "
                                  "1 to 6 bands of spherical harmonics, ever sharper, and the probe itself.",
                              .rows = {row}};
  figure.id = sheet.name;
  figure.title = "A light probe in 1 to 6 bands";
  figure.source = "Sloan 2008, “Projection from cube maps” (figure of orders 1 to 6)";
  figure.pictures = {{.name = sheet.name, .alt = sheet.description, .svg = picture_sheet(sheet)}};
  figure.caption = fmt::format(
      "Each disc shows all directions: toward the viewer in the middle, away from it at the rim. The viewer has the "
      "strongest light 45° to the right. All at {}{} stops (the mean of the probe’s luminance at 1/3; extended "
      "Reinhard curve), negative values black.",
      probe.curve.exposure_ev > 0 ? "+" : "", number(probe.curve.exposure_ev, 2));
  return figure;
}

}  // namespace zonal
