#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "apps/zonal/coefficients.h"
#include "apps/zonal/light_shapes.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"

namespace zonal {
namespace {

void run_light(const LightOptions& options, const std::filesystem::path& path, Call& call) {
  const Light light = light_of(options, call.run);
  call.console.field("light", options.shape);
  if (options.normalise) {
    call.console.field("normalising_factor", light.normalising_factor);
    call.console.note(fmt::format("scaled by {:.6g}", light.normalising_factor));
  }
  if (options.shape == "sky" && !options.normalise) call.console.note("radiance is in kcd/m²");
  if (std::ranges::all_of(light.radiance.values(), [](RgbD c) { return c == RgbD(); })) {
    call.console.warn("This light is black.");
  }
  write_coefficients({ShQuantity::kRadiance, light.radiance}, path, call);
}

}  // namespace

void add_light(CLI::App& app, Call& call) {
  auto options = std::make_shared<LightOptions>();
  auto path = std::make_shared<std::filesystem::path>();
  CLI::App& verb =
      *app.add_subcommand("light", "A light as coefficients of its radiance: " + light_shape_names() + ".");
  constexpr const char* kGroup = "Light";
  verb.add_option("SHAPE", options->shape,
                  light_shape_names() +
                      ". Exact in every band: what a picture of the light, infinitely sharp, would project to")
      ->required();
  verb.add_option("--toward", options->toward,
                  "X,Y,Z of any length, from the lit point to the light, to the sun, or up (hemisphere); up if nothing "
                  "is said")
      ->group(kGroup);
  verb.add_option("--azimuth", options->azimuth_deg, "the same in degrees from +X toward +Y, 0 if not said")
      ->group(kGroup);
  verb.add_option("--elevation", options->elevation_deg,
                  "the same in degrees above the horizon, 0 if not said; of the sky's sun, 35")
      ->check(CLI::Range(-90.0, 90.0))
      ->group(kGroup);
  verb.add_option("--half-angle", options->half_angle_deg,
                  "cone, smooth-cone: from the middle to the rim in degrees, up to 180")
      ->group(kGroup);
  verb.add_option("--center", options->center, "sphere: X,Y,Z of its middle; the lit point is the origin")
      ->group(kGroup);
  verb.add_option("--radius", options->radius, "sphere: in the same unit")->group(kGroup);
  verb.add_option("--vertex", options->vertices,
                  "polygon: X,Y,Z of a corner, three times or more in order around it; the lit point is the origin")
      ->type_size(1)
      ->allow_extra_args(false)
      ->group(kGroup);
  verb.add_option("--irradiance", options->irradiance,
                  "directional: R,G,B or GREY on a surface that faces it, 1 if not said")
      ->group(kGroup);
  verb.add_option("--radiance", options->radiance,
                  "R,G,B or GREY of the light, in the middle of a smooth-cone, in the upper half of a hemisphere; 1 if "
                  "not said")
      ->group(kGroup);
  verb.add_option("--ground", options->ground, "hemisphere: R,G,B or GREY in the lower half, 0 if not said")
      ->group(kGroup);
  verb.add_option("--turbidity", options->turbidity, "sky: haze, 2 (clear) to 10; 3 if not said")->group(kGroup);
  verb.add_option("--albedo", options->albedo, "sky: of the ground, R,G,B")->group(kGroup);
  verb.add_flag("--no-sun", options->no_sun, "sky: leave the sun's disc out")->group(kGroup);
  constexpr const char* kCoefficients = "Coefficients";
  verb.add_option("--bands", options->bands, "N bands are N² coefficients")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024))
      ->group(kCoefficients);
  verb.add_flag("--normalise,--normalize", options->normalise,
                "scale so that a white matte surface turned toward the light, nothing between them, reflects the "
                "colour given, 1 if none is, evaluated in these bands. hemisphere, sky: a luminance of 1 on a surface "
                "that faces up")
      ->group(kCoefficients);
  add_text_output(verb, *path);
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal light directional --toward 1,0,2 --irradiance 3,2.5,2 -o key.json\n"
      "  zonal light cone --azimuth 30 --elevation 45 --half-angle 12.5 --normalise --bands 6 -o cone.json\n"
      "  zonal light polygon --vertex -1,-1,2 --vertex 1,-1,2 --vertex 1,1,2 --vertex -1,1,2 -o panel.json\n"
      "  zonal light sky --elevation 20 --turbidity 4 | zonal shader - --lang hlsl");
  verb.callback([options, path, &call] { run_light(*options, *path, call); });
}

}  // namespace zonal
