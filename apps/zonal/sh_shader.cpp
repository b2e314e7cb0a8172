#include "apps/zonal/sh_shader.h"

#include <CLI/CLI.hpp>
#include <array>

#include "apps/zonal/choices.h"

namespace zonal {
namespace {

constexpr std::array kQuantities = {ShQuantity::kRadiance, ShQuantity::kIrradiance, ShQuantity::kIrradianceOverPi};
constexpr std::array kLanguages = {ShaderLanguage::kGlsl, ShaderLanguage::kHlsl, ShaderLanguage::kMsl,
                                   ShaderLanguage::kWgsl, ShaderLanguage::kCpp};

std::optional<const EngineConvention*> engine_or_none(std::string_view name) {
  const EngineConvention* engine = engine_named(name);
  return engine ? std::optional(engine) : std::nullopt;
}

}  // namespace

CLI::Option* add_quantity_choice(CLI::App& verb, const std::string& option, std::optional<ShQuantity>& quantity,
                                 const std::string& help) {
  return add_choice(verb, option, quantity, sh_quantity_named,
                    names_of(kQuantities, [](ShQuantity q) { return std::string(name_of(q)); }), help);
}

CLI::Option* add_language_choice(CLI::App& verb, const std::string& option, std::optional<ShaderLanguage>& language,
                                 const std::string& help) {
  return add_choice(verb, option, language, shader_language_named,
                    names_of(kLanguages, [](ShaderLanguage l) { return std::string(name_of(l)); }), help);
}

void add_engine_choice(CLI::App& verb, const EngineConvention*& engine, const std::string& help,
                       const std::string& group) {
  const std::string names = names_of(all_engines(), [](const EngineConvention& e) { return std::string(e.name); });
  add_choice(verb, "--to", engine, engine_or_none, names, help)->group(group);
  add_choice(verb, "--engine", engine, engine_or_none, names, help)->group("");  // its older name, not shown
}

std::string shader_frame_of(const EngineConvention& engine) { return "the world axes of " + std::string(engine.name); }

std::string shader_in_axes_of(const EngineConvention* engine, ShFile sh, ShaderLanguage language, ShQuantity returns) {
  ShaderOptions shader{.language = language, .returns = returns};
  if (engine) {
    sh.coefficients = transformed(sh.coefficients, engine->engine_from_world);
    shader.frame = shader_frame_of(*engine);
  }
  return shader_text(sh, shader);
}

}  // namespace zonal
