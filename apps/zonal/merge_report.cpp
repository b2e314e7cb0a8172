#include "apps/zonal/merge_report.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "zonal/io/file.h"
#include "zonal/io/png.h"
#include "zonal/io/response_file.h"
#include "zonal/report/exposure_map.h"
#include "zonal/report/response_figure.h"
#include "zonal/report/text.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

constexpr std::array<const char*, 3> kChannels = {"red", "green", "blue"};

/// For each exposure, the share of the texels that come from it most.
std::vector<double> shares_of(const Merge& merge, std::size_t exposures) {
  std::vector<double> shares(exposures);
  for (const std::uint8_t source : merge.source.values()) {
    if (source < exposures) shares[source] += 1 / static_cast<double>(merge.source.size());
  }
  return shares;
}

/// Tells, and returns as words, how a photograph was moved: the other way round than it lies under the merge.
std::string say_alignment(const Alignment& alignment, const std::string& name, JsonValue::Object& object,
                          Console& console) {
  const Placement moved = inverse(alignment.placement);
  const auto zero = [](double value) { return value + 0.0; };  // no -0
  object.insert(object.end(), {{"moved_px", JsonValue::Array{zero(moved.dx), zero(moved.dy)}},
                               {"turned_deg", zero(moved.rotation_deg)},
                               {"residual_codes", alignment.residual_codes},
                               {"correlation", alignment.correlation},
                               {"aligned", alignment.aligned}});
  if (!alignment.aligned) {
    console.warn(
        name +
        ": could not be aligned (too dark, too bright, or it shows too little of what the others do); it stays "
        "with its neighbour");
  }
  return fmt::format("  moved by ({:.2f}, {:.2f}) px, turned by {:.2f}°, residual {:.1f} codes", zero(moved.dx),
                     zero(moved.dy), zero(moved.rotation_deg), alignment.residual_codes);
}

void say_exposures(const Merge& merge, const Bracket& bracket, const MergeFacts& facts, Console& console) {
  const std::vector<double> shares = shares_of(merge, bracket.exposures.size());
  JsonValue::Array list;
  for (std::size_t k = 0; k < bracket.exposures.size(); ++k) {
    const Exposure& e = bracket.exposures[k];
    JsonValue::Object object = {{"path", e.name}, {"seconds", e.seconds}, {"share", shares[k]}};
    std::string line = fmt::format("{:>10}  {:>7}  {}", exposure_words(e.seconds), percent(shares[k]), e.name);
    if (!facts.alignments.empty()) {
      line += say_alignment(facts.alignments[k], e.name, object, console);
    }
    if (facts.deghosting) {
      object.emplace_back("left_out", facts.deghosting->left_out[k]);
      line += static_cast<int>(k) == facts.deghosting->reference
                  ? std::string("  shows the moment")
                  : fmt::format("  {} left out", percent(facts.deghosting->left_out[k]));
    }
    list.emplace_back(std::move(object));
    console.answer(line);
  }
  console.field("exposures", std::move(list));
}

void say_response(const MergeFacts& facts, Console& console) {
  JsonValue::Array lowest, highest;
  for (const TrustedCodes& range : facts.trusted) {
    lowest.emplace_back(range.lowest);
    highest.emplace_back(range.highest);
  }
  JsonValue::Object object = {
      {"from", facts.response}, {"trusted_above", std::move(lowest)}, {"trusted_below", std::move(highest)}};
  if (facts.fit) {
    const ResponseFit& fit = *facts.fit;
    JsonValue::Array seen, levelled, rms;
    std::string residuals;
    for (int c = 0; c < 3; ++c) {
      seen.emplace_back(fit.codes_seen[c]);
      levelled.emplace_back(fit.codes_flattened[c]);
      rms.emplace_back(fit.rms_log2[c]);
      residuals += fmt::format("{}{}", c == 0 ? "" : ", ", number(fit.rms_log2[c]));
      if (fit.codes_flattened[c] > 0) {
        console.note(fmt::format("the estimated curve fell at {} of 256 codes in {} and was levelled there",
                                 fit.codes_flattened[c], kChannels[c]));
      }
    }
    object.insert(object.end(), {{"texels", fit.pixels},
                                 {"codes_seen", std::move(seen)},
                                 {"codes_levelled", std::move(levelled)},
                                 {"rms_stops", std::move(rms)},
                                 {"iterations", fit.iterations},
                                 {"converged", fit.converged}});
    console.answer(
        fmt::format("response estimated from {} texels, residual {} stops (red, green, blue)", fit.pixels, residuals));
    if (!fit.converged) console.warn(fmt::format("the response still moved after {} iterations", fit.iterations));
  } else {
    console.answer("response " + facts.response);
  }
  console.field("response", std::move(object));
}

