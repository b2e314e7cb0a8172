#include <fmt/format.h>

#include <cmath>
#include <string>

#include "zonal/light/extract.h"
#include "zonal/light/normalise.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/report/ball.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/picture_sheet.h"
#include "zonal/report/sphere_disc.h"
#include "zonal/report/text.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

constexpr int kSizePx = 288;

/// The part of the sum over coefficients l >= first of a b.
double dot_from(int first, const Sh<double>& a, const Sh<double>& b) {
  double sum = 0;
  for (std::size_t i = static_cast<std::size_t>(first * first); i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// What the paper's closed forms for one light are made of, in 3 bands, from our own verbs.
void add_closed_form(std::vector<PublishedNumber>& numbers) {
  const Vec3 toward = normalize({0.48, -0.6, 0.64});  // they hold for any
  const Sh<double> delta = zonal_toward(delta_zonal(3), toward);
  const double facing_one = normalising_factor(delta, toward);
  const Sh<double> light = irradiance_over_pi(facing_one * delta);
  Sh<double> ambient(3);
  ambient[0] = 2 / std::sqrt(kPi);  // the paper's appendix A5 has this unit: pi times what a white surface reflects
  ambient = irradiance_over_pi(ambient);
  const double a = dot_from(0, light, light), b = dot_from(0, light, ambient), c = dot_from(0, ambient, ambient);
  const double determinant = a * c - b * b, eps = 1e-14;  // a few roundings
  const std::vector<PublishedNumber> closed = {
      {"A directional light that reflects 1 from a surface facing it", "16π/17", facing_one, 16 * kPi / 17, 16 * eps},
      {"Intensity c for a dot product of 1, without the mean", "867/(316π)", 1 / dot_from(1, light, light),
       867 / (316 * kPi), eps},
      {"First coefficient of the light, as irradiance over π", "8√π/17", light[0], 8 * std::sqrt(kPi) / 17, eps},
      {"Ambient a for a first coefficient of 1 (of the vector 2/√π)", "√π/2", 1 / ambient[0], std::sqrt(kPi) / 2, eps},
      {"A", "508π/867", a, 508 * kPi / 867, eps},
      {"B, with that ambient vector", "16/17", b, 16.0 / 17, eps},
      {"C, with that ambient vector", "4/π", c, 4 / kPi, eps},
      {"Coupled form: share of D in c", "867/(316π)", c / determinant, 867 / (316 * kPi), eps},
      {"Coupled form: share of E in c", "−51/79", -b / determinant, -51.0 / 79, eps},
      {"Coupled form: share of E in a", "127π/316", a / determinant, 127 * kPi / 316, 4 * eps},
  };
  numbers.insert(numbers.end(), closed.begin(), closed.end());
}

/// How far the irradiance of b is from that of a, relative to a without its mean, measured on the sphere.
double measured_residual(const Sh<RgbD>& a, const Sh<RgbD>& b) {
  const Sh<RgbD> whole = irradiance_over_pi(a), left = whole - irradiance_over_pi(b);
  const RgbD mean = (1 / (2 * std::sqrt(kPi))) * whole[0];
  double of_left = 0, of_whole = 0;
  for (const auto& [direction, weight] : sphere_rule(kGalleryBands)) {
    const RgbD error = evaluate(left, direction), value = evaluate(whole, direction) - mean;
    of_left += weight * luminance(error * error);
    of_whole += weight * luminance(value * value);
  }
  return of_whole > 0 ? std::sqrt(of_left / of_whole) : 0;
}

}  // namespace

GalleryFigure extracted_lights_figure(const ShownProbe& probe) {
  PictureSheet sheet = {.name = "extracted-lights",
                        .description =
                            "Two rows of four: the light probe, and three, two and one directional lights with "
                            "an ambient light that were extracted from it. Above as radiance, all around the "
                            "viewer; below as irradiance, on a white matte ball.",
                        .columns = {"the probe", "3 lights + ambient", "2 lights + ambient", "1 light + ambient"},
                        .rows = {{"Radiance, 6 bands", {}}, {"Irradiance", {}}}};
  GalleryFigure figure;
  add_closed_form(figure.numbers);
  const auto add = [&](const Sh<RgbD>& light, const std::string& label, const std::vector<SheetMark>& marks) {
    const Image<Rgb> disc = draw_sphere_disc(seen(light, probe.world_from_view), kSizePx);
    const Image<Rgb> ball =
        draw_ball(seen(irradiance_over_pi(light), probe.world_from_view), BallKind::kDiffuse, {.size_px = kSizePx});
    sheet.rows[0].cells.push_back({tonemap(disc, probe.curve), "", true, marks});
    sheet.rows[1].cells.push_back({tonemap(ball, probe.curve), label});
  };
  add(probe.radiance, "", {});
  for (int count = 3; count >= 1; --count) {
    const ExtractedLights found = extract_lights(probe.radiance, {.lights = count});
    const Sh<RgbD> again = project(found, kGalleryBands);
    std::vector<SheetMark> marks;
    for (const ExtractedLight& light : found.lights) {
      const DiscPlace place = sphere_disc_place(transpose(probe.world_from_view) * light.direction);
      marks.push_back({place.x, place.y});
    }
    std::string label = fmt::format("residual {}", percent(found.residual, 2));
    if (const int there = static_cast<int>(found.lights.size()); there < count) {
      label += fmt::format("\n{} light{} found", there, there == 1 ? "" : "s");
    }
    add(again, label, marks);
    figure.numbers.push_back(
        {fmt::format("Residual of the irradiance with {} light{}, against its measure on the sphere", count,
                     count == 1 ? "" : "s"),
         "", found.residual, measured_residual(probe.radiance, again), 1e-7});  // the root of a difference of sums
  }

  figure.id = sheet.name;
  figure.title = "Lights out of a probe";
  figure.source = "Sloan 2008, “Extracting conventional lights from SH” (figure of 3, 2 and 1 lights) and appendix A5";
  figure.pictures = {{.name = sheet.name, .alt = sheet.description, .svg = picture_sheet(sheet)}};
  figure.caption =
      "Directions are the peaks of the probe’s luminance that explain most of it (rings), intensities the "
      "least-squares fit to its irradiance, none below zero. The residual is what is left of the irradiance, without "
      "its mean. Each "
      "directional light appears as sharp as 6 bands can have it, with its ringing. The paper’s ambient a counts "
      "irradiance where its light c counts what a white surface reflects: a is π times what c’s unit would make it.";
  return figure;
}

}  // namespace zonal
