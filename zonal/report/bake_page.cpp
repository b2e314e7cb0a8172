#include "zonal/report/bake_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "zonal/report/bake_pictures.h"
#include "zonal/report/bake_sections.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

/// The figures that a reader looks for first.
std::string readout(const BakePage& page) {
  std::vector<Fact> facts = {
      {"texels", fmt::format("{} × {}", page.survey.size.width, page.survey.size.height)},
      {"mean luminance, radiance units", number(luminance(page.survey.mean))},
  };
  const double stops = std::log2(page.survey.max_luminance / luminance(page.survey.mean));
  if (std::isfinite(stops)) facts.push_back({"brightest, stops above the mean", number(stops)});
  if (page.survey.sun) facts.push_back({"of the energy in the sun", percent(page.survey.sun->energy_share)});
  double bound = 0;
  for (const ChainLevel& level : page.chain) bound = std::max(bound, level.report.bound_to_mean);
  if (!page.chain.empty()) facts.push_back({"largest error bound of the chain, of the mean", number(bound, 2)});
  double seconds = 0;
  for (const Timing& timing : page.timings) seconds += timing.seconds;
  if (!page.timings.empty()) facts.push_back({"to bake", duration(seconds)});

  std::string out = "<dl class=\"readout\">\n";
  for (const auto& [name, value] : facts) {
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escape(name), escape(value));
  }
  return out + "</dl>\n";
}

}  // namespace

std::string bake_page_html(const BakePage& page, const Run& run) {
  const BakePictures pictures = draw_bake_pictures(page, run);
  HtmlPage out = {.title = page.title,
                  .subtitle = page.subtitle,
                  .lead_html = readout(page),
                  .sections = {},
                  .footer = page.footer,
                  .style = page.viewer.style,
                  .has_scripts = !page.viewer.html.empty()};
  out.sections.push_back({"panorama", "Panorama", panorama_section(page, pictures)});
  if (!page.viewer.html.empty()) out.sections.push_back({"live", "Objects in this light", page.viewer.html});
  out.sections.push_back({"irradiance", "Irradiance", irradiance_section(page, pictures)});
  if (!page.chain.empty()) out.sections.push_back({"chain", "Prefiltered chain", chain_section(page, pictures)});
  if (!page.sh.empty()) out.sections.push_back({"sh", "Spherical harmonics", sh_section(page, pictures)});
  out.sections.push_back({"histogram", "Histogram", histogram_section(page.survey)});
  out.sections.push_back({"energy", "Energy", energy_section(page)});
  out.sections.push_back({"sun", "Sun", sun_section(page.survey)});
  out.sections.push_back({"warnings", "Warnings", warnings_section(page)});
  if (!page.split_sum.empty())
    out.sections.push_back({"split-sum", "Split-sum table", split_sum_section(page, pictures)});
  out.sections.push_back({"files", "Files", files_section(page.files)});
  out.sections.push_back({"settings", "Settings", html_facts(page.settings)});
  out.sections.push_back({"accuracy", "Accuracy", accuracy_section(page)});
  out.sections.push_back({"timings", "Timings", timings_section(page.timings)});
  if (!page.loading.empty()) out.sections.push_back({"loading", "Loading", loading_section(page.loading)});
  return html_page(out);
}

}  // namespace zonal
