#include "apps/zonal/input_options.h"

#include <CLI/CLI.hpp>
#include <array>

#include "apps/zonal/choices.h"
#include "apps/zonal/layouts.h"

namespace zonal {
namespace {

std::optional<Encoding> encoding_named(std::string_view name) {
  if (name == "auto") return Encoding::kAuto;
  if (name == "linear") return Encoding::kLinear;
  if (name == "srgb") return Encoding::kSrgb;
  return std::nullopt;
}

std::optional<Uncovered> uncovered_named(std::string_view name) {
  if (name == "rim") return Uncovered::kRimMean;
  if (name == "ground") return Uncovered::kConstant;
  if (name == "nearest") return Uncovered::kNearest;
  if (name == "leave-out") return Uncovered::kBlack;
  return std::nullopt;
}

constexpr const char* kGroup = "Input";

}  // namespace

void add_input_options(CLI::App& verb, InputOptions& options) {
  verb.add_option("IN", options.paths,
                  "a picture (EXR, HDR, PFM, PNG, JPEG, TGA), a folder with six cube faces, six pictures +X -X +Y -Y "
                  "+Z -Z, or two "
                  "(front, back)")
      ->required();
  add_projection_options(verb, options);
  add_choice(verb, "--encoding", options.encoding, encoding_named, "auto, linear or srgb",
             "what 8 and 16 bit numbers mean")
      ->group(kGroup);
  verb.add_option("--max-pixels", options.max_pixels, "refuse larger pictures, before memory is taken")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->group(kGroup);
  verb.add_flag("--fix", options.fix,
                "replace NaN and Inf by their neighbours' mean, raise negative values to 0, and say how many")
      ->group(kGroup);
  add_filling_options(verb, options);
}

void add_projection_options(CLI::App& verb, InputOptions& options) {
  add_choice(verb, "--from", options.from, layout_or_alias, layout_names(),
             "how the picture shows the sphere, if not guessed")
      ->group(kGroup);
  constexpr std::array kModels = {LensModel::kEquidistant, LensModel::kEquisolid, LensModel::kStereographic,
                                  LensModel::kOrthographic};
  add_choice(verb, "--lens", options.lens, lens_model_named,
             names_of(kModels, [](LensModel m) { return std::string(name_of(m)); }),
             "fisheye: how its angle maps to the radius")
      ->group(kGroup);
  verb.add_option("--fov", options.fov_deg, "fisheye: the whole angle it sees, in degrees; 180 if not said")
      ->group(kGroup);
  verb.add_option("--center", options.center,
                  "fisheye, ball or angular map: centre of its circle in pixels, X,Y; the picture's if not said")
      ->group(kGroup);
  verb.add_option("--radius", options.radius,
                  "radius of that circle in pixels, R or RX,RY; the largest that fits if not said")
      ->group(kGroup);
}

void add_filling_options(CLI::App& verb, InputOptions& options) {
  verb.add_option("--rotate", options.rotate,
                  "turn the light: YAW[,PITCH[,ROLL]] in degrees; yaw to the left, pitch up")
      ->group(kGroup);
  add_choice(
      verb, "--uncovered", options.uncovered, uncovered_named, "rim, ground, nearest or leave-out",
      "where the picture shows nothing: mean of its rim, the --ground, nearest texel, or leave out and renormalise")
      ->group(kGroup);
  verb.add_option("--ground", options.ground, "radiance R,G,B where the picture shows nothing")->group(kGroup);
}

}  // namespace zonal
