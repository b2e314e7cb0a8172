#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/zonal/coefficients.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/sh_shader.h"
#include "apps/zonal/sh_window.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

struct ShOptions {
  CoefficientOptions source;
  std::filesystem::path path;
  std::optional<ShQuantity> quantity;
  WindowOptions window;
  std::optional<ShaderLanguage> shader;
  bool glsl = false;
  const EngineConvention* engine = nullptr;
};

/// The quantity that an engine stores is not a choice.
void check_quantity(const ShOptions& options, const EngineConvention& engine) {
  if (!options.quantity || *options.quantity == engine.sh.quantity) return;
  throw Error(ErrorKind::kUsage,
              fmt::format("{} stores {}, not {}", engine.name, name_of(engine.sh.quantity), name_of(*options.quantity)),
              "leave out --quantity");
}

void write_for_engine(const ShOptions& options, const EngineConvention& engine, const ShFile& sh, Call& call) {
  const int bands = sh.coefficients.bands();
  if (engine.sh.max_bands > 0 && bands > engine.sh.max_bands) {
    throw Error(ErrorKind::kUsage, fmt::format("{} takes {} bands, not {}", engine.name, engine.sh.max_bands, bands),
                fmt::format("--bands {} leaves out the rest", engine.sh.max_bands));
  }
  const std::vector<RgbD> numbers = engine_coefficients(sh, engine);
  std::string text;
  for (const RgbD& c : numbers) text += fmt::format("{} {} {}\n", shortest(c.r), shortest(c.g), shortest(c.b));
  call.console.field("bands", bands);
  call.console.field("engine", engine.name);
  call.console.field("quantity", name_of(engine.sh.quantity));
  call.console.field("coefficients", coefficients_json(numbers));
  write_text(text, options.path, fmt::format("{} bands of {}", bands, name_of(engine.sh.quantity)), call);
}

void write_shader(const ShOptions& options, const ShFile& sh, Call& call) {
  const ShaderLanguage language = options.shader.value_or(ShaderLanguage::kGlsl);
  const std::string text = shader_in_axes_of(options.engine, sh, language, sh.quantity);
  call.console.field("bands", sh.coefficients.bands());
  call.console.field("quantity", name_of(sh.quantity));
  call.console.field("coefficients", coefficients_json(sh.coefficients.values()));
  call.console.field("shader", text);
  write_text(text, options.path, fmt::format("{} bands of {}", sh.coefficients.bands(), name_of(sh.quantity)), call);
}

void run_sh(const ShOptions& options, Call& call) {
  const bool shader = options.glsl || options.shader.has_value();
  const EngineConvention* engine = shader ? nullptr : options.engine;
  if (engine) check_quantity(options, *engine);
  check_window(options.window);
  ShFile sh = read_coefficients(options.source, call).sh;
  sh = to_quantity(sh, engine ? engine->sh.quantity : options.quantity.value_or(sh.quantity));
  sh.coefficients = windowed(sh.coefficients, options.window, call);
  if (shader) {
    write_shader(options, sh, call);
  } else if (engine) {
    write_for_engine(options, *engine, sh, call);
  } else {
    write_coefficients(sh, options.path, call);
  }
}

}  // namespace

void add_sh(CLI::App& app, Call& call) {
  auto options = std::make_shared<ShOptions>();
  CLI::App& verb = *app.add_subcommand(
      "sh",
      "Spherical-harmonic coefficients of a picture, or of other coefficients: turned, windowed, as another quantity, "
      "as JSON, as a shader function or as an engine wants them.");
  add_coefficient_options(verb, options->source);
  constexpr const char* kGroup = "Coefficients";
  add_quantity_choice(verb, "--quantity", options->quantity,
                      "what they are to be coefficients of, the input's own or radiance if not said")
      ->group(kGroup);
  verb.add_flag("--glsl", options->glsl, "a GLSL function in place of JSON, 6 bands at most")->group(kGroup);
  add_language_choice(verb, "--shader", options->shader, "the same in a language")->group(kGroup);
  add_engine_choice(verb, options->engine,
                    "one line r g b for each coefficient, in the axes, order and quantity of a program; shaders in its "
                    "axes",
                    kGroup);
  add_window_options(verb, options->window);
  add_text_output(verb, options->path);
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal sh sunset.hdr\n"
      "  zonal sh sunset.hdr --bands 6 -o sh.json\n"
      "  zonal sh sh.json --rotate 90,20 --window hann -o turned.json\n"
      "  zonal sh sh.json --quantity irradiance/pi --window nonnegative\n"
      "  zonal sh sunset.hdr --to filament -o sh.txt\n"
      "  zonal light sphere --center 0,0,3 --radius 1 | zonal sh - --quantity irradiance --glsl");
  verb.callback([options, &call] { run_sh(*options, call); });
}

}  // namespace zonal
