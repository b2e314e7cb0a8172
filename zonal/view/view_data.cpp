#include "zonal/view/view_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "zonal/image/tonemap.h"
#include "zonal/light/convolve.h"
#include "zonal/light/dfg.h"
#include "zonal/light/lobe.h"
#include "zonal/light/project.h"
#include "zonal/light/resample.h"
#include "zonal/view/ambient_table.h"
#include "zonal/view/control.h"
#include "zonal/view/homework_lights.h"
#include "zonal/view/own_highlight.h"
#include "zonal/view/reflection_space.h"
#include "zonal/view/sky_maps.h"
#include "zonal/view/view_pictures.h"
#include "zonal/view/view_uniforms.h"

namespace zonal {
namespace {

constexpr Projection kStack = {Layout::kCubeStack};
constexpr int kSmallestLevel = 8;  // faces of fewer texels cannot hold a cosine lobe

int levels_from(int chain_px) {
  int levels = 1;
  while (chain_px >> levels >= kSmallestLevel) ++levels;
  return levels;
}

/// The exponents of a chain: from 512 to 1 in equal ratios, to whole numbers, whose powers cost no call of a library.
std::vector<double> exponents(int levels) {
  std::vector<double> list;
  for (int i = 0; i < levels; ++i) list.push_back(levels == 1 ? 1 : std::round(std::pow(512, 1 - i / (levels - 1.0))));
  return list;
}

/// The least power of two that brings all light below what half floats (65504) and shared exponents (65408) hold.
double unit_of(const Image<Rgb>& radiance) {
  constexpr double kMost = 32768;
  double brightest = 0, unit = 1;
  for (const Rgb& value : radiance.values()) brightest = std::max(brightest, static_cast<double>(max_channel(value)));
  while (std::isfinite(brightest) && brightest / unit > kMost) unit *= 2;
  return unit;
}

/// The published light sets, a row each.
Image<Rgb> homework_table() {
  const auto lights = homework_lights();
  Image<Rgb> table(9, static_cast<int>(lights.size()));
  for (int y = 0; y < table.height(); ++y) {
    const Sh<RgbD, 3> radiance = homework_radiance(lights[static_cast<std::size_t>(y)]);
    for (int i = 0; i < 9; ++i) table(i, y) = Rgb(radiance[static_cast<std::size_t>(i)]);
  }
  return table;
}

/// As bright on the mean of the sets as on the mean of the panorama: the homework's f_scale.
double homework_scale(RgbD mean) {
  double sum = 0;
  for (const HomeworkLight& light : homework_lights()) sum += luminance(mean_radiance(homework_radiance(light)));
  return luminance(mean) * static_cast<double>(homework_lights().size()) / sum;
}

constexpr int kReflectionChainPx = 64;  // faces of its first level

/// A chain's, as long as the shaders declare them.
void add_exponents(ViewData& data, const char* name, std::vector<double> shininess) {
  shininess.resize(8, 1);
  add_uniform(data, name, shininess);
}

/// What a published program makes of the upper half.
void add_sky_maps(ViewData& data, const Environment& panorama, int size_px, const Run& run) {
  constexpr int kLevels = 6;  // blended, a lobe between two of them is off by 9 % of its height at most
  SkyMaps sky = sky_maps(panorama, exponents(kLevels), size_px, run);
  data.textures.push_back({.name = "sky_maps", .levels = {std::move(sky.maps)}});
  data.textures.push_back({.name = "sky_shares", .table = true, .levels = {std::move(sky.shares)}});
  add_exponents(data, "sky_exponents", sky.shininess);
  add_uniform(data, "sky_levels", std::vector<double>{1.0 * kLevels});
  add_uniform(data, "sky_mean", std::vector{sky.sky_mean});
  add_uniform(data, "ground_mean", std::vector{sky.ground_mean});
}

/// Every map that is a convolution of the panorama, analysed once.
void add_filtered(ViewData& data, const Environment& panorama, const ViewDataOptions& options, const Run& run) {
  const int levels = levels_from(options.chain_px);
  const std::vector<double> shininess = exponents(levels);
  std::vector<Lobe> lobes = {Lobe::cosine()};
  for (int i = 1; i < levels; ++i) lobes.push_back(lobe_for_roughness(LobeKind::kGgx, i / (levels - 1.0)));
  for (const double s : shininess) lobes.push_back(Lobe::phong(s));
  const int first_own = static_cast<int>(lobes.size());
  for (const double roughness : ReflectionSpaceOptions().roughnesses) {
    lobes.push_back(lobe_for_roughness(LobeKind::kGgx, roughness));
  }
  const Convolution convolution(panorama, lobes, {}, run);
  const auto level = [&](int lobe, int face_px) {
    return convolution.render(lobe, kStack, image_size(Layout::kCubeStack, face_px), run).map.radiance;
  };

  ViewTexture irradiance{.name = "irradiance_map", .shape = TextureShape::kCube};
  irradiance.levels.push_back(level(0, options.irradiance_px));
  for (Rgb& value : irradiance.levels[0].values()) value = static_cast<float>(kPi) * value;
  data.textures.push_back(std::move(irradiance));

  ViewTexture ggx{.name = "ggx_chain", .shape = TextureShape::kCube};
  ggx.levels.push_back(resample(panorama, kStack, options.chain_px, {}, run).radiance);
  for (int i = 1; i < levels; ++i) ggx.levels.push_back(level(i, options.chain_px >> i));
  data.textures.push_back(std::move(ggx));
  add_uniform(data, "chain_levels", std::vector<double>{1.0 * levels});

  ViewTexture own{.name = "reflection_chain", .shape = TextureShape::kCube};
  for (int i = first_own; i < static_cast<int>(lobes.size()); ++i) {
    own.levels.push_back(level(i, kReflectionChainPx >> (i - first_own)));
  }
  data.textures.push_back(std::move(own));

  ViewTexture phong{.name = "phong_chain", .shape = TextureShape::kCube};
  for (int i = 0; i < levels; ++i) phong.levels.push_back(level(levels + i, options.chain_px >> i));
  data.textures.push_back(std::move(phong));
  add_uniform(data, "phong_levels", std::vector<double>{1.0 * levels});
  add_exponents(data, "phong_exponents", shininess);
}

}  // namespace

ViewData view_data(const Environment& environment, const ViewDataOptions& options, const Run& run) {
  ViewData data;
  Environment panorama =
      resample(environment, {Layout::kEquirect}, options.panorama_px, {.uncovered = Uncovered::kRimMean}, run);
  data.unit = unit_of(panorama.radiance);
  for (Rgb& value : panorama.radiance.values()) value = static_cast<float>(1 / data.unit) * value;
  data.exposure_ev = auto_exposure_ev(panorama.radiance);
  const auto picture = [&](const char* name, Image<Rgb> image, bool repeats_x = false) {
    data.textures.push_back({.name = name, .repeats_x = repeats_x, .levels = {std::move(image)}});
  };
  picture("environment", panorama.radiance, true);
  picture("environment_small", resample(panorama, {Layout::kEquirect}, options.reference_rows, {}, run).radiance, true);
  data.textures.push_back(
      {.name = "environment_mips", .repeats_x = true, .levels = halved_pictures(panorama.radiance)});
  data.textures.push_back({.name = "environment_cube",
                           .shape = TextureShape::kCube,
                           .levels = {resample(panorama, kStack, options.cube_px, {}, run).radiance}});
  picture("sphere_map", sphere_map_picture(panorama, 2 * options.cube_px, run));
  picture("dual_paraboloid", dual_paraboloid_picture(panorama, 2 * options.cube_px, run));
  add_filtered(data, panorama, options, run);
  data.textures.push_back({.name = "dfg_table", .table = true, .levels = {dfg_table(64, DfgVariant::kStandard, run)}});
  data.textures.push_back({.name = "ambient_table", .table = true, .levels = {ambient_reflectance_picture(run)}});
  add_uniform(data, "ambient_bands", std::vector<double>{kAmbientBrdfs});
  add_uniform(data, "greatest_shininess", std::vector<double>{control_named("shininess").greatest});
  data.textures.push_back({.name = "window_table", .table = true, .levels = {window_picture()}});
  data.textures.push_back(
      {.name = "bump_map", .repeats_x = true, .repeats_y = true, .table = true, .levels = {bump_picture(kBumpPx)}});
  add_uniform(data, "bump_height", std::vector<double>{kBumpHeight});
  add_sky_maps(data, panorama, options.sky_px, run);
  const ReflectionSpaceOptions space;
  picture("reflection_space", reflection_space_maps(panorama, space, run));
  data.textures.push_back({.name = "lean_table", .table = true, .levels = {lean_picture()}});
  add_uniform(data, "reflection_views", std::vector<double>{1.0 * space.views});
  add_uniform(data, "reflection_roughnesses", std::vector<double>(space.roughnesses.begin(), space.roughnesses.end()));

  const Sh<RgbD> radiance = project(panorama, 6, run);
  const RgbD mean = mean_radiance(radiance);
  picture("highlight_map", highlight_picture(64, mean));
  picture("highlight_drawn", drawn_highlight(64, mean));
  data.textures.push_back(own_highlight_texture(Image<Rgb>(kOwnHighlightPx, kOwnHighlightPx)));
  add_uniform(data, "highlight_unit", std::vector<double>{kOwnHighlight * luminance(mean)});
  data.textures.push_back({.name = "homework_table", .table = true, .levels = {homework_table()}});
  add_uniform(data, "homework_scale", std::vector<double>{homework_scale(mean)});
  add_light_uniforms(data, radiance);
  return data;
}

}  // namespace zonal
