#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "zonal/report/curve_plot.h"
#include "zonal/report/gallery_plots.h"
#include "zonal/report/polar_plot.h"
#include "zonal/sh/minimum.h"
#include "zonal/sh/window.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

constexpr int kBands = 6;
constexpr double kDeltaPeak = kBands * kBands / (4 * kPi);
constexpr double kOuterRing = 3;  // of all polar plots of the delta, so that they compare

Window hann(double width) { return Window::hann(width); }
Window lanczos(double width) { return Window::lanczos(width); }

/// The delta of 6 bands, windowed.
std::vector<double> delta(const Window& with) {
  std::vector<double> zonal = delta_zonal(kBands);
  const std::vector<double> factors = window_factors(with, kBands);
  for (std::size_t l = 0; l < zonal.size(); ++l) zonal[l] *= factors[l];
  return zonal;
}

double peak_of(const Window& with) { return evaluate_zonal(delta(with), 1); }

/// The width of a window with which the delta is `peak` high. The peak grows with the width.
double width_for_peak(Window (*window)(double width), double peak) {
  double low = 1, high = 100;
  for (double middle = (low + high) / 2; middle != low && middle != high; middle = (low + high) / 2) {
    (peak_of(window(middle)) < peak ? low : high) = middle;
  }
  return high;
}

GalleryFigure windows() {
  CurvePlot plot = {.title = "factor of band l, for 6 bands",
                    .description = "Two curves that fall from 1 to 0 over 6 bands, Hann’s faster than Lanczos’s.",
                    .x = {.label = "band l", .range = AxisRange{0, 6}, .marks = {0, 1, 2, 3, 4, 5, 6}},
                    .y = {.range = AxisRange{0, 1}, .marks = {0, 0.25, 0.5, 0.75, 1}},
                    .curves = {}};
  struct Shape {
    Window (*window)(double width);
    const char* name;
    Ink ink;
  };
  const std::array<Shape, 2> shapes = {Shape{lanczos, "Lanczos", Ink::kRed}, Shape{hann, "Hann", Ink::kBlue}};
  for (const auto& [window, name, ink] : shapes) {
    // Between the bands: l bands into a window of width w are one band into a window of width w/l.
    const auto between = [w = window](double l) { return l == 0 ? 1 : window_factor(w(kBands / l), 1); };
    Curve dots = {.name = "", .points = {}, .ink = ink, .dots = true};
    for (int l = 0; l <= kBands; ++l) dots.points.push_back({static_cast<double>(l), window_factor(window(kBands), l)});
    plot.curves.push_back({.name = name, .points = sampled(between, 0, kBands, 121), .ink = ink});
    plot.curves.push_back(std::move(dots));
  }
  GalleryFigure figure = {
      .id = "windows",
      .title = "Two windows",
      .source =
          "Sloan 2008, “Windowing”: the two windows for 6 bands, Lanczos’s in red and Hann’s in blue; footnote 12",
      .pictures = {{.name = "windows", .alt = plot.description, .svg = curve_plot(plot)}},
      .caption =
          "Coefficients of band l are scaled by the height of the dot above l. Both windows reach zero at the first "
          "band that is not used. Hann’s falls faster and blurs more; Lanczos’s squared falls a little faster than "
          "Hann’s.",
      .numbers = {
          // Half of the last digit printed.
          {"width of Hann’s window for a delta 2.25 high", "12.0105", width_for_peak(hann, 2.25), 12.0105, 5e-5},
          {"width of Lanczos’s window for the same", "9.8725", width_for_peak(lanczos, 2.25), 9.8725, 5e-5},
          {"height of the delta with Hann’s of 12.0105", "2.25", peak_of(hann(12.0105)), 2.25, 5e-3},
          {"height of the delta with Lanczos’s of 9.8725", "2.25", peak_of(lanczos(9.8725)), 2.25, 5e-3}}};
  int faster = 0;
  for (int l = 1; l < kBands; ++l) {
    if (window_factor(Window::lanczos(kBands, 2), l) < window_factor(hann(kBands), l)) ++faster;
  }
  figure.numbers.push_back(
      {"bands of 5 in which Lanczos’s squared is below Hann’s", "a little faster", static_cast<double>(faster), 5, 0});
  return figure;
}

struct Delta {
  const char* name;
  Window window;
  Ink ink;
};

GalleryPicture delta_picture(const std::string& name, const std::string& title, const Window& with) {
  const std::string alt = title + " of the delta in 6 bands in a polar plot: positive lobes red, negative ones blue.";
  const std::vector<double> zonal = delta(with);
  return {.name = name,
          .alt = alt,
          .svg = polar_plot(
              {.title = title,
               .description = alt,
               .curves = {{.name = "", .value = [=](double theta) { return evaluate_zonal(zonal, std::cos(theta)); }}},
               .radius = kOuterRing})};
}

