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

/// The exponents of the Phong chain: from 512 to 1 in equal ratios.
std::vector<double> exponents(int levels) {
  std::vector<double> list;
  for (int i = 0; i < levels; ++i) list.push_back(levels == 1 ? 1 : std::pow(512, 1 - i / (levels - 1.0)));
  return list;
}

/// Every map that is a convolution of the panorama, analysed once.
void add_filtered(ViewData& data, const Environment& panorama, const ViewDataOptions& options, const Run& run) {
  const int levels = levels_from(options.chain_px);
  const std::vector<double> shininess = exponents(levels);
  std::vector<Lobe> lobes = {Lobe::cosine()};
  for (int i = 1; i < levels; ++i) lobes.push_back(lobe_for_roughness(LobeKind::kGgx, i / (levels - 1.0)));
  for (const double s : shininess) lobes.push_back(Lobe::phong(s));
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

  ViewTexture phong{.name = "phong_chain", .shape = TextureShape::kCube};
  for (int i = 0; i < levels; ++i) phong.levels.push_back(level(levels + i, options.chain_px >> i));
  data.textures.push_back(std::move(phong));
  add_uniform(data, "phong_levels", std::vector<double>{1.0 * levels});
  std::vector<double> padded = shininess;
  padded.resize(8, 1);
  add_uniform(data, "phong_exponents", padded);
}

}  // namespace

ViewData view_data(const Environment& environment, const ViewDataOptions& options, const Run& run) {
  const auto panorama_of = [&](int rows) {
    return resample(environment, {Layout::kEquirect}, rows, {.uncovered = Uncovered::kRimMean}, run);
  };
  const Environment panorama = panorama_of(options.panorama_px);
  ViewData data;
  data.exposure_ev = auto_exposure_ev(panorama.radiance);
  const auto picture = [&](const char* name, Image<Rgb> image, bool repeats_x = false) {
    data.textures.push_back({.name = name, .repeats_x = repeats_x, .levels = {std::move(image)}});
  };
  picture("environment", panorama.radiance, true);
  picture("environment_small", panorama_of(options.reference_rows).radiance, true);
  data.textures.push_back({.name = "environment_mips", .repeats_x = true, .levels = halved_pictures(panorama.radiance)});
  data.textures.push_back({.name = "environment_cube",
                           .shape = TextureShape::kCube,
                           .levels = {resample(panorama, kStack, options.cube_px, {}, run).radiance}});
  picture("sphere_map", sphere_map_picture(panorama, 2 * options.cube_px, run));
  picture("dual_paraboloid", dual_paraboloid_picture(panorama, 2 * options.cube_px, run));
  add_filtered(data, panorama, options, run);
  data.textures.push_back({.name = "dfg_table", .table = true, .levels = {dfg_table(64, DfgVariant::kStandard, run)}});
  data.textures.push_back({.name = "window_table", .table = true, .levels = {window_picture()}});
  data.textures.push_back({.name = "normal_map",
                           .repeats_x = true,
                           .repeats_y = true,
                           .table = true,
                           .levels = halved_pictures(bump_normals(128))});

  const Sh<RgbD> radiance = project(panorama, 6, run);
  picture("highlight_map", highlight_picture(64, mean_radiance(radiance)));
  add_light_uniforms(data, radiance);
  return data;
}

}  // namespace zonal
