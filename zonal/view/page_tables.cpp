#include "zonal/view/page_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/view/light_tables.h"
#include "zonal/view/light_turn.h"
#include "zonal/view/packed_text.h"
#include "zonal/view/page_bytes.h"
#include "zonal/view/page_parts.h"
#include "zonal/view/shader_source.h"

namespace zonal {
namespace {

using Array = JsonValue::Array;
using Object = JsonValue::Object;

std::string text_of(std::string_view words) { return std::string(words); }

Array texts(std::span<const std::string_view> list) {
  Array array;
  for (const std::string_view words : list) array.push_back(text_of(words));
  return array;
}

Array controls() {
  Array list;
  std::size_t place = 0;
  for (const Control& control : all_controls()) {
    const char* kind = control.kind == ControlKind::kSlider   ? "slider"
                       : control.kind == ControlKind::kChoice ? "choice"
                                                              : "toggle";
    list.push_back(Object{{"name", text_of(control.name)},
                          {"label", text_of(control.label)},
                          {"kind", kind},
                          {"common", place++ < common_controls().size()},
                          {"least", control.least},
                          {"greatest", control.greatest},
                          {"initial", control.initial},
                          {"step", control.step},
                          {"choices", texts(control.choices)}});
  }
  return list;
}

Array camera() {
  Array list;
  const OrbitCamera initial;
  for (const CameraField& field : camera_fields()) {
    list.push_back(Object{{"name", text_of(field.name)},
                          {"label", text_of(field.label)},
                          {"least", field.least},
                          {"greatest", field.greatest},
                          {"initial", initial.*field.value},
                          {"step", 0}});
  }
  return list;
}

/// The sums over texels for each pixel: slow on any card.
bool is_sum(Exact exact) { return exact == Exact::kGlossy || exact == Exact::kPhong || exact == Exact::kSkyMap; }

/// The uniform marked_lights by the number of lights that people choose.
Array marks(const Technique& technique) {
  Array list;
  ViewState state;
  state.technique = &technique;
  const Control& count = control_named("light_count");
  for (double lights = count.least; lights <= count.greatest; ++lights) {
    state.set(count.name, lights);
    list.push_back(marked_lights(state));
  }
  return list;
}

Array techniques() {
  Array list;
  for (const Technique& technique : all_techniques()) {
    list.push_back(Object{{"id", text_of(technique.id)},
                          {"title", text_of(technique.title)},
                          {"group", text_of(technique.group)},
                          {"explanation", text_of(technique.explanation)},
                          {"formula", text_of(technique.formula)},
                          {"source", text_of(technique.source)},
                          {"slow", is_sum(technique.exact)},
                          {"moves", technique.moves},
                          {"marked_lights", marks(technique)},
                          {"controls", texts(technique.controls)}});
  }
  return list;
}

/// Fragment shaders all begin alike: their beginning is written once.
Object shaders() {
  const std::string background = background_fragment_shader(ShaderHome::kWeb);
  std::size_t shared = background.size();
  const auto shorten = [&](const std::string& text) {
    const auto differ = std::mismatch(text.begin(), text.end(), background.begin(), background.end());
    shared = std::min(shared, static_cast<std::size_t>(differ.first - text.begin()));
  };
  shorten(arrow_fragment_shader(ShaderHome::kWeb));
  for (const Technique& technique : all_techniques()) {
    shorten(technique_fragment_shader(ShaderHome::kWeb, technique));
    shorten(lone_technique_fragment_shader(ShaderHome::kWeb, technique));
  }
  Object compared, alone;
  for (const Technique& technique : all_techniques()) {
    compared.emplace_back(technique.id, technique_fragment_shader(ShaderHome::kWeb, technique).substr(shared));
    alone.emplace_back(technique.id, lone_technique_fragment_shader(ShaderHome::kWeb, technique).substr(shared));
  }
  return {{"shared", background.substr(0, shared)},
          {"mesh_vertex", mesh_vertex_shader(ShaderHome::kWeb)},
          {"background_vertex", background_vertex_shader(ShaderHome::kWeb)},
          {"background", background.substr(shared)},
          {"arrow_vertex", arrow_vertex_shader(ShaderHome::kWeb)},
          {"arrow", arrow_fragment_shader(ShaderHome::kWeb).substr(shared)},
          {"compared", std::move(compared)},
          {"alone", std::move(alone)}};
}

/// As floats: what a page makes of them are floats.
Array quarter_turn() {
  Array list;
  for (const double entry : quarter_turn_blocks()) list.push_back(static_cast<float>(entry));
  return list;
}

/// In `whole` steps from 0 to 1; negative numbers as in a signed short.
std::uint16_t in_steps(float value, int whole) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * static_cast<float>(whole)));
}

