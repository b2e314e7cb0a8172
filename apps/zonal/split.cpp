#include "zonal/light/split.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "apps/zonal/input_options.h"
#include "apps/zonal/layouts.h"
#include "apps/zonal/output_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/io/lights_json.h"
#include "zonal/io/png.h"
#include "zonal/light/rearrange.h"
#include "zonal/report/marked_panorama.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

struct SplitCommand {
  InputOptions input;
  OutputOptions output;
  SplitOptions split;
  double max_angle_deg = 0;
  std::filesystem::path lights, marked;
};

constexpr int kMarkedRows = 1024;  // of the panorama that is marked, at most

JsonValue rgb(RgbD c) { return JsonValue::Array{c.r, c.g, c.b}; }
JsonValue xyz(Vec3 v) { return JsonValue::Array{v.x, v.y, v.z}; }

/// To a hundredth, and without a minus before zero.
std::string degrees_of(double value) { return fmt::format("{:.2f}", std::round(100 * value) / 100 + 0.0); }

JsonValue sum_json(const SphereSum& sum) {
  return JsonValue::Object{
      {"energy", rgb(sum.energy)},
      {"vector_irradiance", JsonValue::Array{xyz(sum.vector[0]), xyz(sum.vector[1]), xyz(sum.vector[2])}}};
}

void add_fields(const SplitEnvironment& split, Console& console) {
  JsonValue::Array lights;
  for (const SplitLight& light : split.lights) {
    lights.emplace_back(JsonValue::Object{{"direction", xyz(light.direction)},
                                          {"azimuth_deg", azimuth_deg(light.direction)},
                                          {"elevation_deg", elevation_deg(light.direction)},
                                          {"half_angle_deg", degrees(light.half_angle)},
                                          {"half_angle_resolved", light.resolved},
                                          {"solid_angle_sr", disc_solid_angle(light.half_angle)},
                                          {"irradiance", rgb(light.irradiance)},
                                          {"radiance", rgb(disc_radiance(light.irradiance, light.half_angle))},
                                          {"energy", rgb(light.energy)},
                                          {"share", light.share}});
  }
  console.field("lights", std::move(lights));
  console.field("sources", split.sources);
  console.field("threshold_luminance", split.threshold_luminance);
  console.field("changed_texels", split.changed_texels);
  console.field("range_before", split.range_before);
  console.field("range_after", split.range_after);
  const SplitBalance& b = split.balance;
  console.field("balance", JsonValue::Object{{"whole", sum_json(b.whole)},
                                             {"lights", sum_json(b.lights)},
                                             {"rest", sum_json(b.rest)},
                                             {"energy_difference", b.energy_difference()},
                                             {"vector_difference", b.vector_difference()},
                                             {"vector_difference_rgb", b.vector_difference_rgb()}});
}

void answer_lights(const SplitEnvironment& split, Console& console) {
  if (split.lights.empty()) {
    console.answer("no compact source stands out: the rest is the whole");
    return;
  }
  console.answer(" #  direction                  azimuth  elevation  half angle  irradiance, facing it          share");
  bool bounds = false;
  int number = 0;
  for (const SplitLight& light : split.lights) {
    const auto [x, y, z] = light.direction;
    const RgbD e = light.irradiance;
    const std::string half_angle = (light.resolved ? "" : "< ") + fmt::format("{:.3f}", degrees(light.half_angle));
    console.answer(
        fmt::format("{:>2}  {:>7.4f} {:>7.4f} {:>7.4f}  {:>8}  {:>9}  {:>10}  {:<9.4g} {:<9.4g} {:<9.4g}  {}", ++number,
                    x, y, z, degrees_of(azimuth_deg(light.direction)), degrees_of(elevation_deg(light.direction)),
                    half_angle, e.r, e.g, e.b, percent(light.share)));
    bounds = bounds || !light.resolved;
  }
  console.answer("angles in degrees, azimuth from +X toward +Y");
  if (bounds) console.answer("< : no larger than this; the texels are too coarse to tell how small");
}

void answer_balance(const SplitEnvironment& split, Console& console) {
  const SplitBalance& b = split.balance;
  const auto row = [&](const char* name, RgbD energy) {
    console.answer(fmt::format("{:<12} {:>12.6g} {:>12.6g} {:>12.6g}", name, energy.r, energy.g, energy.b));
  };
  console.answer("energy, radiance times solid angle");
  row("whole", b.whole.energy);
  row("lights", b.lights.energy);
  row("rest", b.rest.energy);
  row("sum", b.lights.energy + b.rest.energy);
  console.answer(fmt::format("differs by   {:.1e} of the whole; vector irradiance by {:.1e}, in one channel by {:.1e}",
                             b.energy_difference(), b.vector_difference(), b.vector_difference_rgb()));
  console.answer(fmt::format("range        {:.6g} before, {:.6g} after (greatest luminance over the mean)",
                             split.range_before, split.range_after));
}

void turn(SphereSum& sum, const Rotation& world_from_source) {
  for (Vec3& v : sum.vector) v = world_from_source * v;
}

/// The lights and the sums as they are after the picture is turned.
void turn(SplitEnvironment& split, const Rotation& world_from_source) {
  if (world_from_source == Rotation::identity()) return;
  for (SplitLight& light : split.lights) light.direction = normalize(world_from_source * light.direction);
  for (SphereSum* sum : {&split.balance.whole, &split.balance.lights, &split.balance.rest}) {
    turn(*sum, world_from_source);
  }
}

