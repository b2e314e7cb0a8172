#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "apps/zonal/choices.h"
#include "apps/zonal/merge_input.h"
#include "apps/zonal/merge_report.h"
#include "apps/zonal/numbers.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/image/align_exposures.h"
#include "zonal/image/dark_floor.h"
#include "zonal/image/response_debevec.h"
#include "zonal/image/response_robertson.h"
#include "zonal/io/picture.h"
#include "zonal/io/response_file.h"

namespace zonal {
namespace {

/// Texels to estimate from: the direct solution needs few good ones, the iterative one many of any kind.
constexpr int kFlatTexels = 2000, kRobertsonTexels = 250'000;

struct MergeVerbOptions {
  BracketOptions input;
  MergeOutputs output;
  std::string response = "estimate";
  MergeRule rule = MergeRule::kLogMean;
  double smoothness = DebevecOptions{}.smoothness;
  std::string trust;
  bool align = false, deghost = false, absolute = false;
};

std::optional<MergeRule> rule_named(std::string_view name) {
  if (name == "debevec") return MergeRule::kLogMean;
  if (name == "robertson") return MergeRule::kLeastSquares;
  return std::nullopt;
}

TrustedRanges trusted_in(const std::string& text) {
  const std::vector<double> codes = numbers_in(text, 2, 2, "--trust");
  if (!(codes[0] >= 0 && codes[0] < codes[1] && codes[1] <= 255)) {
    throw Error(ErrorKind::kUsage, "--trust: " + text + " is no range of codes", "as in 4,250, within 0 and 255");
  }
  const TrustedCodes range{codes[0], codes[1]};
  return {range, range, range};
}

/// The curve that the user gave; nullopt: it is to be estimated.
std::optional<Response> given_response(const std::string& name) {
  if (name == "estimate") return std::nullopt;
  if (name == "srgb") return Response::srgb();
  if (name == "linear") return Response::linear();
  return load_response(name);
}

Response response_for(const MergeVerbOptions& options, const CodeSamples& flat, const TrustedRanges& trusted,
                      const Bracket& bracket, MergeFacts& facts, Call& call) {
  if (bracket.linear) {
    if (options.response == "srgb") {
      throw Error(ErrorKind::kUsage, "--response srgb: these pictures hold linear floats", "leave it out");
    }
    if (options.response == "estimate") {
      call.console.note("the pictures hold floats: they are taken as linear, and as saturated from 1 up");
      facts.response = "linear";
      return Response::linear();
    }
  }
  facts.response = options.response;
  if (const std::optional<Response> given = given_response(options.response)) return *given;
  if (options.rule == MergeRule::kLogMean) {
    facts.fit = estimate_response_debevec(flat, {options.smoothness, trusted});
  } else {
    const CodeSamples samples = sample_all_texels(bracket.exposures, kRobertsonTexels, call.run);
    if (even_steps(samples.seconds)) {
      call.console.warn(
          "the exposures are in even steps, which leave Robertson's estimate free up to a factor that repeats "
          "with them; --method debevec asks for smoothness as well");
    }
    facts.fit = estimate_response_robertson(samples, {.trusted = trusted}, call.run);
  }
  return facts.fit->response;
}

/// The codes to trust: as said, or those that answer to light.
TrustedRanges trusted_for(const MergeVerbOptions& options, const CodeSamples& samples, const Bracket& bracket,
                          Console& console) {
  if (!options.trust.empty()) return trusted_in(options.trust);
  if (bracket.linear) return {};
  const TrustedRanges trusted = find_trusted_codes(samples);
  if (trusted != TrustedRanges{}) {
    console.note(
        fmt::format("codes up to {:.0f}, {:.0f}, {:.0f} (red, green, blue) do not answer to light and are not "
                    "trusted; --trust 0,255 trusts them",
                    trusted[0].lowest, trusted[1].lowest, trusted[2].lowest));
  }
  return trusted;
}

/// From radiance relative to full code at 1 s to luminance, where it is known.
double unit_of(const MergeVerbOptions& options, const Bracket& bracket) {
  if (!options.absolute) return 1;
  const std::optional<double> luminance = full_code_luminance(bracket.reference);
  if (luminance) return *luminance;
  throw Error(ErrorKind::kInput, "--absolute: the aperture and the ISO speed are not known",
              "they come from EXIF or from a list: --times FILE with lines of FILE 1/SECONDS F-NUMBER ISO DENSITY");
}

void run_merge(const MergeVerbOptions& options, Call& call) {
  check_merge_outputs(options.output);
  if (!options.trust.empty()) trusted_in(options.trust);  // before any work is done
  MergeFacts facts;
  Bracket bracket = read_bracket(options.input, call);
  check_merge_view(options.output.view, {bracket.exposures[0].picture.width(), bracket.exposures[0].picture.height()});
  const double unit = unit_of(options, bracket);
  if (options.align) facts.alignments = align_exposures(bracket.exposures, {}, call.run);
  const CodeSamples flat = sample_flat_texels(bracket.exposures, kFlatTexels, call.run);
  facts.trusted = trusted_for(options, flat, bracket, call.console);
  const Response response = response_for(options, flat, facts.trusted, bracket, facts, call);
  MergeOptions merging{options.rule, facts.trusted, {}};
  if (options.deghost) {
    facts.deghosting = deghost(bracket.exposures, response, {.trusted = facts.trusted}, call.run);
    merging.masks = facts.deghosting->masks;
  }
  Merge merge = merge_exposures(bracket.exposures, response, merging, call.run);
  for (Rgb& radiance : merge.radiance.values()) radiance = static_cast<float>(unit) * radiance;
  facts.absolute = options.absolute;
  write_merge(std::move(merge), response, bracket, facts, options.output, call);
}

void add_estimation_options(CLI::App& verb, MergeVerbOptions& options) {
  constexpr const char* kGroup = "Merging";
  verb.add_option("--response", options.response,
                  "the camera's curve: estimate, srgb, linear, or a file of --save-response")
      ->capture_default_str()
      ->group(kGroup);
  add_choice(verb, "--method", options.rule, rule_named, "debevec or robertson",
             "estimator and weights: Debevec & Malik 1997, or Robertson et al. 1999; debevec if not said")
      ->group(kGroup);
  verb.add_option("--smoothness", options.smoothness, "debevec: how smooth the curve is made")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e6))
      ->group(kGroup);
  verb.add_option("--trust", options.trust,
                  "LOW,HIGH: codes to trust, those between; if not said, what answers to light")
      ->group(kGroup);
  verb.add_flag(
          "--align", options.align,
          "move and turn hand-held shots onto each other, to a fraction of a pixel; what each was moved by is said")
      ->group(kGroup);
  verb.add_flag("--deghost", options.deghost, "leave out what moved between the shots")->group(kGroup);
}

}  // namespace

