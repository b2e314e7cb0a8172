#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "zonal/report/bake_sections.h"
#include "zonal/report/figure.h"
#include "zonal/report/text.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

std::string shown(const EncodedPicture& picture, std::string_view alt, std::string_view css_class = {}) {
  return html_picture({picture.uri, picture.width, picture.height, std::string(alt), std::string(css_class)});
}

/// The style cuts the disc out.
std::string ball(const EncodedPicture& picture, std::string_view alt) { return shown(picture, alt, "ball"); }

/// Azimuth from +X toward +Y and elevation above the horizon, degrees.
std::string azimuth_and_elevation(Vec3 toward) {
  return fmt::format("azimuth {}, elevation {}", angle(std::atan2(toward.y, toward.x)),
                     angle(std::asin(std::clamp(toward.z, -1.0, 1.0))));
}

/// A ring around a direction of an equirectangular picture, dark on light on dark: visible on everything.
std::string ring_at(Vec3 toward, int width, int height) {
  const std::optional<PixelPoint> at = Mapping({Layout::kEquirect}, {width, height}).position(toward);
  std::string rings;
  if (at) {
    for (const auto& [color, stroke] : {std::pair{"#000", 5}, std::pair{"#fff", 2}}) {
      rings += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="17" stroke="{}" stroke-width="{}" )"
                           R"(vector-effect="non-scaling-stroke"/>)",
                           at->x, at->y, color, stroke);
    }
  }
  return fmt::format(R"(<svg viewBox="0 0 {} {}" fill="none" aria-hidden="true">{}</svg>)", width, height, rings);
}

/// What lies along the horizon of our panoramas.
constexpr std::string_view kHorizon =
    "<div class=\"panorama-axis\" aria-hidden=\"true\"><span>−X</span><span>+Y</span><span>+X</span><span>−Y</span>"
    "<span>−X</span></div>";

std::string size_of(const Environment& map) {
  if (const auto size = natural_size(map.projection.layout, {map.radiance.width(), map.radiance.height()})) {
    return fmt::format("{} px", *size);
  }
  return fmt::format("{} × {} px", map.radiance.width(), map.radiance.height());
}

std::string how_made(const ConvolveReport& report) {
  if (report.bands == 0 && report.points == 0) return "not convolved";
  if (report.points == 0) return fmt::format("{} bands", report.bands);
  return fmt::format("{} bands + {} texel{}", report.bands, report.points, report.points == 1 ? "" : "s");
}

}  // namespace

std::string panorama_section(const BakePage& page, const BakePictures& pictures) {
  const EncodedPicture& picture = pictures.panorama;
  std::string inside = shown(picture, "Panorama of " + page.title + ", tone-mapped.");
  std::string caption =
      fmt::format("Exposure {}{} stops, the same in all pictures; extended Reinhard curve, white at {}; sRGB. ",
                  pictures.tonemap.exposure_ev > 0 ? "+" : "", number(pictures.tonemap.exposure_ev, 2),
                  number(pictures.tonemap.white, 1));
  if (const auto& sun = page.survey.sun) {
    inside += ring_at(sun->toward_sun, picture.width, picture.height);
    caption += "The ring marks the sun: " + azimuth_and_elevation(sun->toward_sun) + ". ";
  }
  caption += "Centre +X, up +Z; azimuth counts from +X toward +Y, to the left.";
  return html_figure(fmt::format("<div class=\"marked\">{}</div>{}", inside, kHorizon), escape(caption), "wide");
}

std::string irradiance_section(const BakePage& page, const BakePictures& pictures) {
  const std::string map = shown(pictures.irradiance, "Irradiance map of " + page.title + ".") + std::string(kHorizon);
  return html_paragraph(
             "Light on a matt surface, by the direction it faces: the integral of radiance times the clamped cosine. "
             "Shown divided "
             "by π, as the radiance of a white surface. The viewer of the ball stands at +X.") +
         html_figure(fmt::format("<div class=\"beside\"><div>{}</div><div>{}</div></div>", map,
                                 ball(pictures.exact_ball, "White matt ball under this light.")),
                     fmt::format("Error bound: {} of the map’s mean.", number(page.irradiance_report.bound_to_mean, 2)),
                     "wide");
}

