#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "apps/zonal/choices.h"
#include "apps/zonal/fisheye_maps.h"
#include "apps/zonal/input_options.h"
#include "apps/zonal/numbers.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/image/color.h"
#include "zonal/io/environment_file.h"
#include "zonal/light/fisheye_pixels.h"
#include "zonal/report/fisheye_page.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

enum class FisheyeMode { kPublished, kFirst, kCorrected };

constexpr std::array kModes = {FisheyeMode::kPublished, FisheyeMode::kFirst, FisheyeMode::kCorrected};
constexpr std::array kOutsides = {FisheyeOutside::kGround, FisheyeOutside::kExtended, FisheyeOutside::kTwo};

std::string name_of(FisheyeMode mode) {
  return mode == FisheyeMode::kPublished ? "published" : mode == FisheyeMode::kFirst ? "first" : "corrected";
}

/// The one of `values` with this name.
template <class Values>
auto named(const Values& values, std::string_view name) {
  const auto found = std::find_if(values.begin(), values.end(), [&](auto value) { return name_of(value) == name; });
  return found == values.end() ? std::nullopt : std::optional(*found);
}

struct FisheyeCommand {
  InputOptions input;
  FisheyeMode mode = FisheyeMode::kCorrected;
  std::optional<FisheyeOutside> outside;
  double shininess = 60;
  int size_px = 128;
  Encoding said = Encoding::kAuto;  ///< by the user: the input's encoding also follows from the mode
  std::filesystem::path folder;
};

bool published_lens(const Lens& lens) { return lens.model == LensModel::kEquidistant && lens.fov_deg == 180; }

/// Integers as they are in the file, of 8 or 16 bits.
bool holds_integers(const LoadedEnvironment& loaded) {
  return loaded.format == "PNG" || loaded.format == "JPEG" || loaded.format == "TGA";
}

/// What a command that repeats this one for another circle must say.
std::string kept_options(const FisheyeCommand& command) {
  std::string words = "--mode " + name_of(command.mode) + fmt::format(" --size {}", command.size_px);
  if (command.said == Encoding::kSrgb) words += " --encoding srgb";
  if (command.said == Encoding::kLinear) words += " --encoding linear";
  return words;
}

/// By how much a photograph is made smaller for comparisons, so that its circle is at most 512 pixels wide.
int comparison_factor(const Environment& photograph) {
  const PixelCircle circle = fisheye_circle(photograph);
  return static_cast<int>(std::ceil(2 * std::max(circle.radius_x, circle.radius_y) / 512));
}

std::string name_of_map(double shininess) { return shininess == 1 ? "irradiance" : "reflection"; }

/// What is lost where codes are averaged, for each shininess; nothing for pictures without codes.
std::vector<FisheyeError> averaging_codes(const LoadedEnvironment& loaded, Rgb ground,
                                          const std::vector<double>& shininess, const Run& run) {
  if (!holds_integers(loaded)) return {};
  Environment codes = loaded.environment;
  if (loaded.srgb_decoded) {
    for (Rgb& texel : codes.radiance.values()) texel = srgb_encode(texel);
    ground = srgb_encode(ground);
  }
  std::vector<FisheyeError> errors;
  for (const double s : shininess) errors.push_back(error_of_averaging_codes(codes, ground, s, run));
  return errors;
}

JsonValue json_of(const FisheyeError& error) { return JsonValue::Object{{"rms", error.rms}, {"largest", error.most}}; }

void say_errors(const FisheyePage& page, Console& console) {
  JsonValue::Array list;
  const auto line = [&](const char* what, const FisheyeError& e) {
    console.answer(fmt::format("  {:<28} {:>8} RMS {:>8} at most", what, percent(e.rms), percent(e.most)));
  };
  for (std::size_t i = 0; i < page.studies.size(); ++i) {
    const FisheyeStudy& study = page.studies[i];
    console.answer(fmt::format("{} map (shininess {:g}), published against exact:", name_of_map(study.shininess),
                               study.shininess));
    line("all errors of weights, ground", study.total);
    line("weights alone", study.weights_alone);
    line("ground alone", study.ground_alone);
    JsonValue::Object object = {{"shininess", study.shininess},
                                {"published", json_of(study.total)},
                                {"weights_alone", json_of(study.weights_alone)},
                                {"ground_alone", json_of(study.ground_alone)},
                                {"library", json_of(study.library)}};
    if (!page.averaging_codes.empty()) {
      line("codes averaged for light", page.averaging_codes[i]);
      object.emplace_back("codes_averaged", json_of(page.averaging_codes[i]));
    }
    list.emplace_back(std::move(object));
  }
  console.field("maps", std::move(list));
}