void add_merge(CLI::App& app, Call& call) {
  auto options = std::make_shared<MergeVerbOptions>();
  options->input.max_pixels = LoadOptions{}.max_pixels;
  CLI::App& verb = *app.add_subcommand("merge", "Radiance from photographs of one scene with different exposures.");
  verb.add_option("IN", options->input.paths, "the photographs, in any order (JPEG, PNG, TGA; EXR, HDR, PFM as linear)")
      ->required();
  verb.add_option("--times", options->input.times,
                  "1/1000,1/250,... seconds, -2ev,0ev,2ev steps, or a file with a line for each picture; "
                  "what the files say if not said")
      ->group("Input");
  verb.add_option("--ignore", options->input.ignore, "R,G,B: the colour, as codes of 255, of borders without data")
      ->group("Input");
  verb.add_option("--max-pixels", options->input.max_pixels, "refuse larger pictures")
      ->check(CLI::PositiveNumber)
      ->group("Input");
  add_estimation_options(verb, *options);
  constexpr const char* kOutput = "Output";
  MergeOutputs& output = options->output;
  add_merge_view_options(verb, output.view);
  verb.add_flag("--absolute", options->absolute, "cd/m² by aperture and ISO speed, in place of relative radiance")
      ->group(kOutput);
  verb.add_option("--map", output.map, "MAP.png: which exposure each region came from")->group(kOutput);
  verb.add_option("--curve", output.curve, "CURVE.svg: the camera's response")->group(kOutput);
  verb.add_option("--save-response", output.response, "FILE: the response as text, for --response")->group(kOutput);
  add_run_options(verb, call);
  verb.footer(
      "Radiance 1 fills an exposure of 1 s at the first picture's aperture and ISO speed. Without --from the merge is "
      "a\n"
      "picture like the photographs; with it, it is written in any projection. Places in pixels are those of the\n"
      "exposure in the middle of the bracket, which --align leaves where it is.\n\n"
      "Examples:\n"
      "  zonal merge shot_*.jpg -o scene.exr --align --deghost\n"
      "  zonal merge ball_*.jpg --from mirror-ball --center 764,482 --radius 268 --to equirect -o room.exr\n"
      "  zonal merge a.jpg b.jpg c.jpg --times 1/250,1/1000,1/4000 -o sky.exr --map which.png --curve curve.svg\n"
      "  zonal merge memorial*.png --times memorial.hdr_image_list.txt --ignore 0,0,255 -o memorial.exr");
  verb.callback([options, &call] { run_merge(*options, call); });
}

}  // namespace zonal