/// Each row of `width` numbers as its difference from the row before: neighbours are alike.
template <class Number>
std::vector<Number> row_differences(const std::vector<Number>& numbers, std::size_t width) {
  std::vector<Number> differences = numbers;
  for (std::size_t i = numbers.size(); i-- > width;) {
    differences[i] = static_cast<Number>(numbers[i] - numbers[i - width]);
  }
  return differences;
}

Object mesh_table(const std::string& name, const Mesh& mesh, PageBytes& bytes) {
  std::vector<std::uint16_t> vertices;
  for (const Vertex& vertex : mesh.vertices) {
    for (const float x : vertex.position) vertices.push_back(in_steps(x, 32767));
    for (const float x : vertex.normal) vertices.push_back(in_steps(x, 32767));
    for (const float x : vertex.uv) vertices.push_back(in_steps(std::max(x, 0.0f), 65535));
  }
  return {{"name", name},
          {"vertices_at", bytes.add(row_differences(vertices, 8))},
          {"vertex_count", mesh.vertices.size()},
          {"indices_at", bytes.add(row_differences(mesh.indices, 3))},
          {"index_count", mesh.indices.size()}};
}

Array meshes(const ViewPageOptions& options, PageBytes& bytes) {
  Array list;
  bool found = false;
  for (const std::string_view name : mesh_shape_names()) {
    list.push_back(mesh_table(text_of(name), mesh_shape(name), bytes));
    found = found || name == options.state.mesh;
  }
  for (const auto& [name, mesh] : options.meshes) {
    list.push_back(mesh_table(name, mesh, bytes));
    found = found || name == options.state.mesh;
  }
  if (!found) {
    throw Error(ErrorKind::kUsage, fmt::format("the page has no object '{}'", options.state.mesh),
                "sphere, torus-knot and bumpy are in every page");
  }
  return list;
}

std::string note(const ViewPageOptions& options) {
  if (options.embedded) return "Another panorama, other objects: zonal view IMAGE --mesh FILE.";
  if (!options.module.empty()) {
    return "All data are computed by the library, which is in this page. Other objects: zonal view IMAGE --mesh "
           "FILE opens a window.";
  }
  return "This page holds the light of one panorama, as the library computed it. Other panoramas and objects: "
         "zonal view IMAGE --html PAGE makes a page, zonal view IMAGE --mesh FILE opens a window.";
}

/// What a page needs to take other panoramas; null for one that does not.
JsonValue chooser(const ViewPageOptions& options) {
  if (options.module.empty() || options.embedded) return nullptr;
  Array layouts;
  for (const Layout layout : all_layouts()) layouts.push_back(name_of(layout));
  return Object{{"module", packed_text(options.module)},
                {"worker", text_of(page_part("worker"))},
                {"layouts", std::move(layouts)}};
}

}  // namespace

JsonValue view_page_tables(const ViewData& light, const ViewPageOptions& options) {
  PageBytes bytes;
  Object light_fields = light_tables(light, bytes);
  Array objects = meshes(options, bytes);
  Object arrow = mesh_table("arrow", arrow_mesh(), bytes);
  return Object{{"title", options.title},
                {"subtitle", options.subtitle},
                {"note", note(options)},
                {"embedded", options.embedded},
                {"start", state_text(options.state)},
                {"controls", controls()},
                {"camera", camera()},
                {"techniques", techniques()},
                {"shaders", shaders()},
                {"quarter_turn_blocks", quarter_turn()},
                {"light", std::move(light_fields)},
                {"meshes", std::move(objects)},
                {"arrow", std::move(arrow)},
                {"chooser", chooser(options)},
                {"bytes", packed_text(std::as_bytes(std::span(bytes.bytes())))}};
}

}  // namespace zonal
