#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/zonal/choices.h"
#include "apps/zonal/filtered_map.h"
#include "apps/zonal/input_options.h"
#include "apps/zonal/layouts.h"
#include "apps/zonal/output_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/io/sh_json.h"

namespace zonal {
namespace {

struct IrradianceOptions {
  InputOptions input;
  OutputOptions output;
  std::optional<double> shininess;
  std::optional<ShQuantity> quantity;
};

constexpr int kPanoramaHeight = 128, kFaceEdge = 64;

std::optional<ShQuantity> map_quantity_named(std::string_view name) {
  const std::optional<ShQuantity> quantity = sh_quantity_named(name);
  return quantity == ShQuantity::kRadiance ? std::nullopt : quantity;
}

void run_irradiance(const IrradianceOptions& options, Call& call) {
  if (options.shininess && options.quantity) {
    throw Error(ErrorKind::kUsage, "--shininess makes a map of blurred radiance: --quantity has no meaning for it",
                "leave out one of them");
  }
  const Projection to = target_of(options.output, Layout::kEquirect);
  check_output(options.output, to.layout);
  const ImageSize size = target_size(options.output, to, is_cube(to.layout) ? kFaceEdge : kPanoramaHeight);
  const Lobe lobe = options.shininess ? Lobe::phong(*options.shininess) : Lobe::cosine();
  Convolved result = filtered_map(options.input, lobe, to, size, call);

  std::string quantity = "radiance", what = "reflection map";
  if (!options.shininess) {
    const ShQuantity wanted = options.quantity.value_or(ShQuantity::kIrradiance);
    quantity = name_of(wanted), what = "irradiance map";
    if (wanted == ShQuantity::kIrradiance) {
      for (Rgb& texel : result.map.radiance.values()) texel = static_cast<float>(kPi) * texel;
    }
  }
  call.console.field("quantity", quantity);
  write_map(result.map, options.output, quantity,
            fmt::format("{} ({}), error bound {:.2g} of the mean", what, quantity, result.report.bound_to_mean), call);
}

}  // namespace

void add_irradiance(CLI::App& app, Call& call) {
  auto options = std::make_shared<IrradianceOptions>();
  CLI::App& verb = *app.add_subcommand(
      "irradiance", "The irradiance map, or with --shininess a blurred reflection map, of any projection.");
  add_input_options(verb, options->input);
  verb.add_option("--shininess", options->shininess,
                  "mean radiance under a Phong lobe max(cos, 0)^N in place of irradiance")
      ->check(CLI::Range(0.0, 1e9))
      ->group("Light");
  add_choice(verb, "--quantity", options->quantity, map_quantity_named, "irradiance or irradiance/pi",
             "E, or E/pi: what a white matt surface reflects")
      ->group("Light");
  add_output_options(verb, options->output, "128 for panoramas, 64 for cube faces if not said");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal irradiance sunset.hdr -o irradiance.exr\n"
      "  zonal irradiance sunset.hdr -o irradiance.ktx2 --to cube --size 32\n"
      "  zonal irradiance skymap.tga --from fisheye --ground 0.2,0.2,0.2 --shininess 40 -o gloss.png");
  verb.callback([options, &call] { run_irradiance(*options, call); });
}

}  // namespace zonal