/// The maps that were asked for, and the page where there is something to compare.
std::vector<FisheyeFile> add_files(const FisheyeCommand& command, const LoadedEnvironment& loaded,
                                   const PublishedOptions& options, OutputFolder& folder, Call& call) {
  const Environment& photograph = loaded.environment;
  std::vector<double> shininess = {1};
  if (command.shininess != 1) shininess.push_back(command.shininess);
  std::vector<FisheyeFile> files;
  const auto add = [&](const FisheyeForms& forms, double s, const char* form) {
    const auto added = add_fisheye_maps(forms, name_of_map(s), form, options.grey_levels, folder);
    files.insert(files.end(), added.begin(), added.end());
  };
  if (command.mode == FisheyeMode::kFirst) {
    for (const double s : shininess) {
      PublishedOptions one = options;
      one.shininess = s;
      add(first_published_forms(photograph, one, call.run), s, "disc");
    }
    return files;
  }
  const bool corrected = command.mode == FisheyeMode::kCorrected;
  const auto add_corrected = [&] {
    const FisheyeLight light(photograph, options.ground, shininess, options.outside, call.run);
    for (std::size_t i = 0; i < shininess.size(); ++i) {
      add(corrected_forms(light, static_cast<int>(i), options.size_px, call.run), shininess[i], "paraboloid");
    }
  };
  if (corrected && !published_lens(photograph.projection.lens)) {
    call.console.note("no page: the published program takes equidistant lenses of 180 degrees only");
    add_corrected();
    return files;
  }
  // The exact map is that of all pixels; to compare the two programs, the published sums take a smaller copy.
  LoadedEnvironment compared = loaded;
  const int factor = corrected ? comparison_factor(photograph) : 1;
  if (factor > 1) {
    compared.environment = smaller_photograph(photograph, factor);
    call.console.note(
        fmt::format("the page compares maps of a photograph made {} times smaller: the published sums are "
                    "slow; --mode published takes all pixels",
                    factor));
  }
  FisheyePage page{environment_name(command.input.paths),
                   &photograph,
                   options.grey_levels,
                   options.ground,
                   options.outside,
                   kept_options(command),
                   fisheye_study(compared.environment, shininess, options, call.run),
                   averaging_codes(compared, options.ground, shininess, call.run),
                   kProgram};
  if (corrected) {
    add_corrected();
  } else {
    for (const FisheyeStudy& study : page.studies) add(study.published, study.shininess, "paraboloid");
  }
  folder.add("index.html", fisheye_page_html(page));
  files.push_back({"index.html", "a page with both maps, their differences and a circle to drag"});
  say_errors(page, call.console);
  return files;
}

void run_fisheye(FisheyeCommand command, Call& call) {
  OutputFolder folder(command.folder);  // before the work, so that a folder that cannot be is noticed at once
  const bool corrected = command.mode == FisheyeMode::kCorrected;
  command.input.from = Layout::kFisheye;
  command.said = command.input.encoding;
  const bool as_stored = !corrected && command.input.encoding == Encoding::kAuto;
  if (as_stored) command.input.encoding = Encoding::kLinear;
  if (command.input.paths.size() != 1) {
    throw Error(ErrorKind::kUsage, "one photograph is wanted", "convert two circles first: zonal convert");
  }
  Input input = read_input(command.input, call);
  const LoadedEnvironment& loaded = input.loaded;
  PublishedOptions options;
  options.ground = color_in(command.input.ground, "--ground");
  options.size_px = command.size_px;
  options.outside = command.outside.value_or(corrected ? FisheyeOutside::kExtended : FisheyeOutside::kGround);
  options.grey_levels = !corrected && holds_integers(loaded) && !loaded.srgb_decoded;
  if (options.grey_levels && as_stored) {
    call.console.note(
        "the codes of the picture are averaged as they are, as published; --encoding srgb makes light of them");
  }
  if (!corrected && !options.grey_levels) call.console.note("results are not cut to 8 bits: the values are light");

  call.console.field("mode", name_of(command.mode));
  call.console.field("outside", std::string(name_of(options.outside)));
  call.console.field("codes", options.grey_levels);
  const std::vector<FisheyeFile> files = add_files(command, loaded, options, folder, call);
  if (call.run.stop.stop_requested()) throw Error(ErrorKind::kCancelled, "cancelled");
  folder.commit();
  for (const FisheyeFile& file : files) {
    const std::filesystem::path path = command.folder / file.name;
    call.console.wrote(path, std::filesystem::file_size(path), file.what);
  }
}

}  // namespace

void add_fisheye(CLI::App& app, Call& call) {
  auto command = std::make_shared<FisheyeCommand>();
  command->input.ground = "0.2";
  CLI::App& verb = *app.add_subcommand(
      "fisheye",
      "Irradiance and reflection maps of a fisheye photograph of the sky: as published in 2015, and corrected.");
  add_input_options(verb, command->input);
  for (const char* option : {"--from", "--rotate", "--uncovered"}) verb.remove_option(verb.get_option(option));
  verb.get_option("--ground")->description("the ground's colour R,G,B, in the unit of the values; 0.2 if not said");
  const auto name = [](auto value) { return std::string(name_of(value)); };
  constexpr const char* kGroup = "Maps";
  add_choice(
      verb, "--mode", command->mode, [](std::string_view word) { return named(kModes, word); }, names_of(kModes, name),
      "the program of the article, its first version (equidistant maps), or the exact integral; corrected if not said")
      ->group(kGroup);
  add_choice(
      verb, "--outside", command->outside, [](std::string_view word) { return named(kOutsides, word); },
      names_of(kOutsides, name),
      "of a paraboloid's circle: the ground (as published), means that go on, or a second paraboloid")
      ->group(kGroup);
  verb.add_option("--shininess", command->shininess, "of the reflection map; 1 leaves the irradiance map alone")
      ->check(CLI::Range(0.0, 1e4))
      ->capture_default_str()
      ->group(kGroup);
  verb.add_option("--size", command->size_px, "edge of a paraboloid and rows of a panorama; cube faces have half of it")
      ->check(CLI::Range(8, 1024))
      ->capture_default_str()
      ->group("Output");
  verb.add_option("-o,--output", command->folder, "folder for the maps and their page; made if it is not there")
      ->required()
      ->group("Output");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal fisheye sky.jpg --center 1024,760 --radius 700 -o maps\n"
      "  zonal fisheye sky.tga --mode published --ground 0.2 --shininess 60 -o published\n"
      "  zonal fisheye sky.tga --mode first --center 128,128 --radius 127.5 --shininess 100 --size 256 -o first");
  verb.callback([command, &call] { run_fisheye(*command, call); });
}

}  // namespace zonal
