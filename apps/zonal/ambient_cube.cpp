#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/zonal/coefficients.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/io/ambient_cube_json.h"

namespace zonal {
namespace {

struct AmbientCubeOptions {
  CoefficientOptions source;
  bool convolved = false;
  std::filesystem::path from_cube, path;
};

constexpr int kBandsFromCube = 3;

AmbientCubeFile read_cube(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  try {
    return parse_ambient_cube_json(text);
  } catch (const Error& e) {
    throw Error(e.kind(), path.string() + ": " + e.what(),
                e.hint().empty() ? "zonal ambient-cube -o writes such files, without --json" : e.hint());
  }
}

void write_from_cube(const AmbientCubeOptions& options, Call& call) {
  if (!options.source.input.paths.empty() || options.convolved) {
    throw Error(ErrorKind::kUsage, "--from-cube makes coefficients and takes no other input and no --convolved",
                "leave out one of them");
  }
  const AmbientCubeFile file = read_cube(options.from_cube);
  const int bands = options.source.bands.value_or(kBandsFromCube);
  write_coefficients({file.quantity, sh_from_ambient_cube(file.cube, bands)}, options.path, call);
}

void write_cube(const AmbientCubeOptions& options, Call& call) {
  if (options.source.input.paths.empty()) {
    throw Error(ErrorKind::kUsage, "ambient-cube needs an input", "a file of coefficients, a picture or --from-cube");
  }
  ShFile sh = read_coefficients(options.source, call).sh;
  if (options.convolved) sh = to_quantity(sh, ShQuantity::kIrradianceOverPi);
  const AmbientCubeFile file{sh.quantity, ambient_cube(sh.coefficients)};
  JsonValue::Object sides;
  for (std::size_t i = 0; i < file.cube.sides.size(); ++i) {
    const RgbD c = file.cube.sides[i];
    sides.emplace_back(ambient_cube_side_name(i), JsonValue::Array{c.r, c.g, c.b});
    if (options.path.empty()) {
      call.console.answer(fmt::format("{} {:>12.6g} {:>12.6g} {:>12.6g}", ambient_cube_side_name(i), c.r, c.g, c.b));
    }
  }
  call.console.field("quantity", name_of(file.quantity));
  call.console.field("sides", std::move(sides));
  if (options.path.empty()) return;
  write_text(ambient_cube_json_text(file), options.path, fmt::format("ambient cube of {}", name_of(file.quantity)),
             call);
}

}  // namespace

void add_ambient_cube(CLI::App& app, Call& call) {
  auto options = std::make_shared<AmbientCubeOptions>();
  CLI::App& verb = *app.add_subcommand(
      "ambient-cube", "Six colours, one for each side of the world, nearest to the light; and coefficients from them.");
  options->source.picture_bands = 16;  // the odd ones reach the cube, less and less
  add_coefficient_options(verb, options->source);
  verb.get_option("IN")->required(false);
  constexpr const char* kGroup = "Cube";
  verb.add_flag("--convolved", options->convolved,
                "the cube of irradiance/pi, which a white matte surface reflects, in place of the input's own quantity")
      ->group(kGroup);
  verb.add_option("--from-cube", options->from_cube,
                  "back from a cube file, - for standard input: coefficients, 3 bands if not said")
      ->group(kGroup);
  add_text_output(verb, options->path);
  add_run_options(verb, call);
  verb.footer(
      "Toward d = (x, y, z) the cube is x² times the colour of the x side that d is on, plus y² and z² likewise. "
      "Without -o the colours +X -X +Y -Y +Z -Z are printed as a table; with it, as a file of JSON (-o - for standard "
      "output).\n\n"
      "Examples:\n"
      "  zonal ambient-cube sunset.hdr --convolved\n"
      "  zonal ambient-cube sh.json --convolved -o cube.json\n"
      "  zonal ambient-cube --from-cube cube.json --bands 5 -o sh.json");
  verb.callback([options, &call] {
    if (options->from_cube.empty()) {
      write_cube(*options, call);
    } else {
      write_from_cube(*options, call);
    }
  });
}

}  // namespace zonal
