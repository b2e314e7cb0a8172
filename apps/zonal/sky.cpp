#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "apps/zonal/layouts.h"
#include "apps/zonal/numbers.h"
#include "apps/zonal/output_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/light/synthetic.h"

namespace zonal {
namespace {

enum class Sky { kDaylight, kFurnace, kGradient, kSun, kChecker };

/// Options that only some skies have are empty until given, so that one given in vain is noticed.
struct SkyOptions {
  std::string kind = "daylight";
  OutputOptions output;
  std::optional<double> elevation_deg, azimuth_deg, turbidity, diameter_deg, contrast, step_deg;
  std::string albedo, radiance;
  bool no_sun = false;
};

constexpr int kPanoramaHeight = 512, kFaceEdge = 256;

Sky sky_named(const std::string& name) {
  if (name == "daylight") return Sky::kDaylight;
  if (name == "furnace") return Sky::kFurnace;
  if (name == "gradient") return Sky::kGradient;
  if (name == "sun") return Sky::kSun;
  if (name == "checker") return Sky::kChecker;
  throw Error(ErrorKind::kUsage, "there is no sky '" + name + "'", "say daylight, furnace, gradient, sun or checker");
}

void check_parameters(const SkyOptions& o, Sky sky) {
  const auto only_for = [&](bool given, const char* option, bool fits) {
    if (given && !fits) {
      throw Error(ErrorKind::kUsage, fmt::format("the sky {} has no {}", o.kind, option),
                  "zonal sky --help says which sky has what");
    }
  };
  const bool has_sun = sky == Sky::kDaylight || sky == Sky::kSun;
  only_for(o.elevation_deg.has_value(), "--elevation", has_sun);
  only_for(o.azimuth_deg.has_value(), "--azimuth", has_sun);
  only_for(o.turbidity.has_value(), "--turbidity", sky == Sky::kDaylight);
  only_for(!o.albedo.empty(), "--albedo", sky == Sky::kDaylight);
  only_for(o.no_sun, "--no-sun", sky == Sky::kDaylight);
  only_for(o.diameter_deg.has_value(), "--diameter", sky == Sky::kSun);
  only_for(o.contrast.has_value(), "--contrast", sky == Sky::kSun);
  only_for(o.step_deg.has_value(), "--step", sky == Sky::kChecker);
  only_for(!o.radiance.empty(), "--radiance", sky == Sky::kFurnace || sky == Sky::kSun || sky == Sky::kChecker);
}

Environment daylight_of(const SkyOptions& o, const Projection& to, ImageSize size, const Run& run) {
  DaylightOptions daylight_options;
  if (o.elevation_deg) daylight_options.elevation_deg = *o.elevation_deg;
  if (o.azimuth_deg) daylight_options.azimuth_deg = *o.azimuth_deg;
  if (o.turbidity) daylight_options.turbidity = *o.turbidity;
  if (!o.albedo.empty()) daylight_options.ground_albedo = color_in(o.albedo, "--albedo");
  daylight_options.sun = !o.no_sun;
  return daylight_sky(to, size, daylight_options, run);
}

Environment sun_of(const SkyOptions& o, const Projection& to, ImageSize size, Rgb radiance, const Run& run) {
  SunOptions sun_options;
  sun_options.sky = radiance;
  if (o.elevation_deg || o.azimuth_deg) {
    const double elevation = radians(o.elevation_deg.value_or(35)), azimuth = radians(o.azimuth_deg.value_or(0));
    sun_options.toward_sun = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                              std::sin(elevation)};
  }
  if (o.diameter_deg) sun_options.diameter_deg = *o.diameter_deg;
  if (o.contrast) sun_options.contrast = *o.contrast;
  return sun(to, size, sun_options, run);
}

Environment painted(const SkyOptions& o, Sky sky, const Projection& to, ImageSize size, const Run& run) {
  const Rgb radiance = o.radiance.empty() ? Rgb{1, 1, 1} : color_in(o.radiance, "--radiance");
  switch (sky) {
    case Sky::kDaylight:
      return daylight_of(o, to, size, run);
    case Sky::kFurnace:
      return furnace(to, size, radiance);
    case Sky::kGradient:
      return gradient(to, size);
    case Sky::kSun:
      return sun_of(o, to, size, radiance, run);
    case Sky::kChecker:
      break;
  }
  return checker(to, size, o.step_deg.value_or(15), radiance, run);
}

void run_sky(const SkyOptions& options, Call& call) {
  const Sky sky = sky_named(options.kind);
  check_parameters(options, sky);
  const Projection to = target_of(options.output, Layout::kEquirect);
  check_output(options.output, to.layout);
  const int fallback = is_cube(to.layout) ? kFaceEdge : kPanoramaHeight;
  const ImageSize size = image_size(to.layout, options.output.size_px > 0 ? options.output.size_px : fallback);
  call.console.field("sky", options.kind);
  write_map(painted(options, sky, to, size, call.run), options.output, "radiance", options.kind + " sky", call);
}

}  // namespace

void add_sky(CLI::App& app, Call& call) {
  auto options = std::make_shared<SkyOptions>();
  CLI::App& verb = *app.add_subcommand("sky", "A built-in sky: daylight, furnace, gradient, sun or checker.");
  constexpr const char* kGroup = "Sky";
  verb.add_option("KIND", options->kind,
                  "daylight, furnace (the same everywhere), gradient (1 + x + y/2), sun (a disc) or checker")
      ->capture_default_str();
  verb.add_option("--elevation", options->elevation_deg, "daylight, sun: of the sun, degrees above the horizon")
      ->group(kGroup);
  verb.add_option("--azimuth", options->azimuth_deg, "daylight, sun: of the sun, degrees from +X toward +Y")
      ->group(kGroup);
  verb.add_option("--turbidity", options->turbidity, "daylight: haze, 2 (clear) to 10")->group(kGroup);
  verb.add_option("--albedo", options->albedo, "daylight: of the ground, R,G,B")->group(kGroup);
  verb.add_flag("--no-sun", options->no_sun, "daylight: leave the sun's disc out")->group(kGroup);
  verb.add_option("--diameter", options->diameter_deg, "sun: of the disc, degrees")
      ->check(CLI::Range(1e-6, 180.0))
      ->group(kGroup);
  verb.add_option("--contrast", options->contrast, "sun: radiance of the disc over the sky's")
      ->check(CLI::Range(0.0, 1e12))
      ->group(kGroup);
  verb.add_option("--step", options->step_deg, "checker: side of a square, degrees")
      ->check(CLI::Range(0.1, 180.0))
      ->group(kGroup);
  verb.add_option("--radiance", options->radiance, "furnace, sun, checker: of the sky or the white squares, R,G,B")
      ->group(kGroup);
  add_output_options(verb, options->output, "512 for panoramas, 256 for cube faces if not said");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal sky daylight --elevation 20 --turbidity 4 -o evening.exr\n"
      "  zonal sky sun --diameter 0.53 --contrast 1e6 -o sun.exr\n"
      "  zonal sky furnace --to cube --size 64 -o white.ktx2");
  verb.callback([options, &call] { run_sky(*options, call); });
}

}  // namespace zonal
