#include <cmath>
#include <vector>

#include "zonal/light/normalise.h"
#include "zonal/report/curve_plot.h"
#include "zonal/report/gallery_plots.h"
#include "zonal/report/polar_plot.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

const std::vector<double> kRightAngles = {0, 45, 90, 135, 180};

double clamped_cosine_at(double theta) { return std::max(0.0, std::cos(theta)); }

double truncated_at(int bands, double theta) { return evaluate_zonal(clamped_cosine_zonal(bands), std::cos(theta)); }

struct Fit {
  int bands;
  Ink ink;
};

std::string bands_name(int bands) { return std::to_string(bands) + " bands"; }

std::string cartesian(const std::vector<Fit>& fits, const std::string& alt, const std::vector<PlotNote>& notes) {
  CurvePlot plot = {
      .title = "over the angle",
      .description = alt,
      .x = {.label = "θ in degrees", .range = AxisRange{0, 180}, .marks = kRightAngles},
      .y = {.range = AxisRange{-0.15, 1.1}, .marks = {0, 0.25, 0.5, 0.75, 1}},
      .curves = {{.name = "max(cos θ, 0)",
                  .points = sampled([](double t) { return clamped_cosine_at(radians(t)); }, 0, 180, 181)}},
      .notes = notes};
  for (const auto& [bands, ink] : fits) {
    plot.curves.push_back(
        {.name = bands_name(bands),
         .points = sampled([b = bands](double t) { return truncated_at(b, radians(t)); }, 0, 180, 181),
         .ink = ink});
  }
  return curve_plot(plot);
}

std::string polar(const std::vector<Fit>& fits, const std::string& alt, const std::vector<PolarNote>& notes) {
  PolarPlot plot = {.title = "polar, by size; negative lobes dashed",
                    .description = alt,
                    .curves = {{.name = "max(cos θ, 0)",
                                .value = clamped_cosine_at,
                                .positive = Ink::kText,
                                .negative = Ink::kText,
                                .filled = false}},
                    .notes = notes,
                    .radius = 1.125};
  for (const auto& [bands, ink] : fits) {
    plot.curves.push_back({.name = bands_name(bands),
                           .value = [b = bands](double theta) { return truncated_at(b, theta); },
                           .positive = ink,
                           .negative = ink});
  }
  return polar_plot(plot);
}

/// T of the paper's "normalisation", the clamped cosine over pi.
PublishedNumber transfer_number(int l, const char* printed, double expected) {
  const std::vector<double> transfer = zonal_from_factors(cosine_factors(6));
  return {"coefficient l = " + std::to_string(l) + " of max(cos θ, 0)/π", printed,
          transfer[static_cast<std::size_t>(l)], expected, 1e-15};
}

GalleryFigure three_bands() {
  const double root_pi = std::sqrt(kPi), pole = truncated_at(3, 0), antipode = truncated_at(3, kPi);
  const std::string alt = "The clamped cosine and its projection on 3 bands, which is 17/16 in front and 1/16 behind.";
  return {
      .id = "clamped-cosine-3",
      .title = "The clamped cosine in 3 bands",
      .source = "Sloan 2008, “Irradiance environment maps”: first figure; coefficients of “Normalisation”",
      .pictures = {{.name = "clamped-cosine-3",
                    .alt = alt,
                    .svg = cartesian(
                        {{3, Ink::kRed}}, alt,
                        {{.x = 0, .y = pole, .label = "17/16"},
                         {.x = 180, .y = antipode, .label = "1/16, so 17 : 1", .side = PlotNote::Side::kAboveLeft}})},
                   {.name = "clamped-cosine-3-polar",
                    .alt = alt,
                    .svg = polar({{3, Ink::kRed}}, alt, {{0, pole, "17/16"}, {kPi, antipode, "1/16"}})}},
      .caption =
          "The clamped cosine is what a matte surface does to light. Red: what 3 bands make of it, 1/16 too much in "
          "front and a lobe of 1/16 behind. A directional light that reflects 17 where the surface faces it "
          "reflects 1 where nothing should be.",
      .numbers = {
          {"too much in front, θ = 0", "1/16", pole - 1, 1.0 / 16, 1e-15},
          {"value behind, θ = 180°", "1/16", antipode, 1.0 / 16, 1e-15},
          {"front : behind", "17 : 1", pole / antipode, 17, 1e-13},
          transfer_number(0, "1/(2√π)", 1 / (2 * root_pi)),
          transfer_number(1, "√3/(3√π)", std::sqrt(3) / (3 * root_pi)),
          transfer_number(2, "√5/(8√π)", std::sqrt(5) / (8 * root_pi)),
          {"normalises a directional light, 3 bands", "16π/17", normalising_factor(delta_zonal(3)), 16 * kPi / 17,
           1e-14},
          {"the same, 4 bands", "16π/17", normalising_factor(delta_zonal(4)), 16 * kPi / 17, 1e-14},
          {"normalises ambient light", "2√π", normalising_factor(std::vector<double>{1, 0, 0}), 2 * root_pi, 1e-14}}};
}

GalleryFigure five_bands() {
  const double root_pi = std::sqrt(kPi), pole = truncated_at(5, 0), antipode = truncated_at(5, kPi);
  const std::string alt =
      "The clamped cosine and its projections on 3 and 5 bands; that on 5 bands is 31/32 in front and −1/32 behind.";
  const std::vector<Fit> fits = {{3, Ink::kRed}, {5, Ink::kBlue}};
  return {
      .id = "clamped-cosine-5",
      .title = "The clamped cosine in 5 bands",
      .source = "Sloan 2008, “Irradiance environment maps”: second figure; coefficients of “Normalisation”",
      .pictures = {{.name = "clamped-cosine-5",
                    .alt = alt,
                    .svg = cartesian(
                        fits, alt,
                        {{.x = 0, .y = pole, .label = "31/32", .side = PlotNote::Side::kBelowRight},
                         {.x = 180, .y = antipode, .label = "−1/32, so 31 : −1", .side = PlotNote::Side::kBelowLeft}})},
                   {.name = "clamped-cosine-5-polar",
                    .alt = alt,
                    .svg = polar(fits, alt, {{0, pole, "31/32"}, {kPi, antipode, "−1/32"}})}},
      .caption =
          "Blue: with 5 bands the curve is closer, and the lobe behind is negative: where the surface reflects 31 "
          "in front it reflects −1 behind. Band l = 3 has nothing to add, nor has l = 5.",
      .numbers = {{"value in front, θ = 0", "", pole, 31.0 / 32, 1e-15},
                  {"value behind, θ = 180°", "", antipode, -1.0 / 32, 1e-15},
                  {"front : behind", "31 : −1", pole / antipode, -31, 1e-12},
                  transfer_number(3, "0", 0),
                  transfer_number(4, "−1/(16√π)", -1 / (16 * root_pi)),
                  transfer_number(5, "0", 0),
                  {"normalises a directional light, 5 bands", "32π/31", normalising_factor(delta_zonal(5)),
                   32 * kPi / 31, 1e-14},
                  {"the same, 6 bands", "32π/31", normalising_factor(delta_zonal(6)), 32 * kPi / 31, 1e-14}}};
}

}  // namespace

std::vector<GalleryFigure> cosine_figures() { return {three_bands(), five_bands()}; }

}  // namespace zonal
