#include "zonal/report/fisheye_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/image/color.h"
#include "zonal/image/compare.h"
#include "zonal/image/tonemap.h"
#include "zonal/light/fisheye_pixels.h"
#include "zonal/light/rearrange.h"
#include "zonal/report/fisheye_page_script.h"
#include "zonal/report/html.h"
#include "zonal/report/png_uri.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

constexpr int kPhotographEdge = 480;  // of the copy in the page, at most

std::uint8_t code_of(float value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
}

/// Codes as they are, light through the sRGB curve, brighter light than a display has through a tone curve.
class Display {
 public:
  explicit Display(const FisheyePage& page) : codes_(page.codes) {
    float most = 0;
    for (const Rgb& texel : page.photograph->radiance.values()) most = std::max(most, max_channel(texel));
    bright_ = !codes_ && most > 1;
    if (bright_) curve_.exposure_ev = auto_exposure_ev(page.photograph->radiance);
  }
  Rgb8 operator()(Rgb value) const {
    if (bright_) return tonemap(value, curve_);
    if (codes_) return {code_of(value.r), code_of(value.g), code_of(value.b)};
    return {srgb8(value.r), srgb8(value.g), srgb8(value.b)};
  }
  Image<Rgb8> operator()(const Image<Rgb>& values) const {
    Image<Rgb8> shown(values.width(), values.height());
    std::ranges::transform(values.values(), shown.values().begin(), [&](Rgb v) { return (*this)(v); });
    return shown;
  }

 private:
  bool codes_, bright_ = false;
  Tonemap curve_;
};

std::string labelled(std::string_view label, const Image<Rgb8>& picture) {
  return html_figure(
      html_picture({png_data_uri(picture), picture.width(), picture.height(), std::string(label), "pixels"}),
      fmt::format("<b>{}</b>", escape(label)));
}

std::string side_by_side(std::string_view form, const Image<Rgb>& published, const Image<Rgb>& corrected,
                         const Display& display) {
  const Image<float> error = difference(published, corrected);
  const float most = std::ranges::max(error.values());
  return fmt::format("<div class=\"pair\">\n{}{}{}</div>\n",
                     labelled(fmt::format("{}, published", form), display(published)),
                     labelled(fmt::format("{}, corrected", form), display(corrected)),
                     labelled(fmt::format("{}, difference, white at {}", form, number(most)),
                              false_color(error, most > 0 ? most : 1)));
}

Image<Rgb> cross_of(const Environment& cube) {
  const int edge = cube.radiance.width();
  const auto cross = rearranged(cube, {Layout::kCubeCross}, image_size(Layout::kCubeCross, edge));
  check(cross.has_value(), "all cube layouts hold the same texels");
  return cross->radiance;
}

std::string quantity_of(const FisheyeStudy& study) {
  return study.shininess == 1 ? std::string("irradiance map (shininess 1)")
                              : fmt::format("reflection map (shininess {:g})", study.shininess);
}

std::vector<std::string> error_row(std::string what, const FisheyeError& error) {
  return {std::move(what), percent(error.rms), percent(error.most)};
}

std::string study_html(const FisheyePage& page, std::size_t i, const Display& display) {
  const FisheyeStudy& study = page.studies[i];
  HtmlTable table = {
      "Differences from the exact map above the horizon, of its greatest value.",
      {{"cause"}, {"RMS", true}, {"largest", true}},
      {error_row("published, all together", study.total),
       error_row("weights alone: angle to the lobe's axis in place of the zenith angle", study.weights_alone),
       error_row("ground alone: the square's corners in place of the whole lower half", study.ground_alone)}};
  if (!page.averaging_codes.empty()) {
    table.rows.push_back(
        error_row("codes averaged in place of light, all else right (of the light's map)", page.averaging_codes[i]));
  }
  table.rows.push_back(error_row("our own map against sums over the pixels", study.library));
  return html_table(table) +
         side_by_side("paraboloid", study.published.paraboloid, study.corrected.paraboloid, display) +
         side_by_side("panorama", study.published.equirect.radiance, study.corrected.equirect.radiance, display) +
         side_by_side("cube", cross_of(study.published.cube), cross_of(study.corrected.cube), display);
}

std::string input(std::string_view id, std::string_view label, std::string_view attributes) {
  return fmt::format("<label style=\"display: block\">{}<br><input id=\"circle-{}\" {} /></label>\n", escape(label), id,
                     attributes);
}

std::string preview(std::string_view name) {
  return html_figure(
      fmt::format("<canvas id=\"preview-{0}\" width=\"41\" height=\"41\" role=\"img\" "
                  "aria-label=\"preview of the {0} paraboloid map\" class=\"pixels\" style=\"width: 205px\"></canvas>",
                  name),
      fmt::format("<b>{}</b>, preview", name));
}