void say_doubts(const Merge& merge, Console& console) {
  console.field("saturated", merge.saturated);
  console.field("black", merge.black);
  console.field("conflicting", merge.conflicting);
  console.field("no_data", merge.no_data);
  const auto warn = [&](std::int64_t count, const char* what) {
    if (count == 0) return;
    console.warn(fmt::format("{} texels ({}) {}", count,
                             percent(static_cast<double>(count) / static_cast<double>(merge.source.size())), what));
  };
  warn(merge.saturated, "are saturated in every exposure in some channel: their radiance is a lower bound");
  warn(merge.black, "are black in every exposure in some channel: their radiance is an upper bound");
  warn(merge.conflicting, "are saturated in some exposures and black in all others: their radiance is a lower bound");
  warn(merge.no_data, "have no data: they are black");
}

void say_unit(const Bracket& bracket, const MergeFacts& facts, Console& console) {
  const ExposureSettings& as = bracket.reference;
  std::string at;
  if (as.f_number) at += fmt::format(" at f/{:.3g}", *as.f_number);
  if (as.iso) at += fmt::format("{} ISO {:.0f}", as.f_number ? "," : " at", *as.iso);
  const std::string unit = facts.absolute ? "cd/m²" : "1 fills an exposure of 1 s" + at;
  console.field("unit", unit);
  const std::optional<double> luminance = full_code_luminance(as);
  console.field("cd_per_m2_of_1", luminance ? JsonValue(facts.absolute ? 1.0 : *luminance) : JsonValue());
  console.answer("unit of radiance: " + unit);
}

bool has_extension(const fs::path& path, const char* extension) {
  return path.empty() || path.extension() == extension;
}

}  // namespace

void check_merge_outputs(const MergeOutputs& outputs) {
  check_merge_view(outputs.view);
  if (!has_extension(outputs.map, ".png")) {
    throw Error(ErrorKind::kUsage, "--map " + outputs.map.string() + ": the map is a PNG", "name it .png");
  }
  if (!has_extension(outputs.curve, ".svg")) {
    throw Error(ErrorKind::kUsage, "--curve " + outputs.curve.string() + ": the curve is an SVG", "name it .svg");
  }
}

void write_merge(Merge merge, const Response& response, const Bracket& bracket, const MergeFacts& facts,
                 const MergeOutputs& outputs, Call& call) {
  Console& console = call.console;
  if (call.run.stop.stop_requested()) throw Error(ErrorKind::kCancelled, "cancelled");
  const auto wrote = [&](const fs::path& path, const std::string& what) {
    console.wrote(path, fs::file_size(path), what);
  };
  say_exposures(merge, bracket, facts, console);
  say_response(facts, console);
  say_unit(bracket, facts, console);
  say_doubts(merge, console);

  if (!outputs.map.empty()) {
    std::vector<std::string> names;
    for (const Exposure& e : bracket.exposures) names.push_back(exposure_words(e.seconds));
    write_file(outputs.map, encode_png(exposure_map(merge, names)));
    wrote(outputs.map, "which exposure each region came from");
  }
  if (!outputs.curve.empty()) {
    write_file(outputs.curve, response_figure(response));
    wrote(outputs.curve, "the camera's response");
  }
  if (!outputs.response.empty()) {
    write_file(outputs.response, response_text(response));
    wrote(outputs.response, "the response as text");
  }
  write_merge_view(std::move(merge.radiance), outputs.view, call);
}

}  // namespace zonal