void write_lights(const SplitEnvironment& split, const std::filesystem::path& path, Console& console) {
  LightsFile file;
  for (const SplitLight& light : split.lights) {
    file.lights.push_back({light.direction, light.irradiance, light.half_angle, light.share});
  }
  const std::string text = lights_json_text(file);
  write_file(path, text);
  console.wrote(path, text.size(), fmt::format("lights: {}", file.lights.size()));
}

void write_marked(const Environment& panorama, const SplitEnvironment& split, const std::filesystem::path& path,
                  Console& console) {
  std::vector<PanoramaMark> marks;
  for (const SplitLight& light : split.lights) {
    marks.push_back({light.direction, light.half_angle, static_cast<int>(marks.size()) + 1});
  }
  const std::vector<std::byte> png = encode_png(marked_panorama(panorama.radiance, marks));
  write_file(path, png);
  console.wrote(path, png.size(), "the whole with the lights marked");
}

/// What is left, in the picture that was asked for.
Environment rest_for(const SplitCommand& options, Environment rest, const Projection& target, ImageSize size,
                     Call& call) {
  const ResampleOptions resampling = resample_options_of(options.input);
  const ImageSize had = {rest.radiance.width(), rest.radiance.height()};
  if (target == rest.projection && size == had && resampling.world_from_source == Rotation::identity()) return rest;
  if (auto moved = rearranged(rest, target, size, resampling.world_from_source)) return std::move(*moved);
  call.console.note("the sums are those of the picture as it was read, before the rest was resampled");
  return resample(rest, target, size, resampling, call.run);
}

void run_split(const SplitCommand& options, Call& call) {
  if (!options.marked.empty() && options.marked.extension() != ".png") {
    throw Error(ErrorKind::kUsage, options.marked.string() + ": the marked panorama is a PNG", "name it .png");
  }
  if (options.output.to) check_output(options.output, *options.output.to);
  Input input = read_input(options.input, call);
  Environment whole = std::move(input.loaded.environment);
  const Projection source = whole.projection;
  const Projection target = options.output.to ? target_of(options.output, source.layout) : source;
  check_output(options.output, target.layout);
  ImageSize size = input.file_size;
  if (options.output.size_px > 0) {
    size = image_size(target.layout, options.output.size_px);
  } else if (!(target == source)) {
    size = image_size(target.layout, size_as_fine(target.layout, source, size));
  }

  Environment panorama;
  if (!options.marked.empty()) {
    const int rows = std::min(kMarkedRows, panorama_rows(source, input.file_size));
    panorama = resample(whole, {Layout::kEquirect}, rows, resample_options_of(options.input), call.run);
  }
  SplitOptions split_options = options.split;
  split_options.max_size_sr = disc_solid_angle(radians(options.max_angle_deg));
  SplitEnvironment split = split_lights(std::move(whole), split_options, call.run);
  turn(split, rotation_of(options.input));
  add_fields(split, call.console);
  answer_lights(split, call.console);
  answer_balance(split, call.console);

  write_map(rest_for(options, std::move(split.rest), target, size, call), options.output, "radiance",
            "the rest, without the lights", call);
  if (!options.lights.empty()) write_lights(split, options.lights, call.console);
  if (!options.marked.empty()) write_marked(panorama, split, options.marked, call.console);
}

}  // namespace

void add_split(CLI::App& app, Call& call) {
  auto options = std::make_shared<SplitCommand>();
  CLI::App& verb = *app.add_subcommand(
      "split", "The sun and other compact lights out of a picture, as lights, and the rest without them.");
  add_input_options(verb, options->input);
  constexpr const char* kGroup = "Lights";
  SplitOptions& split = options->split;
  options->max_angle_deg = std::round(10 * degrees(2 * std::asin(std::sqrt(split.max_size_sr / (4 * kPi))))) / 10;
  verb.add_option("-n,--max-lights", split.max_lights, "at most so many, the strongest")
      ->capture_default_str()
      ->check(CLI::Range(0, 65536))
      ->group(kGroup);
  verb.add_option("--threshold", split.threshold, "a light is brighter than so many times the mean of the rest")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1e12))
      ->group(kGroup);
  verb.add_option("--min-share", split.min_share, "a light has at least this share of the energy, 0 to 1")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1.0))
      ->group(kGroup);
  verb.add_option("--max-angle", options->max_angle_deg,
                  "a light is no larger than a disc of this half angle in degrees; what is larger stays")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 90.0))
      ->group(kGroup);
  add_output_options(verb, options->output, "as fine as the input if not said");
  verb.add_option("--lights", options->lights, "the lights as a file of JSON")->group("Output");
  verb.add_option("--marked", options->marked, "a PNG of the panorama with the lights numbered on it")->group("Output");
  add_run_options(verb, call);
  verb.footer(
      "A light is what its texels have over a smooth fill from around them, so that the lights and the rest add up to "
      "the whole. Shade with the lights and the rest: the fireflies are gone and the sun can cast shadows.\n\n"
      "Examples:\n"
      "  zonal split sunset.hdr -o rest.exr --lights sun.json\n"
      "  zonal split sunset.hdr -o rest.exr -n 1 --marked where.png\n"
      "  zonal split studio.exr -o rest.exr --threshold 8 --max-angle 12 --json");
  verb.callback([options, &call] { run_split(*options, call); });
}

}  // namespace zonal
