#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/light/sample.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/iso_lines.h"
#include "zonal/report/picture_sheet.h"
#include "zonal/report/sphere_disc.h"
#include "zonal/report/text.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/minimum.h"
#include "zonal/sh/nonnegative.h"
#include "zonal/sh/peaks.h"
#include "zonal/sh/window.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

constexpr int kSizePx = 288;
/// The width at which the paper compares windows: a delta of 6 bands is 2.25 high under it.
constexpr double kNarrowWidth = 12.0105;

std::string name_of(const Window& window) {
  return window.kind() == WindowKind::kNone ? "no window needed" : fmt::format("Hann, width {:.4g}", window.amount());
}

/// The weakest window of Hann without negative values in any channel. `radiance` has no channel of negative mean.
PublishedNumber nonnegative_number(const Sh<RgbD>& radiance) {
  const NonNegativeOptions options;
  const NonNegativeWindow found = nonnegative_window(radiance, options);
  const RgbD mean = (1 / (2 * std::sqrt(kPi))) * radiance[0];
  const double least = std::min(0.0, found.minimum_found), largest = max_channel(mean);
  return {fmt::format("Least value under the weakest Hann window without negative ones ({}), over the mean",
                      name_of(found.window)),
          "", largest > 0 ? least / largest : 0, 0, options.tolerance};
}

struct Extent {
  double least = 0, most = 0, negative_share = 0;
};

/// What can be said of a function's values: to a thousandth, by its peaks and by 20000 points.
Extent extent_of(const Sh<double>& light) {
  const Peaks peaks = find_peaks(light);
  Extent extent = {peaks.minima[0].value, peaks.maxima[0].value, 0};
  const Sh<double, kGalleryBands> fixed = with_bands<kGalleryBands>(light);
  int negative = 0;
  constexpr int kPoints = 20000;
  for (const Vec3 d : spiral_directions(kPoints)) negative += evaluate(fixed, d) < 0;
  extent.negative_share = static_cast<double>(negative) / kPoints;
  return extent;
}

std::string words_for(const Extent& extent) {
  if (extent.negative_share == 0) return "nowhere negative";
  return fmt::format("negative on {},\nto {} of the peak", percent(extent.negative_share, 2),
                     extent.most > 0 ? percent(extent.least / extent.most, 2) : "—");
}

double delta_height(const Window& window) {
  Sh<double> delta(kGalleryBands);
  const std::vector<double> zonal = delta_zonal(kGalleryBands);
  for (int l = 0; l < kGalleryBands; ++l) delta(l, 0) = zonal[static_cast<std::size_t>(l)];
  return evaluate(zonal::window(delta, window), {0, 0, 1});
}

}  // namespace

GalleryFigure windowed_probe_figure(const ShownProbe& probe) {
  const Window smooth = Window::hann(kGalleryBands), narrow = Window::hann(kNarrowWidth);
  const Sh<RgbD> plain = probe.radiance;
  const Sh<RgbD> smoothed = window(plain, smooth), narrowed = window(plain, narrow);
  const Extent whole = extent_of(luminance(plain));
  const IsoScale scale = {std::max(std::abs(whole.least), std::abs(whole.most)), (whole.most - whole.least) / 16};

  const auto picture = [&](const Sh<RgbD>& light) {
    return tonemap(draw_sphere_disc(seen(light, probe.world_from_view), kSizePx), probe.curve);
  };
  const auto lines = [&](const Sh<RgbD>& light) -> SheetCell {
    const Sh<double> bright = luminance(light);
    return {iso_lines(draw_sphere_disc(seen(bright, probe.world_from_view), kSizePx), scale),
            words_for(extent_of(bright))};
  };
  const Sampler sampler(probe.map);
  const Image<Rgb> original = draw_sphere_disc([&](Vec3 d) { return sampler(probe.world_from_view * d); }, kSizePx, 3);
  const Image<Rgb8> key = iso_key(scale, kSizePx, kSizePx / 8);

  PictureSheet sheet = {.name = "windowed-probe",
                        .description =
                            "A light probe in 6 bands, without a window, with a smoothing window and with a "
                            "weaker one, each as a picture and as iso-lines of its luminance in which negative "
                            "regions are blue.",
                        .rows = {{"As projected, without a window", {}}, {"Windowed", {}}}};
  sheet.rows[0].cells = {lines(plain),
                         {picture(plain), "6 bands"},
                         {tonemap(original, probe.curve), "the probe"},
                         {key, "below zero · zero · above", false}};
  sheet.rows[1].cells = {lines(smoothed),
                         {picture(smoothed), fmt::format("smoother:\n{}", name_of(smooth))},
                         {picture(narrowed), fmt::format("less blur:\n{}", name_of(narrow))},
                         lines(narrowed)};

  GalleryFigure figure;
  figure.id = sheet.name;
  figure.title = "A probe under two windows, with its negative regions";
  figure.source = "Sloan 2008, “Windowing” (figure of four columns of a real lighting environment) and footnote 12";
  figure.pictures = {{.name = sheet.name, .alt = sheet.description, .svg = picture_sheet(sheet)}};
  figure.caption =
      "The outer columns are iso-lines of the luminance of the picture beside them, in steps of a sixteenth of the "
      "range without a window; all blue is negative. On the left Hann’s window falls to zero at the first band that "
      "is not there, on the right it is the wider one of the paper’s footnote. All in 6 bands.";

  const double brightness = std::max(scale.limit, 1e-300);
  figure.numbers.push_back(
      {"Height of a delta function of 6 bands under Hann, width 12.0105", "2.25", delta_height(narrow), 2.25, 5e-5});
  const auto add_least = [&](const std::string& what, const Sh<RgbD>& light) {
    const Sh<double> bright = luminance(light);
    const double tolerance = 1e-6;
    const Minimum least = certified_minimum(bright, {.tolerance = tolerance * brightness});
    // Two searches of different kinds: one with a proof, one from many starts.
    figure.numbers.push_back({fmt::format("Least luminance over the greatest of all, {}", what), "",
                              least.found / brightness, extent_of(bright).least / brightness, tolerance});
  };
  add_least("no window", plain);
  add_least(name_of(narrow), narrowed);
  add_least(name_of(smooth), smoothed);
  if (std::min({plain[0].r, plain[0].g, plain[0].b}) >= 0) figure.numbers.push_back(nonnegative_number(plain));
  return figure;
}

}  // namespace zonal
