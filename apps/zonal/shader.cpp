#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "apps/zonal/coefficients.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/sh_shader.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/io/output_folder.h"
#include "zonal/io/shader_program.h"

namespace zonal {
namespace {

struct ShaderVerbOptions {
  CoefficientOptions source;
  std::filesystem::path path;
  std::optional<ShaderLanguage> language;
  std::optional<ShQuantity> returns;
  const EngineConvention* engine = nullptr;
  bool program = false;
};

constexpr int kProgramBands = 3;

std::string_view extension_of(ShaderLanguage language) {
  if (language == ShaderLanguage::kMsl) return "metal";
  return language == ShaderLanguage::kCpp ? "h" : name_of(language);
}

/// Four files that share the beginning of their names, or none of them.
void write_program(const ShaderVerbOptions& options, ShFile sh, ShaderLanguage language, Call& call) {
  ShaderProgramOptions program{.language = language};
  if (const int bands = sh.coefficients.bands(); bands > kProgramBands) {
    call.console.note(fmt::format("the program takes the first {} of the {} bands", kProgramBands, bands));
    sh.coefficients = with_bands(sh.coefficients, kProgramBands);
  }
  if (options.engine) {
    sh.coefficients = transformed(sh.coefficients, options.engine->engine_from_world);
    program.frame = shader_frame_of(*options.engine);
  }
  const ShaderProgram texts = shader_program(sh, program);
  const std::pair<const char*, const std::string&> parts[] = {{"vertex", texts.vertex},
                                                              {"fragment", texts.fragment},
                                                              {"uniform_c", texts.uniform_c},
                                                              {"uniform_json", texts.uniform_json}};
  for (const auto& [part, text] : parts) call.console.field(part, text);
  if (options.path.empty()) return;
  const std::string name = options.path.filename().string(), extension(extension_of(language));
  const std::pair<std::string, const std::string&> files[] = {
      {fmt::format("{}.vert.{}", name, extension), texts.vertex},
      {fmt::format("{}.frag.{}", name, extension), texts.fragment},
      {name + ".sh.h", texts.uniform_c},
      {name + ".sh.json", texts.uniform_json}};
  OutputFolder folder(options.path.has_parent_path() ? options.path.parent_path() : ".");
  for (const auto& [file, text] : files) folder.add(file, text);
  folder.commit();
  constexpr const char* kWhat[] = {"vertex shader", "fragment shader", "sh[9] as a C array", "sh[9] as JSON"};
  for (std::size_t i = 0; i < std::size(files); ++i) {
    call.console.wrote(options.path.parent_path() / files[i].first, files[i].second.size(), kWhat[i]);
  }
}

void check_program(const ShaderVerbOptions& options, const Call& call) {
  if (options.returns) {
    throw Error(ErrorKind::kUsage, "a --program shades with irradiance: --returns has no meaning for it",
                "leave out one of them");
  }
  const bool named = options.path.has_filename() && options.path != "-";
  if (!named && !(options.path.empty() && call.console.json)) {
    throw Error(ErrorKind::kUsage, "a --program is four files", "give what their names begin with, as in -o matte");
  }
}

void run_shader(const ShaderVerbOptions& options, Call& call) {
  if (options.program) check_program(options, call);
  const ShFile sh = read_coefficients(options.source, call).sh;
  const ShaderLanguage language = options.language.value_or(ShaderLanguage::kGlsl);
  if (options.program) {
    write_program(options, sh, language, call);
    return;
  }
  const ShQuantity returns = options.returns.value_or(ShQuantity::kIrradiance);
  const std::string text = shader_in_axes_of(options.engine, sh, language, returns);
  call.console.field("language", name_of(language));
  call.console.field("returns", name_of(returns));
  call.console.field("bands", sh.coefficients.bands());
  call.console.field("shader", text);
  write_text(text, options.path, std::string(name_of(language)) + " function of " + std::string(name_of(returns)),
             call);
}

}  // namespace

void add_shader(CLI::App& app, Call& call) {
  auto options = std::make_shared<ShaderVerbOptions>();
  CLI::App& verb = *app.add_subcommand(
      "shader", "Coefficients as a shader function of the unit normal, without textures or tables.");
  add_coefficient_options(verb, options->source);
  constexpr const char* kGroup = "Shader";
  add_language_choice(verb, "--lang", options->language, "glsl if not said")->group(kGroup);
  add_quantity_choice(verb, "--returns", options->returns, "what the function returns, irradiance if not said")
      ->group(kGroup);
  add_engine_choice(verb, options->engine, "take the normal in the world axes of a program", kGroup);
  verb.add_flag("--program", options->program,
                "a vertex and a fragment shader for a matte surface instead, with the nine coefficients of 3 bands as "
                "uniform sh[9]: writes OUT.vert.*, OUT.frag.*, OUT.sh.h and OUT.sh.json")
      ->group(kGroup);
  add_text_output(verb, options->path);
  add_run_options(verb, call);
  verb.footer(
      "Functions have up to 6 bands.\n\nExamples:\n"
      "  zonal shader sh.json -o irradiance.glsl\n"
      "  zonal shader sunset.hdr --lang hlsl --returns irradiance/pi --to unity -o ambient.hlsl\n"
      "  zonal shader sunset.hdr --program -o matte\n"
      "  zonal light sky --bands 5 | zonal shader - --lang wgsl");
  verb.callback([options, &call] { run_shader(*options, call); });
}

}  // namespace zonal
