#include "zonal/gl/scene.h"

#include <epoxy/gl.h>

#include <cmath>
#include <limits>

#include "zonal/gl/target.h"
#include "zonal/view/light_turn.h"
#include "zonal/view/shader_source.h"

namespace zonal {
namespace {

// Values of the uniform `measure`, beside those of Measured.
constexpr int kColors = 0, kSquares = 1;

}  // namespace

Scene::Scene() {
  glGenVertexArrays(1, &empty_array_);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  background_.emplace(shader_text(background_vertex_shader(ShaderHome::kDesktop)),
                      shader_text(background_fragment_shader(ShaderHome::kDesktop)), "the background");
  arrows_.emplace(shader_text(arrow_vertex_shader(ShaderHome::kDesktop)),
                  shader_text(arrow_fragment_shader(ShaderHome::kDesktop)), "the arrows");
  arrow_.emplace(arrow_mesh());
}

Scene::~Scene() { glDeleteVertexArrays(1, &empty_array_); }

void Scene::set_light(const ViewData& data) {
  textures_.clear();
  for (const ViewTexture& texture : data.textures) textures_.try_emplace(texture.name, texture);
  uniforms_ = data.uniforms;
}

void Scene::set_texture(const ViewTexture& texture) { textures_.insert_or_assign(texture.name, GpuTexture(texture)); }

void Scene::set_mesh(const Mesh& mesh) { mesh_.emplace(mesh); }

const GpuProgram& Scene::program_of(const Technique& technique, bool alone) {
  const auto key = std::pair(technique.id, alone);
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    GpuProgram program(shader_text(mesh_vertex_shader(ShaderHome::kDesktop)),
                       shader_text(alone ? lone_technique_fragment_shader(ShaderHome::kDesktop, technique)
                                         : technique_fragment_shader(ShaderHome::kDesktop, technique)),
                       technique.title);
    found = programs_.emplace(key, std::move(program)).first;
  }
  return found->second;
}

void Scene::set_shared(const GpuProgram& program, const ViewState& state, int width, int height, int measure) const {
  program.use();
  int unit = 0;
  for (const auto& [name, texture] : textures_) {
    if (!program.has(name.c_str())) continue;  // a shader has no more units than it can use
    texture.bind(unit);
    program.set(name.c_str(), unit++);
  }
  for (const ViewUniform& uniform : uniforms_) {
    program.set_vectors(uniform.name.c_str(), uniform.components, uniform.values);
    if (uniform.name == "sh" && program.has("sh_turned")) {
      program.set_vectors("sh_turned", uniform.components, turned_coefficients(uniform, state));
    }
  }
  for (const Control& control : all_controls()) {
    const double value = state.value(control.name);
    const std::string name(control.name);
    if (control.kind == ControlKind::kSlider) {
      program.set(name.c_str(), static_cast<float>(value));
    } else {
      program.set(name.c_str(), static_cast<int>(value));
    }
  }
  const CameraMatrices camera = camera_matrices(state.camera, static_cast<double>(width) / height);
  const auto f = [](double x) { return static_cast<float>(x); };
  program.set_matrix("clip_from_world", camera.clip_from_world);
  program.set_matrix("world_from_clip", camera.world_from_clip);
  program.set_matrix("eye_from_world", camera.eye_from_world);
  const float eye[] = {f(camera.eye.x), f(camera.eye.y), f(camera.eye.z)};
  program.set_vectors("eye", 3, eye);
  program.set_matrix("light_from_world", light_from_world(state));
  program.set("split_px", 0.5f * static_cast<float>(width));
  program.set("measure", measure);
  program.set("time_s", f(state.time_s));
  program.set("marked_lights", marked_lights(state));
}

void Scene::draw_mesh(const ViewState& state, int width, int height, int measure) {
  const bool alone = measure == kColors && state.value("compare") == 0;
  set_shared(program_of(*state.technique, alone), state, width, height, measure);
  if (mesh_) mesh_->draw();
}

void Scene::draw_arrows(const ViewState& state, int width, int height) {
  const int lights = marked_lights(state);
  if (lights == 0) return;
  set_shared(*arrows_, state, width, height, kColors);
  arrow_->draw(lights);
}

void Scene::draw_background(const ViewState& state, int width, int height, int measure) {
  set_shared(*background_, state, width, height, measure);
  glBindVertexArray(empty_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Scene::draw(const ViewState& state, int width, int height) {
  glViewport(0, 0, width, height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  draw_mesh(state, width, height, kColors);
  draw_arrows(state, width, height);
  draw_background(state, width, height, kColors);  // last, so that only what is seen of it is drawn
}

Difference Scene::difference(const ViewState& state, int width, int height) {
  int bound = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
  const DrawTarget target(width, height);
  target.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glClearColor(0, 0, -1, 0);  // blue tells the pixels that the object covers: it writes 0
  glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  glClearColor(0, 0, 0, 0);
  draw_mesh(state, width, height, kSquares);
  double error = 0, truth = 0;
  Difference difference;
  const Image<Rgb> squares = target.read();
  for (const Rgb& square : squares.values()) {
    if (square.b != 0) continue;
    ++difference.pixels;
    error += square.r;
    truth += square.g;
  }
  if (truth > 0) difference.rms = std::sqrt(error / truth);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<std::uint32_t>(bound));
  return difference;
}

Image<Rgb> Scene::values(const ViewState& state, Measured what, int width, int height) {
  int bound = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
  const DrawTarget target(width, height);
  target.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  glClearColor(kNowhere, kNowhere, kNowhere, 0);
  glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  glClearColor(0, 0, 0, 0);
  if (what == Measured::kBackground) {
    draw_background(state, width, height, static_cast<int>(what));
  } else {
    draw_mesh(state, width, height, static_cast<int>(what));
  }
  Image<Rgb> picture = target.read();
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<std::uint32_t>(bound));
  return picture;
}

}  // namespace zonal
