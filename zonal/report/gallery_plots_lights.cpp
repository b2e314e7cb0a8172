#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "zonal/light/normalise.h"
#include "zonal/report/curve_plot.h"
#include "zonal/report/gallery_plots.h"
#include "zonal/report/svg.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

/// The ball of light as its receiver sees it.
std::string sphere_drawing() {
  constexpr double kWidth = 440, kHeight = 230, kRadius = 62;
  constexpr double px = 46, py = 178, cx = 318, cy = 92;
  const double distance = std::hypot(cx - px, cy - py), half_angle = sphere_half_angle(kRadius, distance);
  const double toward_center = std::atan2(cy - py, cx - px), reach = std::sqrt(distance * distance - kRadius * kRadius);
  const auto at = [&](double angle, double length) {
    return std::array<double, 2>{px + length * std::cos(angle), py + length * std::sin(angle)};
  };
  std::string inside =
      fmt::format(R"(<circle cx="{}" cy="{}" r="{}" fill="{}" fill-opacity="0.18" stroke="currentColor"/>)", cx, cy,
                  kRadius, color_of(Ink::kRed));
  for (const double side : {-half_angle, half_angle}) {
    const auto [x, y] = at(toward_center + side, reach + 50);
    inside += svg_line(px, py, x, y, 0.7);
  }
  inside += svg_line(px, py, cx, cy, 0.7);
  const auto [touch_x, touch_y] = at(toward_center - half_angle, reach);
  inside += svg_line(cx, cy, touch_x, touch_y, 0.7);
  const double arc = 110;
  const auto [from_x, from_y] = at(toward_center - half_angle, arc);
  const auto [to_x, to_y] = at(toward_center, arc);
  inside +=
      fmt::format(R"(<path d="M{:.1f} {:.1f}A{} {} 0 0 1 {:.1f} {:.1f}" fill="none" stroke="{}" stroke-width="2"/>)",
                  from_x, from_y, arc, arc, to_x, to_y, color_of(Ink::kRed));
  const auto [a_x, a_y] = at(toward_center - half_angle / 2, arc + 14);
  inside += svg_text(a_x, a_y + 4, "middle", "a");
  inside += svg_text((cx + touch_x) / 2 + 8, (cy + touch_y) / 2 + 4, "start", "r");
  inside += svg_text((px + cx) / 2 + 4, (py + cy) / 2 + 20, "start", "d");
  for (const auto& [x, y] : {std::array{px, py}, std::array{cx, cy}})
    inside += fmt::format(R"(<circle cx="{}" cy="{}" r="3"/>)", x, y);
  inside += svg_text(px - 10, py + 20, "end", "P") + svg_text(cx + 9, cy + 16, "start", "C");
  inside += svg_text(8, 16, "start", "sin a = r/d");
  return svg_frame(kWidth, kHeight, "plot",
                   "A receiver P sees a ball of light with centre C, radius r and distance d under the half angle a.",
                   inside);
}

/// Appendix A3 at one angle. c = cos a; (1 - c)(c + 1) is s² = sin² a.
std::vector<PublishedNumber> sphere_numbers(double angle_deg) {
  const double a = radians(angle_deg), c = std::cos(a), s2 = std::sin(a) * std::sin(a), root_pi = std::sqrt(kPi);
  struct Row {
    const char* printed;
    double value;
  };
  const std::array<Row, 6> rows = {
      Row{"√π(1 − c)", root_pi * (1 - c)},
      Row{"½√3 √π s²", std::sqrt(3) / 2 * root_pi * s2},
      Row{"½√5 √π c s²", std::sqrt(5) / 2 * root_pi * c * s2},
      Row{"⅛√7 √π s²(7c² − 3), a misprint for 5c² − 1", std::sqrt(7) / 8 * root_pi * s2 * (5 * c * c - 1)},
      Row{"⅜√π c s²(7c² − 3)", 3.0 / 8 * root_pi * c * s2 * (7 * c * c - 3)},
      Row{"√11/16 √π s²(21c⁴ − 14c² + 1)", std::sqrt(11) / 16 * root_pi * s2 * (21 * std::pow(c, 4) - 14 * c * c + 1)}};
  const std::vector<double> ours = cone_zonal(a, 6);
  std::vector<PublishedNumber> numbers;
  for (std::size_t l = 0; l < rows.size(); ++l) {
    numbers.push_back(
        {fmt::format("l = {} of a ball with a = {}°", l, angle_deg), rows[l].printed, ours[l], rows[l].value, 1e-14});
  }
  return numbers;
}

