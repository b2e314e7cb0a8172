#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "apps/zonal/input_options.h"
#include "apps/zonal/output.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

JsonValue rgb(const RgbD& c) { return JsonValue::Array{c.r, c.g, c.b}; }
JsonValue xyz(Vec3 v) { return JsonValue::Array{v.x, v.y, v.z}; }
double azimuth_deg(Vec3 toward) { return degrees(std::atan2(toward.y, toward.x)); }
double elevation_deg(Vec3 toward) { return degrees(std::atan2(toward.z, std::hypot(toward.x, toward.y))); }

JsonValue sun_json(const std::optional<SunEstimate>& sun) {
  if (!sun) return nullptr;
  return JsonValue::Object{{"toward", xyz(sun->toward_sun)},
                           {"azimuth_deg", azimuth_deg(sun->toward_sun)},
                           {"elevation_deg", elevation_deg(sun->toward_sun)},
                           {"diameter_deg", sun->diameter_deg},
                           {"irradiance", rgb(sun->irradiance)},
                           {"energy_share", sun->energy_share}};
}

void answer_json(const Input& input, Console& console) {
  const Survey& s = input.survey;
  JsonValue::Array files;
  for (const auto& file : input.loaded.files) files.push_back(file.string());
  console.field("files", std::move(files));
  console.field("hash", input.loaded.hash);
  console.field("format", input.loaded.format);
  console.field("width", input.file_size.width);
  console.field("height", input.file_size.height);
  console.field("projection", name_of(input.loaded.environment.projection.layout));
  console.field("projection_reason", input.loaded.projection_reason);
  console.field("srgb_decoded", input.loaded.srgb_decoded);
  console.field("alpha", input.loaded.alpha);
  console.field("coverage", s.shown / (4 * kPi));
  console.field("texels", s.texels);
  console.field("mean", rgb(s.mean));
  console.field("mean_luminance", luminance(s.mean));
  console.field("min_luminance", s.min_luminance);
  console.field("max_luminance", s.max_luminance);
  console.field("toward_max", xyz(s.toward_max));
  console.field("nan_texels", s.nan_texels);
  console.field("inf_texels", s.inf_texels);
  console.field("negative_texels", s.negative_texels);
  console.field("negative_energy_share", s.negative_energy_share);
  console.field("clipped_sun", s.clipped_sun);
  console.field("sun", sun_json(s.sun));
}

/// To a tenth, and without a minus before zero.
double tenths(double value) { return std::round(10 * value) / 10 + 0.0; }

std::string place_of(Vec3 toward) {
  return fmt::format("azimuth {:.1f}°, elevation {:.1f}°", tenths(azimuth_deg(toward)), tenths(elevation_deg(toward)));
}

void answer_table(const Input& input, Console& console) {
  const Survey& s = input.survey;
  const auto row = [&](const char* name, const std::string& value) {
    console.answer(fmt::format("{:<12} {}", name, value));
  };
  std::string format = input.loaded.format;
  if (input.loaded.srgb_decoded) format += ", read as sRGB";
  if (input.loaded.alpha) format += ", alpha left out";
  if (input.loaded.files.size() > 1) format = fmt::format("{} files, {}", input.loaded.files.size(), format);
  row("file", input.loaded.files[0].string());
  row("format", format);
  row("size", words_of(input.file_size));
  row("projection",
      fmt::format("{} ({})", name_of(input.loaded.environment.projection.layout), input.loaded.projection_reason));
  row("shows", fmt::format("{:.4g} % of the sphere, {} texels", 100 * s.shown / (4 * kPi), s.texels));
  row("mean", fmt::format("{:.6g} {:.6g} {:.6g}, luminance {:.6g}", s.mean.r, s.mean.g, s.mean.b, luminance(s.mean)));
  row("range", fmt::format("luminance {:.6g} to {:.6g}", s.min_luminance, s.max_luminance));
  row("brightest", place_of(s.toward_max));
  row("doubtful", fmt::format("{} NaN, {} infinite, {} negative ({} of the energy)", s.nan_texels, s.inf_texels,
                              s.negative_texels, percent(s.negative_energy_share)));
  if (!s.sun) {
    row("sun", "none stands out");
    return;
  }
  row("sun", fmt::format("{}, diameter {:.2f}°", place_of(s.sun->toward_sun), s.sun->diameter_deg));
  row("", fmt::format("irradiance {:.6g} {:.6g} {:.6g}, {} of the energy{}", s.sun->irradiance.r, s.sun->irradiance.g,
                      s.sun->irradiance.b, percent(s.sun->energy_share), s.clipped_sun ? "; it looks clipped" : ""));
}

void run_info(const InputOptions& options, Call& call) {
  const Input input = read_input(options, call, true);
  answer_json(input, call.console);
  answer_table(input, call.console);
}

}  // namespace

void add_info(CLI::App& app, Call& call) {
  auto options = std::make_shared<InputOptions>();
  CLI::App& verb =
      *app.add_subcommand("info", "What a picture holds: size, projection and why, range, mean, doubtful values, sun.");
  add_input_options(verb, *options);
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal info sunset.exr\n"
      "  zonal info probe.hdr --from angular\n"
      "  zonal info faces/ --json");
  verb.callback([options, &call] { run_info(*options, call); });
}

}  // namespace zonal
