#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <memory>

#include "apps/zonal/choices.h"
#include "apps/zonal/input_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/io/engine.h"
#include "zonal/io/file.h"
#include "zonal/io/shader.h"
#include "zonal/light/project.h"

namespace zonal {
namespace {

struct ShOptions {
  InputOptions input;
  std::filesystem::path path;  // empty: standard output
  int bands = 3;
  ShQuantity quantity = ShQuantity::kRadiance;
  std::optional<ShaderLanguage> shader;
  bool glsl = false;
  const EngineConvention* engine = nullptr;
};

constexpr std::array kQuantities = {ShQuantity::kRadiance, ShQuantity::kIrradiance, ShQuantity::kIrradianceOverPi};
constexpr std::array kLanguages = {ShaderLanguage::kGlsl, ShaderLanguage::kHlsl, ShaderLanguage::kMsl,
                                   ShaderLanguage::kWgsl, ShaderLanguage::kCpp};

/// The coefficients of an input; of the part that it shows, scaled up to the whole sphere, when the rest is to be left
/// out.
Sh<RgbD> coefficients_of(const ShOptions& options, Call& call) {
  Input input = read_input(options.input, call);
  const WholeLight light = whole_light(input, options.input, call);
  Sh<RgbD> sh = project(light.environment, options.bands, call.run);
  if (light.shown) {
    const double shown_share = project(*light.shown, 1, call.run)(0, 0).r / std::sqrt(4 * kPi);
    if (shown_share > 0) sh *= 1 / shown_share;
  }
  return sh;
}

JsonValue coefficients_json(std::span<const RgbD> coefficients) {
  JsonValue::Array list;
  for (const RgbD& c : coefficients) list.push_back(JsonValue::Array{c.r, c.g, c.b});
  return list;
}

std::string engine_text(const ShFile& sh, const EngineConvention& engine) {
  std::string text;
  for (const RgbD& c : engine_coefficients(sh, engine))
    text += fmt::format("{} {} {}\n", shortest(c.r), shortest(c.g), shortest(c.b));
  return text;
}

std::string shader_of(const ShOptions& options, ShFile sh) {
  ShaderOptions shader{.language = options.shader.value_or(ShaderLanguage::kGlsl), .returns = options.quantity};
  if (options.engine) {
    sh.coefficients = transformed(sh.coefficients, options.engine->engine_from_world);
    shader.frame = "the world axes of " + std::string(options.engine->name);
  }
  return shader_text(sh, shader);
}

void run_sh(const ShOptions& options, Call& call) {
  const bool shader = options.glsl || options.shader.has_value();
  const ShFile radiance{ShQuantity::kRadiance, coefficients_of(options, call)};
  const ShFile wanted = to_quantity(radiance, options.quantity);
  Console& console = call.console;
  std::string text = shader           ? shader_of(options, radiance)
                     : options.engine ? engine_text(radiance, *options.engine)
                                      : sh_json_text(wanted);
  if (!options.path.empty()) {
    write_file(options.path, text);
    console.wrote(options.path, text.size(), fmt::format("{} bands of {}", options.bands, name_of(options.quantity)));
  }
  console.field("bands", options.bands);
  if (options.engine && !shader) {
    console.field("engine", options.engine->name);
    console.field("quantity", name_of(options.engine->sh.quantity));
    console.field("coefficients", coefficients_json(engine_coefficients(radiance, *options.engine)));
  } else {
    console.field("quantity", name_of(options.quantity));
    console.field("coefficients", coefficients_json(wanted.coefficients.values()));
  }
  if (shader) console.field("shader", text);
  if (options.path.empty()) {
    text.pop_back();  // the line's own end
    console.answer(text);
  }
}

}  // namespace

void add_sh(CLI::App& app, Call& call) {
  auto options = std::make_shared<ShOptions>();
  CLI::App& verb = *app.add_subcommand(
      "sh", "Spherical-harmonic coefficients, as JSON, as a shader function or as an engine wants them.");
  add_input_options(verb, options->input);
  constexpr const char* kGroup = "Coefficients";
  verb.add_option("--bands", options->bands, "N bands are N² coefficients")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024))
      ->group(kGroup);
  add_choice(verb, "--quantity", options->quantity, sh_quantity_named,
             names_of(kQuantities, [](ShQuantity q) { return std::string(name_of(q)); }),
             "what they are coefficients of")
      ->group(kGroup);
  verb.add_flag("--glsl", options->glsl, "a GLSL function in place of JSON, 6 bands at most")->group(kGroup);
  add_choice(verb, "--shader", options->shader, shader_language_named,
             names_of(kLanguages, [](ShaderLanguage l) { return std::string(name_of(l)); }), "the same in a language")
      ->group(kGroup);
  add_choice(
      verb, "--engine", options->engine,
      [](std::string_view name) -> std::optional<const EngineConvention*> {
        const EngineConvention* engine = engine_named(name);
        return engine ? std::optional(engine) : std::nullopt;
      },
      names_of(all_engines(), [](const EngineConvention& e) { return std::string(e.name); }),
      "one line r g b for each coefficient, in the axes, order and quantity of a program; shaders in its axes")
      ->group(kGroup);
  verb.add_option("-o,--output", options->path, "file to write; standard output if not said")->group("Output");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal sh sunset.hdr\n"
      "  zonal sh sunset.hdr --quantity irradiance --glsl -o irradiance.glsl\n"
      "  zonal sh sunset.hdr --engine filament -o sh.txt\n"
      "  zonal sh sunset.hdr --bands 6 -o sh.json");
  verb.callback([options, &call] { run_sh(*options, call); });
}

}  // namespace zonal
