#include "zonal/report/compare_page.h"

#include <fmt/format.h>

#include <string_view>

#include "zonal/image/compare.h"
#include "zonal/image/tonemap.h"
#include "zonal/report/png_uri.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

std::string size_of(const Image<Rgb>& image) { return fmt::format("{} × {}", image.width(), image.height()); }

std::string value_at(const Image<Rgb>& image, int x, int y) {
  const Rgb value = image(x, y);
  return fmt::format("{}, {}, {}", number(value.r, 6), number(value.g, 6), number(value.b, 6));
}

std::string labelled(std::string_view label, const Image<Rgb8>& picture) {
  return html_figure(
      html_picture({png_data_uri(picture), picture.width(), picture.height(), std::string(label), "pixels"}),
      fmt::format("<b>{}</b>", escape(label)));
}

std::string tonemapped(std::string_view label, const Image<Rgb>& image, const Tonemap& curve) {
  return image.empty() ? html_paragraph(std::string(label) + ": an empty picture.")
                       : labelled(label, tonemap(image, curve));
}

float largest(const Image<float>& error) {
  float most = 0;
  for (const float value : error.values()) {
    if (value > most) most = value;  // not for NaN
  }
  return most;
}

std::vector<Fact> metrics(const Image<Rgb>& expected, const Image<Rgb>& got) {
  const Comparison c = compare(got, expected);
  return {{"texels compared", std::to_string(c.texels)},
          {"not finite", std::to_string(c.not_finite)},
          {"RMSE", number(c.rmse, 6)},
          {"RMSE / RMS of the expected", number(c.relative_rmse, 6)},
          {"mean error", number(c.mean_error, 6)},
          {"PSNR", number(c.psnr_db, 4) + " dB"},
          {"largest error", number(c.max_error, 6)},
          {"worst texel (x, y)", fmt::format("{}, {}", c.worst_x, c.worst_y)},
          {"expected there", value_at(expected, c.worst_x, c.worst_y)},
          {"got there", value_at(got, c.worst_x, c.worst_y)}};
}

}  // namespace

std::string compare_page_html(const ComparePage& page) {
  const bool same_size = page.expected.width() == page.got.width() && page.expected.height() == page.got.height();
  const bool comparable = same_size && !page.expected.empty();
  const Tonemap curve = {.exposure_ev = page.expected.empty() ? 0 : auto_exposure_ev(page.expected)};

  std::string pictures = tonemapped("expected", page.expected, curve) + tonemapped("got", page.got, curve);
  std::string figures;
  if (comparable) {
    const Image<float> error = difference(page.got, page.expected);
    const float full_scale = largest(error);
    pictures += labelled(fmt::format("difference, white at {}", number(full_scale)),
                         false_color(error, full_scale > 0 ? full_scale : 1));
    figures = html_facts(metrics(page.expected, page.got));
  } else {
    figures = html_paragraph(
        fmt::format("The sizes are not comparable: expected {}, got {}.", size_of(page.expected), size_of(page.got)));
  }

  HtmlPage out = {.title = page.title, .subtitle = "Expected, got and difference", .lead_html = {}, .sections = {}};
  out.sections.push_back({"pictures", "Pictures", "<div class=\"pair\">\n" + pictures + "</div>\n"});
  out.sections.push_back({"figures", "Figures", figures});
  if (!page.facts.empty()) out.sections.push_back({"facts", "Facts", html_facts(page.facts)});
  return html_page(out);
}

}  // namespace zonal
