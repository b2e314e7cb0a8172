#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "zonal/report/bake_record.h"
#include "zonal/sphere/frame.h"

namespace zonal {
namespace {

std::string words_of(LobeKind lobe) {
  switch (lobe) {
    case LobeKind::kGgx:
      return "GGX";
    case LobeKind::kCharlie:
      return "Charlie";
    case LobeKind::kPhong:
      return "Phong";
    case LobeKind::kBlinnPhong:
      return "Blinn-Phong";
    default:
      return std::string(name_of(lobe));
  }
}

std::vector<Fact> settings_of(const Bake& bake, const BakeOptions& options, const BakeFileOptions& files,
                              const BakeOrigin& origin) {
  std::string command;
  for (const std::string& word : origin.command) command += (command.empty() ? "" : " ") + word;
  std::string storage = std::string(name_of(files.format));
  if (files.format == MapFormat::kKtx2)
    storage += files.float32 ? ", 32-bit floats" : ", 16-bit floats";
  else
    storage += ", " + std::string(name_of(files.layout));
  return {{"command", command},
          {"input hash", origin.input.hash},
          {"projection",
           fmt::format("{} ({})", name_of(origin.input.environment.projection.layout), origin.input.projection_reason)},
          {"chain", fmt::format("{} px, {} levels, {}", options.size_px, bake.chain.size(), words_of(options.lobe))},
          {"roughness of the levels", std::string(name_of(options.roughness_map))},
          {"irradiance map", fmt::format("{} px, E (not divided by π)", options.irradiance_px)},
          {"coefficients", fmt::format("{} bands of radiance", options.bands)},
          {"maps stored as", storage},
          {"axes", files.engine ? fmt::format("{}: {}", files.engine->name, files.engine->source)
                                : "right-handed, +Z up, +X the centre of the panorama"}};
}

/// An orthogonal matrix whose entries are 0 and ±1, as "vec3(-d.y, d.z, d.x)".
std::string shuffle_of(const Rotation& matrix) {
  std::string parts;
  for (const Vec3& row : matrix.rows) {
    const std::pair<double, const char*> entries[] = {{row.x, "d.x"}, {row.y, "d.y"}, {row.z, "d.z"}};
    for (const auto& [value, name] : entries) {
      if (std::abs(value) > 0.5) parts += (parts.empty() ? "" : ", ") + std::string(value < 0 ? "-" : "") + name;
    }
  }
  return "vec3(" + parts + ")";
}

std::string lod_of(RoughnessMap map, std::size_t levels) {
  const std::size_t last = levels - 1;
  switch (map) {
    case RoughnessMap::kLinear:
      return fmt::format("{}.0 * roughness", last);
    case RoughnessMap::kFilament:
      return fmt::format("{}.0 * roughness * (2.0 - roughness)", last);
    case RoughnessMap::kUnity:
      return fmt::format("{}.0 * roughness * (1.7 - 0.7 * roughness)", last);
    case RoughnessMap::kUnreal:
      return fmt::format("{}.0 + 1.2 * log2(roughness)", last);
    case RoughnessMap::kBabylon:
      break;
  }
  return fmt::format("0.8 * ({}.0 + 2.0 * log2(roughness))", last);
}

std::vector<Snippet> snippets_of(const Bake& bake, const BakeOptions& options, const BakeFileOptions& files) {
  constexpr Rotation kSamplerFromWorld = {{Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}}};
  const Rotation lookup = files.engine ? files.engine->cube_from_engine : kSamplerFromWorld;
  const std::string axes =
      files.engine ? "the world axes of " + std::string(files.engine->name) : "+Z up, +X the panorama's centre";
  std::string code = fmt::format(
      "// n: normal, v: toward the eye; unit vectors, {}.\n"
      "vec3 cube(vec3 d) {{ return {}; }}\n\n"
      "vec3 E = texture(irradiance, cube(n)).rgb;  // or zonal_irradiance(n) of sh.glsl\n"
      "float lod = max({}, 0.0);\n"
      "vec3 prefiltered = textureLod(specular, cube(reflect(-v, n)), lod).rgb;\n"
      "vec2 dfg_value = texture(dfg, vec2(dot(n, v), roughness)).rg;\n"
      "vec3 color = albedo / 3.14159265 * E + prefiltered * (f0 * dfg_value.r + dfg_value.g);",
      axes, shuffle_of(lookup), lod_of(options.roughness_map, bake.chain.size()));
  return {{"In a shader", std::move(code)}};
}

}  // namespace

BakePage page_of(Bake&& bake, const Survey& survey, const BakeOptions& options, const BakeFileOptions& files,
                 const BakeOrigin& origin, const std::vector<BakedFile>& written) {
  BakePage page;
  page.title = origin.name;
  page.subtitle =
      fmt::format("{}, {} × {}, {} ({})", origin.input.format, origin.input_size.width, origin.input_size.height,
                  name_of(origin.input.environment.projection.layout), origin.input.projection_reason);
  page.settings = settings_of(bake, options, files, origin);
  page.loading = snippets_of(bake, options, files);
  page.panorama = std::move(bake.panorama);
  page.survey = survey;
  page.irradiance = std::move(bake.irradiance);
  page.irradiance_up = bake.irradiance_up, page.irradiance_down = bake.irradiance_down;
  page.irradiance_report = bake.irradiance_report;
  page.irradiance_verified = bake.irradiance_verified;
  page.lobe = words_of(options.lobe);
  page.chain = std::move(bake.chain);
  page.sh = std::move(bake.fits);
  page.split_sum = std::move(bake.split_sum);
  page.split_sum_channels = "Red: scale of f0; green: bias; blue: albedo of a Charlie sheen.";
  page.warnings = origin.warnings;
  for (const BakedFile& file : written) page.files.push_back(file.file);
  if (origin.timings) page.timings = std::move(bake.timings);
  page.footer = origin.program;
  return page;
}

}  // namespace zonal
