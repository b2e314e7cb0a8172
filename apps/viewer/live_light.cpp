#include "apps/viewer/live_light.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <set>

#include "zonal/base/check.h"
#include "zonal/light/convolve.h"
#include "zonal/light/project.h"
#include "zonal/light/resample.h"
#include "zonal/view/light_turn.h"
#include "zonal/view/shader_names.h"
#include "zonal/view/shader_source.h"
#include "zonal/view/view_pictures.h"
#include "zonal/view/view_uniforms.h"

namespace zonal {
namespace {

constexpr Projection kStack = {Layout::kCubeStack};
constexpr int kGlossyPx = 64, kMattePx = 32;  // faces
constexpr int kBands = 128;                   // of a filtered map while the hand moves; sharper lobes are widened

/// Pictures in the eye's frame, which know of the light's mean alone.
constexpr std::array<std::string_view, 3> kTurnless = {"highlight_map", "highlight_drawn", "highlight_own"};
/// What live_light() makes, beside all that add_light_uniforms() does.
constexpr std::array<std::string_view, 10> kMade = {
    "environment", "environment_small", "environment_mips", "environment_cube", "irradiance_map",
    "ggx_chain",   "chain_levels",      "phong_chain",      "phong_levels",     "phong_exponents"};

template <class List>
bool holds(const List& list, std::string_view name) {
  return std::ranges::find(list, name) != std::end(list);
}

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

const ViewTexture& texture_named(const ViewData& data, std::string_view name) {
  const auto found = std::ranges::find(data.textures, name, &ViewTexture::name);
  check(found != data.textures.end(), "the data of a view has this texture");
  return *found;
}

/// A drawing of the panorama with the texture's other properties as they were.
void add_texture(LiveLight& live, const ViewData& whole, std::string_view name, std::vector<Image<Rgb>> levels) {
  ViewTexture texture;
  const ViewTexture& old = texture_named(whole, name);
  texture.name = old.name, texture.shape = old.shape, texture.table = old.table;
  texture.repeats_x = old.repeats_x, texture.repeats_y = old.repeats_y;
  texture.levels = std::move(levels);
  live.data.textures.push_back(std::move(texture));
}

/// What turns with the light and the shader of this technique looks up.
void add_pictures(LiveLight& live, const ViewData& whole, const std::vector<std::string>& used,
                  const Environment& turned, const Run& run) {
  const auto rows = [&](std::string_view name) { return texture_named(whole, name).levels[0].height(); };
  if (holds(used, "environment_small")) {
    add_texture(live, whole, "environment_small",
                {resample(turned, turned.projection, rows("environment_small"), {}, run).radiance});
  }
  if (holds(used, "environment_mips")) {
    add_texture(live, whole, "environment_mips", halved_pictures(turned.radiance));
  }
  if (holds(used, "environment_cube")) {
    add_texture(live, whole, "environment_cube",
                {resample(turned, kStack, rows("environment_cube") / 6, {}, run).radiance});
  }
}

/// The glossy map for the roughness of the slider always: that is what is timed; the others where they are looked up.
void add_filtered(LiveLight& live, const ViewData& whole, const std::vector<std::string>& used, const ViewState& state,
                  const Environment& turned, const Run& run) {
  constexpr double kSmoothest = 0.05;
  std::vector<Lobe> lobes = {lobe_for_roughness(LobeKind::kGgx, std::max(kSmoothest, state.value("roughness")))};
  const bool matte = holds(used, "irradiance_map"), phong = holds(used, "phong_chain");
  const double shininess = state.value("shininess");
  if (matte) lobes.push_back(Lobe::cosine());
  if (phong) lobes.push_back(Lobe::phong(shininess));
  const Convolution convolution(turned, lobes, {.max_bands = kBands}, run);
  int next = 0;
  const auto rendered = [&](int face_px) {
    return convolution.render(next++, kStack, image_size(Layout::kCubeStack, face_px), run).map.radiance;
  };
  add_texture(live, whole, "ggx_chain", {rendered(kGlossyPx)});
  add_uniform(live.data, "chain_levels", std::vector<double>{1});
  if (matte) {
    Image<Rgb> irradiance = rendered(kMattePx);
    for (Rgb& value : irradiance.values()) value = static_cast<float>(kPi) * value;
    add_texture(live, whole, "irradiance_map", {std::move(irradiance)});
  }
  if (phong) {
    add_texture(live, whole, "phong_chain", {rendered(kGlossyPx)});
    add_uniform(live.data, "phong_levels", std::vector<double>{1});
    add_uniform(live.data, "phong_exponents", std::vector<double>(8, shininess));
  }
}

}  // namespace

std::vector<std::string> names_used(const Technique& technique, const ViewData& data) {
  std::set<std::string> reached =
      names_reached(shader_text(technique_fragment_shader(ShaderHome::kDesktop, technique)));
  reached.merge(names_reached(shader_text(background_fragment_shader(ShaderHome::kDesktop))));
  if (reached.contains("sh_turned")) reached.insert("sh");  // of which it is made
  std::vector<std::string> used;
  for (const ViewTexture& texture : data.textures) {
    if (reached.contains(texture.name)) used.push_back(texture.name);
  }
  for (const ViewUniform& uniform : data.uniforms) {
    if (reached.contains(uniform.name)) used.push_back(uniform.name);
  }
  return used;
}

bool can_be_live(const std::vector<std::string>& used, const ViewData& whole) {
  return std::ranges::all_of(whole.textures, [&](const ViewTexture& texture) {
    return texture.table || holds(kMade, texture.name) || holds(kTurnless, texture.name) || !holds(used, texture.name);
  });
}

LiveLight live_light(const ViewData& whole, const std::vector<std::string>& used, const ViewState& state,
                     const Run& run) {
  LiveLight live;
  live.data.exposure_ev = whole.exposure_ev;
  live.world_from_light = world_from_light(state);

  auto start = std::chrono::steady_clock::now();
  const Environment panorama = {texture_named(whole, "environment").levels[0], {Layout::kEquirect}};
  const Environment turned = resample(panorama, panorama.projection, panorama.radiance.height(),
                                      {.world_from_source = live.world_from_light}, run);
  add_pictures(live, whole, used, turned, run);
  live.times.turn = ms_since(start);

  start = std::chrono::steady_clock::now();
  const Sh<RgbD> radiance = project(turned, 6, run);
  live.times.project = ms_since(start);

  start = std::chrono::steady_clock::now();
  add_light_uniforms(live.data, radiance);
  live.times.derive = ms_since(start);

  start = std::chrono::steady_clock::now();
  add_filtered(live, whole, used, state, turned, run);
  live.times.filter = ms_since(start);

  add_texture(live, whole, "environment", {turned.radiance});
  for (const ViewTexture& texture : whole.textures) {
    const bool kept = texture.table || holds(kTurnless, texture.name);
    if (kept && holds(used, texture.name)) live.data.textures.push_back(texture);
  }
  for (const ViewUniform& uniform : whole.uniforms) {
    const bool made =
        std::ranges::find(live.data.uniforms, uniform.name, &ViewUniform::name) != live.data.uniforms.end();
    if (!made) live.data.uniforms.push_back(uniform);
  }
  return live;
}

}  // namespace zonal