GalleryFigure sphere() {
  GalleryFigure figure = {
      .id = "sphere-light",
      .title = "A ball of light",
      .source = "Sloan 2008, “Analytic models”: figure 1; coefficients of appendix A3, c = cos a, s = sin a",
      .pictures = {{.name = "sphere-light",
                    .alt = "A point P sees a ball with centre C and radius r at distance d under the half angle a.",
                    .svg = sphere_drawing()}},
      .caption =
          "A ball of radius r at distance d fills the half angle a with sin a = r/d. Its coefficients about the "
          "axis PC depend on a alone and are the same as a disc’s at infinity.",
      .numbers = sphere_numbers(30)};
  figure.numbers.push_back(
      {"half angle of r/d = 1/2, in degrees", "sin a = r/d", degrees(sphere_half_angle(1, 2)), 30, 1e-13});
  figure.numbers.push_back(
      {"normalises a ball of a = 30°, all bands", "1/sin² a", cone_normalising_factor(radians(30)), 4, 1e-14});
  return figure;
}

struct Cone {
  double half_angle_deg;
  Ink ink;
  const char* name;
};
constexpr std::array<Cone, 4> kCones = {Cone{90, Ink::kGreen, "90°"}, Cone{45, Ink::kRed, "45°"},
                                        Cone{30, Ink::kBlue, "30°"}, Cone{12.5, Ink::kText, "12.5°"}};

std::vector<double> cone_coefficients(bool smooth, double half_angle_deg, int bands) {
  return smooth ? smooth_cone_zonal(radians(half_angle_deg), bands) : cone_zonal(radians(half_angle_deg), bands);
}

std::string cones_plot(bool smooth, int bands) {
  CurvePlot plot = {.title = fmt::format("{}, {} bands", smooth ? "smooth cone" : "cone", bands),
                    .description = fmt::format("{} of four half angles, as they are and in {} bands.",
                                               smooth ? "Smooth cones" : "Cones", bands),
                    .x = {.label = "θ in degrees", .range = AxisRange{0, 180}, .marks = {0, 30, 45, 90, 135, 180}},
                    .y = {.range = AxisRange{-0.25, 1.5}, .marks = {0, 0.5, 1, 1.5}},
                    .curves = {}};
  double shift = 0;
  for (const auto& [half_angle_deg, ink, name] : kCones) {
    std::vector<ChartPoint> truth;
    if (smooth) {
      truth = sampled([&](double t) { return smooth_cone_profile(radians(t), radians(half_angle_deg)); }, 0, 180, 181);
    } else {
      truth = {{0, 1 + shift}, {half_angle_deg, 1 + shift}, {half_angle_deg, shift}, {180, shift}};
      shift += 0.015;
    }
    plot.curves.push_back({.name = "", .points = truth, .ink = ink, .dashed = true});
  }
  for (const auto& [half_angle_deg, ink, name] : kCones) {
    const std::vector<double> zonal = cone_coefficients(smooth, half_angle_deg, bands);
    plot.curves.push_back(
        {.name = name,
         .points = sampled([&](double t) { return evaluate_zonal(zonal, std::cos(radians(t))); }, 0, 180, 181),
         .ink = ink});
  }
  return curve_plot(plot);
}

