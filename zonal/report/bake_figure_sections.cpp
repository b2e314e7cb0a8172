#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "zonal/report/bake_sections.h"
#include "zonal/report/figure.h"
#include "zonal/report/text.h"
#include "zonal/report/warnings.h"

namespace zonal {
namespace {

/// A quantity per channel and its luminance.
std::vector<std::string> channel_row(std::string name, RgbD value) {
  return {std::move(name), number(value.r, 4), number(value.g, 4), number(value.b, 4), number(luminance(value), 4)};
}

std::vector<HtmlColumn> channel_columns() {
  return {{"quantity"}, {"red", true}, {"green", true}, {"blue", true}, {"luminance", true}};
}

std::vector<std::string> accuracy_row(std::string what, const ConvolveReport& report,
                                      const std::optional<Verification>& verified) {
  std::vector<std::string> row = {std::move(what), number(report.bound_to_mean, 2), number(report.bound_to_peak, 2)};
  if (verified) {
    row.insert(row.end(), {number(verified->rms, 2), number(verified->worst, 2), std::to_string(verified->directions)});
  } else {
    row.insert(row.end(), {"–", "–", "–"});
  }
  return row;
}

}  // namespace

std::string histogram_section(const Survey& survey) {
  const auto held = [](double solid_angle) { return solid_angle > 0; };
  const auto& bins = survey.histogram;
  const auto begin = std::find_if(bins.begin(), bins.end(), held);
  const auto end = std::find_if(bins.rbegin(), bins.rend(), held).base();
  if (begin == bins.end()) return html_paragraph("No texel has a finite luminance.");

  double total = 0;
  for (const double solid_angle : bins) total += solid_angle;
  BarChart chart = {.description = "Share of the sphere by luminance, in stops.",
                    .x = {.label = "luminance in stops: log₂ of radiance units", .whole = true},
                    .y = {.label = "share of the sphere", .log = true},
                    .first = static_cast<double>(kFirstBinLog2 + (begin - bins.begin())),
                    .width = 1,
                    .heights = {}};
  HtmlTable table = {"Solid angle by luminance.", {{"stops"}, {"solid angle, sr", true}, {"share", true}}, {}};
  for (auto bin = begin; bin != end; ++bin) {
    const double low = chart.first + static_cast<double>(bin - begin);
    chart.heights.push_back(*bin / total);
    table.rows.push_back({number(low) + " to " + number(low + 1), number(*bin, 4), percent(*bin / total)});
  }
  const double mean = luminance(survey.mean);
  if (mean > 0) chart.marks.push_back({std::log2(mean), "mean"});
  return html_figure(
             bar_chart(chart),
             escape(fmt::format(
                 "Weighted by solid angle, one bar a stop, logarithmic. Luminance from {} to {} radiance units.",
                 number(survey.min_luminance), number(survey.max_luminance)))) +
         html_details("Bins as a table", html_table(table));
}

std::string energy_section(const BakePage& page) {
  return html_table(
      {"Radiance in radiance units, those of the input (W·sr⁻¹·m⁻² when it is calibrated); irradiance in radiance "
       "units · sr.",
       channel_columns(),
       {channel_row("mean radiance", page.survey.mean), channel_row("irradiance, facing up (+Z)", page.irradiance_up),
        channel_row("irradiance, facing down (−Z)", page.irradiance_down)}});
}

std::string sun_section(const Survey& survey) {
  if (!survey.sun) return html_paragraph("Nothing compact stands out like a sun or a lamp.");
  const SunEstimate& sun = *survey.sun;
  return html_facts({{"azimuth, from +X toward +Y", angle(std::atan2(sun.toward_sun.y, sun.toward_sun.x))},
                     {"elevation", angle(std::asin(std::clamp(sun.toward_sun.z, -1.0, 1.0)))},
                     {"diameter", number(sun.diameter_deg) + "°"},
                     {"share of the energy", percent(sun.energy_share)}}) +
         html_table({"In radiance units · sr, on a surface that faces it, above the sky around it.",
                     channel_columns(),
                     {channel_row("irradiance", sun.irradiance)}});
}

std::string warnings_section(const BakePage& page) {
  std::vector<Warning> warnings = warnings_of(page.survey);
  for (const std::string& warning : page.warnings) warnings.push_back({warning, ""});
  if (warnings.empty()) {
    return html_paragraph("No warnings: every texel is finite, none is negative, nothing looks clipped.");
  }
  std::string out = "<ul class=\"notes\">\n";
  for (const auto& [what, detail] : warnings) {
    out += fmt::format("<li class=\"warning\"><b>{}</b>{}</li>\n", escape(what), escape(detail));
  }
  return out + "</ul>\n";
}

std::string files_section(const std::vector<WrittenFile>& files) {
  HtmlTable table = {"Beside this page.", {{"file"}, {"content"}, {"size", true}}, {}};
  std::uint64_t total = 0;
  for (const auto& [name, what, bytes] : files) {
    table.rows.push_back({name, what, byte_count(bytes)});
    total += bytes;
  }
  table.caption += fmt::format(" {} file{}, {}.", files.size(), files.size() == 1 ? "" : "s", byte_count(total));
  return html_table(table);
}

std::string accuracy_section(const BakePage& page) {
  HtmlTable table = {
      "Bound: what the error cannot exceed, as a fraction of the environment’s mean and of its brightest texel. "
      "Measured: relative difference from the sum over all texels, at random directions; values below a thousandth of "
      "the mean count as that much.",
      {{"map"},
       {"bound / mean", true},
       {"bound / peak", true},
       {"measured RMS", true},
       {"measured worst", true},
       {"directions", true}},
      {accuracy_row("irradiance", page.irradiance_report, page.irradiance_verified)}};
  std::string widened;
  bool verified = page.irradiance_verified.has_value();
  std::int64_t zeroed = page.irradiance_report.zeroed_texels;
  for (std::size_t i = 0; i < page.chain.size(); ++i) {
    const ChainLevel& level = page.chain[i];
    table.rows.push_back(accuracy_row(fmt::format("chain, level {}", i), level.report, level.verified));
    verified = verified || level.verified;
    zeroed += level.report.zeroed_texels;
    if (level.report.widened_deg > 0) {
      widened += html_paragraph(fmt::format("Level {}: the lobe is too sharp for its bands and was widened by {}°.", i,
                                            number(level.report.widened_deg, 2)));
    }
  }
  std::string out = html_table(table) + widened;
  if (zeroed > 0) {
    out += html_paragraph(fmt::format("{} texel{} came out below zero by less than the bound and went to zero.", zeroed,
                                      zeroed == 1 ? "" : "s"));
  }
  if (!verified) out += html_paragraph("Nothing was measured in this bake; --verify measures it.", "quiet");
  return out;
}

std::string timings_section(const std::vector<Timing>& timings) {
  HtmlTable table = {"Wall time.", {{"stage"}, {"time", true}, {"share", true}}, {}};
  double total = 0;
  for (const Timing& timing : timings) total += timing.seconds;
  for (const auto& [stage, seconds] : timings) {
    table.rows.push_back({stage, duration(seconds), total > 0 ? percent(seconds / total, 2) : "–"});
  }
  table.rows.push_back({"all", duration(total), "100 %"});
  return html_table(table);
}

std::string loading_section(const std::vector<Snippet>& snippets) {
  std::string out;
  for (const auto& [title, code] : snippets) out += html_heading(title) + html_code(code);
  return out;
}

}  // namespace zonal