std::string chain_section(const BakePage& page, const BakePictures& pictures) {
  std::string strip;
  for (std::size_t i = 0; i < page.chain.size(); ++i) {
    const ChainLevel& level = page.chain[i];
    strip += html_figure(ball(pictures.chain_balls[i],
                              fmt::format("Mirror ball with level {}, roughness {}.", i, number(level.roughness))),
                         fmt::format("<b>Level {}</b><br>roughness {}<br>α {}<br>{}<br>{}<br>bound {}", i,
                                     number(level.roughness), number(level.alpha), escape(size_of(level.map)),
                                     how_made(level.report), number(level.report.bound_to_mean, 2)));
  }
  return html_paragraph(
             page.lobe +
             " lobe with normal = view = reflection. Each ball reflects one level; bounds are fractions of the "
             "environment’s mean. The viewer stands at +X: the middle of a ball shows the centre of the panorama.") +
         "<div class=\"strip\">\n" + strip + "</div>\n";
}

std::string sh_section(const BakePage& page, const BakePictures& pictures) {
  std::string strip = html_figure(ball(pictures.exact_ball, "Matt ball under the exact irradiance.") +
                                      shown(pictures.exact_map, "Exact irradiance map."),
                                  "<b>Exact</b>");
  LineChart chart = {.description = "Error of the irradiance against the number of bands.",
                     .x = {.label = "bands", .whole = true},
                     .y = {.label = "error / maximum", .log = true},
                     .series = {{"RMS", {}}, {"worst", {}}}};
  HtmlTable table = {"Irradiance from the first bands, against the exact map. Errors are fractions of its maximum.",
                     {{"bands", true}, {"coefficients", true}, {"RMS", true}, {"worst", true}},
                     {}};
  for (std::size_t i = 0; i < page.sh.size(); ++i) {
    const auto& [bands, map, rms, worst] = page.sh[i];
    const std::string words = fmt::format("{} band{}", bands, bands == 1 ? "" : "s");
    strip += html_figure(ball(pictures.fits[i].ball, "Matt ball, irradiance from " + words + ".") +
                             shown(pictures.fits[i].map, "Irradiance map from " + words + ".") +
                             shown(pictures.fits[i].error,
                                   fmt::format("Error of {} in false colours, largest {}.", words, percent(worst, 2))),
                         fmt::format("<b>{}</b><br>RMS {}<br>worst {}", words, percent(rms, 2), percent(worst, 2)));
    chart.series[0].points.push_back({static_cast<double>(bands), rms});
    chart.series[1].points.push_back({static_cast<double>(bands), worst});
    table.rows.push_back({std::to_string(bands), std::to_string(bands * bands), percent(rms), percent(worst)});
  }
  const std::string scale = "<p class=\"scale\"><span>no error</span>" +
                            shown(pictures.error_scale, "Scale of the false colours.") +
                            "<span>each picture’s worst</span></p>\n";
  return html_paragraph(
             "Irradiance from the first bands of the environment, beside the exact one; below each map its error. "
             "Percentages are of "
             "the exact map’s maximum.") +
         "<div class=\"strip fits\">\n" + strip + "</div>\n" + scale + html_figure(line_chart(chart), "") +
         html_details("Errors as a table", html_table(table));
}

std::string split_sum_section(const BakePage& page, const BakePictures& pictures) {
  return html_figure(
      shown(pictures.split_sum, "Split-sum table as colours."),
      escape(fmt::format("{} × {} values. n·v rises from left to right, roughness from top to bottom. {}",
                         page.split_sum.width(), page.split_sum.height(), page.split_sum_channels)),
      "small");
}

}  // namespace zonal
