#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "apps/zonal/coefficients.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/io/lights_json.h"
#include "zonal/io/png.h"
#include "zonal/light/extract.h"
#include "zonal/light/render.h"
#include "zonal/light/resample.h"
#include "zonal/report/marked_panorama.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

struct LightsOptions {
  CoefficientOptions source;
  ExtractOptions extract{.lights = 3};
  bool radiance = false, allow_negative = false;
  std::filesystem::path path, marked;
};

constexpr const char* kNoPicture = "none";
constexpr int kMarkedRows = 512;  // of the panorama that is marked, at most twice as many

/// Looking for maxima takes longer with the fourth power of the bands: ten seconds here.
constexpr int kMaxBands = 64;

/// Over the whole sphere, in the unit of irradiance.
double energy(RgbD radiance, double solid_angle) { return solid_angle * luminance(radiance); }

double energy(const ExtractedLight& light) {
  if (light.half_angle == 0) return luminance(light.irradiance);
  return energy(disc_radiance(light.irradiance, light.half_angle), disc_solid_angle(light.half_angle));
}

/// Nothing of nothing is no share.
std::optional<double> share_of(double part, double whole) {
  return whole > 0 ? std::optional(part / whole) : std::nullopt;
}

std::string in_words(std::optional<double> share) { return share ? percent(*share) : "-"; }

JsonValue rgb(RgbD c) { return JsonValue::Array{c.r, c.g, c.b}; }
JsonValue xyz(Vec3 v) { return JsonValue::Array{v.x, v.y, v.z}; }
JsonValue number_or_null(std::optional<double> value) { return value ? JsonValue(*value) : JsonValue(); }

std::string degrees_of(double value) { return fmt::format("{:.1f}°", std::round(10 * value) / 10 + 0.0); }

/// As bright as its greatest channel: what is left is the hue.
RgbD color_of(RgbD irradiance) {
  const double most = max_channel(irradiance);
  return most > 0 ? (1 / most) * irradiance : RgbD{};
}

void answer_table(const ExtractedLights& found, const LightsFile& file, std::optional<double> ambient_share,
                  const char* metric, Console& console) {
  if (!file.lights.empty()) {
    console.answer(
        " #  direction                  azimuth  elevation  half angle  colour               irradiance  share");
  }
  int number = 0;
  for (const FileLight& light : file.lights) {
    const auto [x, y, z] = light.direction;
    const RgbD color = color_of(light.irradiance);
    // The sign of degrees takes two bytes, which a width in characters knows about.
    console.answer(
        fmt::format("{:>2}  {:>7.4f} {:>7.4f} {:>7.4f}  {:>8}  {:>9}  {:>10}  {:>6.3f} {:>6.3f} {:>6.3f} {:>11.5g}  {}",
                    ++number, x, y, z, degrees_of(azimuth_deg(light.direction)),
                    degrees_of(elevation_deg(light.direction)), degrees_of(degrees(light.half_angle)), color.r, color.g,
                    color.b, luminance(light.irradiance), in_words(light.share)));
  }
  const RgbD a = found.ambient;
  console.answer(
      fmt::format("ambient radiance {:.6g} {:.6g} {:.6g}, {} of the energy", a.r, a.g, a.b, in_words(ambient_share)));
  const auto taken = std::ranges::count_if(found.maxima, [](const ExtractMaximum& m) { return m.taken; });
  console.answer(fmt::format("left over: {} of the {} beside its mean; {} of {} maxima taken", percent(found.residual),
                             metric, taken, found.maxima.size()));
}

void add_fields(const ExtractedLights& found, const LightsFile& file, std::optional<double> ambient_share,
                const char* metric, Console& console) {
  console.field("metric", metric);
  JsonValue::Array lights, maxima;
  for (const FileLight& light : file.lights) {
    lights.emplace_back(JsonValue::Object{{"direction", xyz(light.direction)},
                                          {"azimuth_deg", azimuth_deg(light.direction)},
                                          {"elevation_deg", elevation_deg(light.direction)},
                                          {"half_angle_deg", degrees(light.half_angle)},
                                          {"irradiance", rgb(light.irradiance)},
                                          {"share", number_or_null(light.share)}});
  }
  for (const ExtractMaximum& m : found.maxima) {
    maxima.emplace_back(
        JsonValue::Object{{"direction", xyz(m.direction)}, {"luminance", m.luminance}, {"taken", m.taken}});
  }
  console.field("lights", std::move(lights));
  console.field("ambient_radiance", rgb(found.ambient));
  console.field("ambient_share", number_or_null(ambient_share));
  console.field("residual", found.residual);
  console.field("maxima", std::move(maxima));
}

/// The picture the coefficients came from, or what they show.
Image<Rgb> panorama_of(const Coefficients& source, const Run& run) {
  const Projection equirect = {Layout::kEquirect};
  if (!source.picture) {
    return render(source.sh.coefficients, equirect, image_size(Layout::kEquirect, kMarkedRows), run).radiance;
  }
  const Environment& picture = *source.picture;
  const int rows = panorama_rows(picture.projection, {picture.radiance.width(), picture.radiance.height()});
  return resample(picture, equirect, std::min(rows, 2 * kMarkedRows), {}, run).radiance;
}