/// Appendix A4 at one angle, in closed form.
std::vector<PublishedNumber> smooth_cone_numbers(double angle_deg) {
  const double a = radians(angle_deg), c = std::cos(a), s = std::sin(a), a3 = a * a * a, q = std::sqrt(kPi) / a3;
  struct Row {
    const char* printed;
    double value;
  };
  const std::array<Row, 6> rows = {
      Row{"(a³ + 6a − 12s + 6ca) √π/a³", q * (a3 + 6 * a + 6 * a * c - 12 * s)},
      Row{"misprint: +3cs for −3cs", q * std::sqrt(3) / 4 * (a3 + 3 * a * c * c - 3 * c * s)},
      Row{"misprint: 3c²a for 3c³a",
          q * std::sqrt(5) / 9 * (3 * a * c * c * c - 9 * a * c - 6 * a - 2 * c * c * s + 14 * s)},
      Row{"√7/256 (4a³ + 15a − 108c²a + …) √π/a³",
          q * std::sqrt(7) / 256 *
              (4 * a3 + 15 * a - 108 * a * c * c + 60 * a * std::pow(c, 4) - 30 * c * c * c * s + 63 * c * s)},
      Row{"1/1500 (−480a + 742s + …) √π/a³",
          q / 1500 *
              (-480 * a + 225 * a * c - 1650 * a * c * c * c + 945 * a * std::pow(c, 5) + 742 * s + 596 * c * c * s -
               378 * std::pow(c, 4) * s)},
      Row{"√11/3072 (12a³ − 63a + …) √π/a³",
          q * std::sqrt(11) / 3072 *
              (12 * a3 - 63 * a + 540 * a * c * c - 1260 * a * std::pow(c, 4) + 672 * a * std::pow(c, 6) - 15 * c * s +
               350 * c * c * c * s - 224 * std::pow(c, 5) * s)}};
  const std::vector<double> ours = smooth_cone_zonal(a, 6);
  std::vector<PublishedNumber> numbers;
  for (std::size_t l = 0; l < rows.size(); ++l) {
    // The closed forms subtract terms some hundred times their result.
    numbers.push_back(
        {fmt::format("l = {} of a smooth cone of {}°", l, angle_deg), rows[l].printed, ours[l], rows[l].value, 1e-12});
  }
  return numbers;
}

double lowest_of(const std::vector<double>& zonal) {
  double lowest = 0;
  for (const auto& [t, value] : sampled([&](double t) { return evaluate_zonal(zonal, std::cos(t)); }, 0, kPi, 1801)) {
    lowest = std::min(lowest, value);
  }
  return lowest;
}

GalleryFigure cones() {
  GalleryFigure figure = {
      .id = "cones",
      .title = "Cones and smooth cones",
      .source =
          "Sloan 2008, “Analytic models”: cones above, smooth cones below, of 90° (green), 45° (red), 30° (blue) "
          "and 12.5° (there black); coefficients of appendix A4, c = cos a, s = sin a",
      .pictures = {},
      .caption =
          "Left 4 bands, right 6. Dashed: the light itself, the flat cones shifted a little against each other; "
          "solid: its projection. The smooth cone 2u³ − 3u² + 1, u = θ/a, overshoots and rings less.",
      .numbers = smooth_cone_numbers(45)};
  for (const bool smooth : {false, true}) {
    for (const int bands : {4, 6}) {
      figure.pictures.push_back({.name = fmt::format("{}-{}", smooth ? "smooth-cones" : "cones", bands),
                                 .alt = fmt::format("{} of four half angles and their projections on {} bands.",
                                                    smooth ? "Smooth cones" : "Cones", bands),
                                 .svg = cones_plot(smooth, bands)});
    }
  }
  int better = 0;
  for (const auto& cone : kCones) {
    const double flat = lowest_of(cone_coefficients(false, cone.half_angle_deg, 6));
    const double smooth = lowest_of(cone_coefficients(true, cone.half_angle_deg, 6));
    if (smooth > flat) ++better;
  }
  figure.numbers.push_back({"angles of 4 at which the smooth cone undershoots less, 6 bands",
                            "the softer cone behaves better", static_cast<double>(better), 4, 0});
  return figure;
}

}  // namespace

std::vector<GalleryFigure> light_model_figures() { return {sphere(), cones()}; }

}  // namespace zonal
