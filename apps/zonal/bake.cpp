#include "zonal/report/bake.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "apps/zonal/bake_command.h"
#include "apps/zonal/choices.h"
#include "apps/zonal/input_options.h"
#include "apps/zonal/layouts.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"

namespace zonal {
namespace {

constexpr std::array kLobes = {LobeKind::kGgx, LobeKind::kCharlie, LobeKind::kPhong, LobeKind::kBlinnPhong};

std::optional<LobeKind> chain_lobe_named(std::string_view name) {
  const std::optional<LobeKind> kind = lobe_kind_named(name);
  return kind && std::find(kLobes.begin(), kLobes.end(), *kind) != kLobes.end() ? kind : std::nullopt;
}

std::optional<Layout> cube_layout_named(std::string_view name) {
  const std::optional<Layout> layout = layout_or_alias(name);
  return layout && is_cube(*layout) ? layout : std::nullopt;
}

void add_light_options(CLI::App& verb, BakeCommand& command) {
  constexpr const char* kGroup = "Light";
  BakeOptions& bake = command.bake;
  verb.add_option("--size", bake.size_px, "face edge of the cube maps")
      ->capture_default_str()
      ->check(CLI::Range(1, 8192))
      ->group(kGroup);
  verb.add_option("--levels", bake.levels, "levels of the specular chain; as many as reach 16 pixels if not said")
      ->check(CLI::Range(1, 14))
      ->group(kGroup);
  add_choice(verb, "--lobe", bake.lobe, chain_lobe_named,
             names_of(kLobes, [](LobeKind k) { return std::string(name_of(k)); }), "of the specular chain")
      ->group(kGroup);
  add_choice(verb, "--roughness-map", command.roughness_map, roughness_map_named,
             names_of(all_roughness_maps(), [](RoughnessMap m) { return std::string(name_of(m)); }),
             "which roughness each level is for; the engine's or linear if not said")
      ->group(kGroup);
  verb.add_option("--bands", bake.bands, "of the spherical harmonics; N bands are N² coefficients")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024))
      ->group(kGroup);
  verb.add_option("--irradiance-size", bake.irradiance_px, "face edge of the irradiance map")
      ->capture_default_str()
      ->check(CLI::Range(1, 8192))
      ->group(kGroup);
  verb.add_option("--dfg-size", bake.table_px, "side of the split-sum tables")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024))
      ->group(kGroup);
  verb.add_flag("--verify", command.verify,
                "compare every map with the brute-force sum over all texels and print the error")
      ->group(kGroup);
}

void add_file_options(CLI::App& verb, BakeCommand& command) {
  constexpr const char* kGroup = "Output";
  verb.add_option("-o,--output", command.folder, "folder for the results; made if it is not there")
      ->required()
      ->group(kGroup);
  add_choice(verb, "--format", command.files.format, map_format_named, "ktx2, exr, hdr or png",
             "of the maps; pictures have one level each")
      ->group(kGroup);
  verb.add_flag("--float32", command.files.float32, "KTX2: 32 bit floats in place of 16")->group(kGroup);
  add_choice(verb, "--layout", command.files.layout, cube_layout_named,
             "cube-stack, cube-row, cube-cross, cube-cross-vertical or cube-cross-vertical-unrotated",
             "of cubes as pictures")
      ->group(kGroup);
  add_choice(
      verb, "--engine", command.files.engine,
      [](std::string_view name) -> std::optional<const EngineConvention*> {
        const EngineConvention* engine = engine_named(name);
        return engine ? std::optional(engine) : std::nullopt;
      },
      names_of(all_engines(), [](const EngineConvention& e) { return std::string(e.name); }),
      "turn cubes and coefficients into the axes of a program")
      ->group(kGroup);
  verb.add_flag("--no-timings", command.no_timings,
                "leave times out of page and recipe, so that they repeat to the byte")
      ->group(kGroup);
}

}  // namespace

void add_bake(CLI::App& app, Call& call) {
  auto command = std::make_shared<BakeCommand>();
  CLI::App& verb =
      *app.add_subcommand("bake", "Everything a renderer needs from one environment, and a page to look at.");
  add_input_options(verb, command->input);
  add_light_options(verb, *command);
  add_file_options(verb, *command);
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal bake sunset.exr -o out\n"
      "  zonal bake faces/ -o out --size 512 --engine three\n"
      "  zonal bake allsky.jpg -o out --from fisheye --fov 185 --ground 0.1,0.1,0.08\n"
      "  zonal bake sunset.exr -o out --verify --format exr");
  verb.callback([command, &call] { run_bake(*command, call); });
}

}  // namespace zonal