GalleryPicture together(const std::string& name, const std::string& title, const std::vector<Delta>& deltas,
                        double radius) {
  PolarPlot plot = {.title = title,
                    .description = title + ": several windows of the delta in one polar plot, negative lobes dashed.",
                    .curves = {},
                    .radius = radius};
  for (const auto& [curve, window, ink] : deltas) {
    plot.curves.push_back(
        {.name = curve,
         .value = [zonal = delta(window)](double theta) { return evaluate_zonal(zonal, std::cos(theta)); },
         .positive = ink,
         .negative = ink,
         .filled = false});
  }
  return {.name = name, .alt = plot.description, .svg = polar_plot(plot)};
}

/// The deepest value of a function about +Z, seen by looking, and with proof.
PublishedNumber lowest_number(const std::string& what, const Window& with) {
  const std::vector<double> zonal = delta(with);
  double lowest = 0;
  for (const auto& [theta, value] :
       sampled([&](double t) { return evaluate_zonal(zonal, std::cos(t)); }, 0, kPi, 20001)) {
    lowest = std::min(lowest, value);
  }
  const Minimum proven = certified_minimum(zonal_toward(zonal, {0, 0, 1}), {.tolerance = 1e-7});
  // The samples miss the minimum by at most f''/2 (step/2)^2, f'' < 100.
  return {"lowest value, " + what, "", lowest, proven.found, 1e-6};
}

GalleryFigure delta_windows() {
  const std::vector<Delta> all = {{"raw", Window::none(), Ink::kRed},
                                  {"Lanczos", lanczos(kBands), Ink::kGreen},
                                  {"Hann", hann(kBands), Ink::kBlue}};
  return {
      .id = "delta-windows",
      .title = "A delta, windowed",
      .source =
          "Sloan 2008, “Windowing”: cross sections of the delta of order 6 with Lanczos’s and Hann’s factors, and "
          "all in one",
      .pictures = {delta_picture("delta-raw", "raw", Window::none()),
                   delta_picture("delta-lanczos", "Lanczos, width 6", lanczos(kBands)),
                   delta_picture("delta-hann", "Hann, width 6", hann(kBands)),
                   together("delta-windows", "all in one", all, kOuterRing),
                   together("delta-windows-near", "all in one, near the centre", all, 0.8)},
      .caption =
          "The peakiest function that 6 bands can hold, cut through its axis: the distance from the centre is the "
          "size of the function, red lobes are positive, blue dashed ones negative. In the plots of all, a curve’s "
          "negative lobes are dashed, and what is larger than the outer ring stands on it.",
      .numbers = {{"height of the raw delta", "", peak_of(Window::none()), kDeltaPeak, 1e-14},
                  {"raw, straight behind", "", evaluate_zonal(delta(Window::none()), -1), -kBands / (4 * kPi), 1e-14},
                  lowest_number("raw", Window::none()),
                  lowest_number("Lanczos", lanczos(kBands)),
                  lowest_number("Hann", hann(kBands))}};
}

/// The weight that leaves `fraction` of the delta's squared Laplacian.
double weight_for(double fraction) {
  return laplacian_weight(band_energies(zonal_toward(delta_zonal(kBands), {0, 0, 1})), fraction);
}

double fraction_left_by(double weight) {
  const Sh<double> raw = zonal_toward(delta_zonal(kBands), {0, 0, 1});
  return squared_laplacian(window(raw, Window::laplacian(weight))) / squared_laplacian(raw);
}

GalleryFigure laplacian() {
  const Window tenth = Window::laplacian(weight_for(0.1)), half = Window::laplacian(weight_for(0.5));
  const Delta raw = {"raw", Window::none(), Ink::kRed};
  const Delta to_tenth = {"to 10 %", tenth, Ink::kGreen}, to_half = {"to 50 %", half, Ink::kBlue};
  return {.id = "laplacian",
          .title = "Less curvature",
          .source =
              "Sloan 2008, “Minimising functionals”: the squared Laplacian of the delta reduced to 10 % (green) and "
              "to 50 % (blue), and together with the delta itself; appendix A7",
          .pictures = {together("laplacian-10", "to 10 %", {to_tenth}, kOuterRing),
                       together("laplacian-50", "to 50 %", {to_half}, kOuterRing),
                       together("laplacian", "with the delta itself", {raw, to_half, to_tenth}, kOuterRing)},
          .caption =
              "The window 1/(1 + λ l²(l + 1)²) with λ found by Newton’s method so that the integral of the squared "
              "Laplacian falls to a tenth and to a half. Negative lobes are dashed.",
          .numbers = {{"λ for 10 %", "0.004209", weight_for(0.1), 0.004209, 5e-7},  // half of the last digit printed
                      {"λ for 50 %", "0.000632", weight_for(0.5), 0.000632, 5e-7},
                      // λ is printed to three and four digits.
                      {"left of the squared Laplacian by λ = 0.004209", "10 %", fraction_left_by(0.004209), 0.1, 1e-4},
                      {"left of the squared Laplacian by λ = 0.000632", "50 %", fraction_left_by(0.000632), 0.5, 5e-4},
                      {"squared Laplacian of the delta", "",
                       squared_laplacian(zonal_toward(delta_zonal(kBands), {0, 0, 1})), 14700 / (4 * kPi), 1e-9}}};
}

}  // namespace

std::vector<GalleryFigure> window_figures() { return {windows(), delta_windows(), laplacian()}; }

}  // namespace zonal
