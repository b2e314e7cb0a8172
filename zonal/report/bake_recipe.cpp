#include "zonal/report/bake_record.h"

#include <fmt/format.h>

#include "zonal/report/text.h"
#include "zonal/report/warnings.h"

namespace zonal {
namespace {

JsonValue rgb(const RgbD& c) { return JsonValue::Array{c.r, c.g, c.b}; }

JsonValue text_list(const std::vector<std::string>& lines) {
  JsonValue::Array list;
  for (const std::string& line : lines) list.push_back(line);
  return list;
}

JsonValue input_json(const BakeOrigin& origin) {
  JsonValue::Array files;
  for (const auto& file : origin.input.files) files.push_back(file.string());
  return JsonValue::Object{{"files", std::move(files)},
                           {"hash", origin.input.hash},
                           {"format", origin.input.format},
                           {"width", origin.input_size.width},
                           {"height", origin.input_size.height},
                           {"projection", name_of(origin.input.environment.projection.layout)},
                           {"projection_reason", origin.input.projection_reason},
                           {"srgb_decoded", origin.input.srgb_decoded},
                           {"notes", text_list(origin.input.notes)}};
}

JsonValue settings_json(const Bake& bake, const BakeOptions& options, const BakeFileOptions& files) {
  return JsonValue::Object{{"size", options.size_px},
                           {"levels", bake.chain.size()},
                           {"lobe", name_of(options.lobe)},
                           {"roughness_map", name_of(options.roughness_map)},
                           {"bands", options.bands},
                           {"irradiance_size", options.irradiance_px},
                           {"table_size", options.table_px},
                           {"format", name_of(files.format)},
                           {"float32", files.float32},
                           {"layout", files.format == MapFormat::kKtx2 ? "cube" : name_of(files.layout)},
                           {"engine", files.engine ? JsonValue(files.engine->name) : JsonValue()}};
}

JsonValue::Object report_json(const ConvolveReport& report, const std::optional<Verification>& verified) {
  JsonValue::Object fields = {{"bands", report.bands},
                              {"points", report.points},
                              {"widened_deg", report.widened_deg},
                              {"error_bound", report.error_bound},
                              {"bound_to_mean", report.bound_to_mean},
                              {"bound_to_peak", report.bound_to_peak},
                              {"zeroed_texels", report.zeroed_texels}};
  if (verified) {
    fields.emplace_back("verified", JsonValue::Object{{"directions", verified->directions},
                                                      {"rms_relative_error", verified->rms},
                                                      {"worst_relative_error", verified->worst}});
  }
  return fields;
}

JsonValue maps_json(const Bake& bake) {
  JsonValue::Array maps;
  const auto add = [&](JsonValue::Object fields, const ConvolveReport& report,
                       const std::optional<Verification>& verified) {
    for (auto& field : report_json(report, verified)) fields.push_back(std::move(field));
    maps.push_back(std::move(fields));
  };
  add({{"map", "irradiance"}}, bake.irradiance_report, bake.irradiance_verified);
  for (std::size_t i = 1; i < bake.chain.size(); ++i) {
    const ChainLevel& level = bake.chain[i];
    add({{"map", "specular"}, {"level", i}, {"roughness", level.roughness}, {"alpha", level.alpha}}, level.report,
        level.verified);
  }
  return maps;
}

JsonValue fits_json(const std::vector<ShFit>& fits) {
  JsonValue::Array list;
  for (const ShFit& fit : fits) {
    list.push_back(
        JsonValue::Object{{"bands", fit.bands}, {"rms_to_maximum", fit.rms}, {"worst_to_maximum", fit.worst}});
  }
  return list;
}

JsonValue results_json(const std::vector<BakedFile>& files) {
  JsonValue::Array list;
  for (const auto& [file, hash, bound, warning] : files) {
    list.push_back(JsonValue::Object{{"file", file.name}, {"what", file.what}, {"bytes", file.bytes}, {"hash", hash}});
  }
  return list;
}

}  // namespace

std::string bake_recipe_json(const Bake& bake, const Survey& survey, const BakeOptions& options,
                             const BakeFileOptions& file_options, const BakeOrigin& origin,
                             const std::vector<BakedFile>& files) {
  std::vector<std::string> warnings;
  for (const auto& [what, detail] : warnings_of(survey)) warnings.push_back(what + " " + detail);
  warnings.insert(warnings.end(), origin.warnings.begin(), origin.warnings.end());
  JsonValue::Object recipe = {{"format", "zonal-recipe"},
                              {"version", 1},
                              {"program", origin.program},
                              {"command", text_list(origin.command)},
                              {"input", input_json(origin)},
                              {"settings", settings_json(bake, options, file_options)},
                              {"mean_radiance", rgb(survey.mean)},
                              {"irradiance_up", rgb(bake.irradiance_up)},
                              {"irradiance_down", rgb(bake.irradiance_down)},
                              {"results", results_json(files)},
                              {"maps", maps_json(bake)},
                              {"sh_irradiance_errors", fits_json(bake.fits)},
                              {"warnings", text_list(warnings)}};
  if (origin.timings) {
    JsonValue::Object timings;
    for (const auto& [stage, seconds] : bake.timings) timings.emplace_back(stage, seconds);
    recipe.emplace_back("seconds", std::move(timings));
  }
  return json_text(recipe);
}

}  // namespace zonal