/// Where the marked panorama goes: as asked, or beside what is worked on under the picture's name; empty: nowhere.
std::filesystem::path marked_path(const LightsOptions& options, const Coefficients& source) {
  if (options.marked == kNoPicture) return {};
  if (!options.marked.empty() || !source.picture) return options.marked;
  return options.source.input.paths.front().stem().string() + "-lights.png";
}

void write_marked(const std::filesystem::path& path, const Coefficients& source, const LightsFile& file, Call& call) {
  std::vector<PanoramaMark> marks;
  for (const FileLight& light : file.lights) {
    marks.push_back({light.direction, light.half_angle, static_cast<int>(marks.size()) + 1});
  }
  const std::vector<std::byte> png = encode_png(marked_panorama(panorama_of(source, call.run), marks));
  write_file(path, png);
  call.console.wrote(path, png.size(), "panorama with the lights marked");
}

void run_lights(const LightsOptions& options, Call& call) {
  if (!options.marked.empty() && options.marked != kNoPicture && options.marked.extension() != ".png") {
    throw Error(ErrorKind::kUsage, options.marked.string() + ": the marked panorama is a PNG", "name it .png");
  }
  Coefficients source = read_coefficients(options.source, call);
  source.sh = to_quantity(source.sh, ShQuantity::kRadiance);
  if (source.sh.coefficients.bands() > kMaxBands) {
    throw Error(ErrorKind::kUsage, fmt::format("lights are looked for in {} bands at most", kMaxBands),
                "--bands 6 leaves out the rest; zonal split finds sharper lights in the pixels");
  }
  ExtractOptions extract = options.extract;
  extract.metric = options.radiance ? ExtractMetric::kRadiance : ExtractMetric::kIrradiance;
  extract.nonnegative = !options.allow_negative;
  const char* metric = options.radiance ? "radiance" : "irradiance";
  const ExtractedLights found = extract_lights(source.sh.coefficients, extract);

  const double whole = std::sqrt(4 * kPi) * luminance(source.sh.coefficients[0]);
  LightsFile file{found.ambient, {}};
  for (const ExtractedLight& light : found.lights) {
    file.lights.push_back({light.direction, light.irradiance, light.half_angle, share_of(energy(light), whole)});
  }
  const std::optional<double> ambient_share = share_of(energy(found.ambient, 4 * kPi), whole);
  if (static_cast<int>(file.lights.size()) < extract.lights) {
    call.console.note(
        fmt::format("{} of {} lights: another would explain nothing more", file.lights.size(), extract.lights));
  }
  call.console.field("bands", source.sh.coefficients.bands());
  add_fields(found, file, ambient_share, metric, call.console);
  if (options.path != "-") answer_table(found, file, ambient_share, metric, call.console);
  if (const std::filesystem::path marked = marked_path(options, source); !marked.empty()) {
    write_marked(marked, source, file, call);
  }
  if (!options.path.empty()) write_text(lights_json_text(file), options.path, "lights", call);
}

}  // namespace

void add_lights(CLI::App& app, Call& call) {
  auto options = std::make_shared<LightsOptions>();
  CLI::App& verb = *app.add_subcommand(
      "lights",
      "Ambient light and a few others that stand for a picture or for coefficients, as a game would use them.");
  options->source.picture_bands = 6;  // to tell lights apart that are 40 degrees from each other
  add_coefficient_options(verb, options->source);
  constexpr const char* kGroup = "Lights";
  verb.add_option("-n,--lights", options->extract.lights, "at most so many")
      ->capture_default_str()
      ->check(CLI::Range(0, 64))
      ->group(kGroup);
  verb.add_flag("--radiance", options->radiance,
                "fit the radiance; the irradiance, which is what matte surfaces show, if not said")
      ->group(kGroup);
  verb.add_flag("--refine", options->extract.refine,
                "move the lights to where they fit best together; they are maxima of the light otherwise")
      ->group(kGroup);
  verb.add_flag("--cones", options->extract.cones, "find the size of each light too; they are points otherwise")
      ->group(kGroup);
  verb.add_flag("--allow-negative", options->allow_negative,
                "lights and ambient may be below zero where that fits better")
      ->group(kGroup);
  verb.add_option("--marked", options->marked,
                  "a PNG of the panorama with the lights numbered on it, or none; for pictures NAME-lights.png if not said")
      ->group("Output");
  verb.add_option("-o,--output", options->path,
                  "the lights as a file of JSON, - for standard output in place of the table")
      ->group("Output");
  add_run_options(verb, call);
  verb.footer(
      "Azimuth is counted from +X toward +Y, elevation up from the horizon. Irradiance is that of a surface facing the "
      "light (the table has its luminance); share is of the luminous energy from all sides. For a sun and its exact "
      "size take zonal split, which looks at the pixels.\n\n"
      "Examples:\n"
      "  zonal lights sunset.hdr -n 3 --marked lights.png\n"
      "  zonal lights sunset.hdr -n 2 --refine --cones -o lights.json\n"
      "  zonal lights sh.json --radiance --json");
  verb.callback([options, &call] { run_lights(*options, call); });
}

}  // namespace zonal