std::string circle_html(const FisheyePage& page, const Display& display) {
  const Image<Rgb>& pixels = page.photograph->radiance;
  const int width = pixels.width(), height = pixels.height();
  const int factor = (std::max(width, height) + kPhotographEdge - 1) / kPhotographEdge;
  const Image<Rgb8> copy = display(smaller_photograph(*page.photograph, factor).radiance);
  const PixelCircle circle = fisheye_circle(*page.photograph);
  const Rgb8 ground = display(page.ground);
  const double shininess = std::clamp(page.studies.back().shininess, 1.0, 100.0);
  const auto value_attributes = [](double value, double low, double high) {
    return fmt::format(R"(type="number" inputmode="decimal" min="{:g}" max="{:g}" step="0.5" value="{:g}")", low, high,
                       value);
  };
  std::string out = html_paragraph(
      "Drag the circle, or its rim, to where the lens drew the horizon; or type. The command below makes the maps in "
      "full. "
      "The previews are computed in this page from the small copy of the photograph that it shows, with 8 bits.");
  out += fmt::format(
      "<div id=\"circle-tool\" hidden=\"hidden\" data-name=\"{}\" data-width=\"{}\" data-height=\"{}\" "
      "data-codes=\"{}\" data-kept=\"{}\" data-outside=\"{}\">\n",
      escape(page.photograph_name), width, height, page.codes ? "yes" : "no", escape(page.kept_options),
      name_of(page.outside));
  out += fmt::format(
      "<div class=\"pair\">\n<div class=\"marked\">{}<svg id=\"circle-overlay\" viewBox=\"0 0 {} {}\" "
      "aria-hidden=\"true\" style=\"touch-action: none; cursor: move\"><circle id=\"circle-ring\" class=\"accent\" "
      "style=\"fill: none; stroke: currentColor; stroke-width: 2px; vector-effect: "
      "non-scaling-stroke\"></circle><circle "
      "id=\"circle-heart\" class=\"accent\"></circle></svg></div>\n",
      fmt::format(
          "<img id=\"circle-photo\" style=\"display: block; width: 100%; height: auto\" src=\"{}\" width=\"{}\" "
          "height=\"{}\" alt=\"the photograph\">",
          png_data_uri(copy), copy.width(), copy.height()),
      width, height);
  out +=
      "<div>\n" + input("x", "centre, pixels from the left", value_attributes(circle.center_x, 0, width)) +
      input("y", "centre, pixels from the top", value_attributes(circle.center_y, 0, height)) +
      input("radius", "radius of the horizon, pixels", value_attributes(circle.radius_x, 1, std::max(width, height))) +
      input("shininess", "shininess, 1 is irradiance; up to 100 in the preview",
            fmt::format(R"(type="range" min="1" max="100" step="1" value="{:g}")", shininess)) +
      input("ground", "ground",
            fmt::format(R"(type="color" value="#{:02x}{:02x}{:02x}")", ground.r, ground.g, ground.b)) +
      "</div>\n</div>\n";
  out += "<pre style=\"margin-top: 18px\" aria-live=\"polite\"><code id=\"circle-command\"></code></pre>\n";
  out += "<div class=\"plates\">\n" + preview("published") + preview("corrected") + "</div>\n</div>\n";
  return out + fmt::format("<script>{}</script>\n", fisheye_page_script());
}

/// Pages carry no script but this one, which needs leave to run. It still cannot fetch anything.
std::string with_leave_for_script(std::string html) {
  constexpr std::string_view kPolicy = "default-src 'none'; ";
  const std::size_t at = html.find(kPolicy);
  check(at != std::string::npos, "a page says what it may load");
  if (html.find("script-src") == std::string::npos) html.insert(at + kPolicy.size(), "script-src 'unsafe-inline'; ");
  return html;
}

std::string explanation(const FisheyePage& page) {
  std::string out = html_paragraph(
      "The program of Tokoi 2015, “Irradiance mapping (2)”, averages a fisheye photograph around each direction q with "
      "the "
      "weights max(p·q, 0)^shininess. Two things in it differ from the integral it stands for.");
  out += html_paragraph(
      "Weights. In an equidistant fisheye a pixel covers a solid angle that goes like sin T / T with T its zenith "
      "angle. The "
      "program takes the angle between the pixel and q in its place, and so counts pixels near the horizon too much: "
      "by 5 % "
      "at 30°, 21 % at 60°, 49 % at 85°.");
  out += html_paragraph(
      "Ground. It sums over the square around the circle. Its corners hold the ground's colour, but they are 19 % of "
      "the "
      "lower half of the sphere only, so that a surface which sees much ground gets too little of it. The two errors "
      "work "
      "against each other here and there: to correct only one can be worse than none.");
  out += html_paragraph(
      page.outside == FisheyeOutside::kGround
          ? "Outside of its circle the published map shows the ground, with a jump at the horizon; there the corrected "
            "panorama and cube go on, and its paraboloid shows the ground too, as both were asked for."
          : "Outside of the circle both paraboloids go on with means of their own, as the author's footnote suggests.");
  out += html_paragraph(
      "The published panorama and cube are what a renderer reads from the published paraboloid. Its pixels were "
      "computed as "
      "if the outermost centres lay on the map's edge, and are read half a texel off there.");
  return out;
}

}  // namespace

std::string_view name_of(FisheyeOutside outside) {
  switch (outside) {
    case FisheyeOutside::kGround:
      return "published";
    case FisheyeOutside::kExtended:
      return "extended";
    case FisheyeOutside::kTwo:
      break;
  }
  return "two";
}

std::string fisheye_page_html(const FisheyePage& page) {
  check(page.photograph != nullptr && !page.studies.empty(), "a page about a photograph needs it and a map");
  check(page.averaging_codes.empty() || page.averaging_codes.size() == page.studies.size(),
        "the errors of averaging codes are one for each map");
  const Display display(page);
  HtmlPage out = {.title = page.photograph_name,
                  .subtitle = page.codes ? "Fisheye photograph: maps of its codes, as published and corrected"
                                         : "Fisheye photograph: maps of its light, as published and corrected",
                  .lead_html = {},
                  .sections = {}};
  for (std::size_t i = 0; i < page.studies.size(); ++i) {
    out.sections.push_back({fmt::format("map-{}", i), quantity_of(page.studies[i]), study_html(page, i, display)});
  }
  out.sections.push_back({"circle", "Circle", circle_html(page, display)});
  out.sections.push_back({"how", "What differs", explanation(page)});
  out.footer = page.program;
  return with_leave_for_script(html_page(out));
}

}  // namespace zonal
