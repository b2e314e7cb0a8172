#include "zonal/view/page_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "zonal/base/error.h"
#include "zonal/view/light_tables.h"
#include "zonal/view/light_turn.h"
#include "zonal/view/packed_text.h"
#include "zonal/view/page_bytes.h"
#include "zonal/view/page_parts.h"
#include "zonal/view/shader_names.h"
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

/// Texts that several shaders are made of, each once.
class ShaderTexts {
 public:
  /// The places of its pieces.
  Array add(const ShaderPieces& shader) {
    Array places;
    for (const std::string& piece : shader) {
      const auto [found, is_new] = places_.try_emplace(piece, texts_.size());
      if (is_new) texts_.emplace_back(piece);
      places.push_back(found->second);
    }
    return places;
  }
  Array texts() && { return std::move(texts_); }

 private:
  std::map<std::string, std::size_t> places_;
  Array texts_;
};

/// Each as the places of its pieces in "texts".
Object shaders() {
  constexpr ShaderHome kHome = ShaderHome::kWeb;
  ShaderTexts texts;
  Object compared, alone;
  for (const Technique& technique : all_techniques()) {
    compared.emplace_back(technique.id, texts.add(technique_fragment_shader(kHome, technique)));
    alone.emplace_back(technique.id, texts.add(lone_technique_fragment_shader(kHome, technique)));
  }
  Object list = {{"mesh_vertex", texts.add(mesh_vertex_shader(kHome))},
                 {"background_vertex", texts.add(background_vertex_shader(kHome))},
                 {"background", texts.add(background_fragment_shader(kHome))},
                 {"arrow_vertex", texts.add(arrow_vertex_shader(kHome))},
                 {"arrow", texts.add(arrow_fragment_shader(kHome))},
                 {"compared", std::move(compared)},
                 {"alone", std::move(alone)}};
  list.emplace_back("texts", std::move(texts).texts());
  return list;
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

/// All objects of the page by name.
std::vector<std::pair<std::string, Mesh>> page_meshes(const ViewPageOptions& options) {
  std::vector<std::pair<std::string, Mesh>> list;
  for (const std::string_view name : mesh_shape_names()) list.emplace_back(name, mesh_shape(name));
  list.insert(list.end(), options.meshes.begin(), options.meshes.end());
  return list;
}

const std::pair<std::string, Mesh>& opening_mesh(const std::vector<std::pair<std::string, Mesh>>& meshes,
                                                 const ViewState& state) {
  const auto found = std::ranges::find(meshes, state.mesh, [](const auto& each) { return each.first; });
  if (found == meshes.end()) {
    throw Error(ErrorKind::kUsage, fmt::format("the page has no object '{}'", state.mesh),
                "sphere, torus-knot and bumpy are in every page");
  }
  return *found;
}

/// The textures that the first picture reads.
ViewData opening_light(const ViewData& light, const ViewState& state) {
  const bool alone = state.value("compare") == 0;
  std::set<std::string> names =
      names_reached(shader_text(alone ? lone_technique_fragment_shader(ShaderHome::kWeb, *state.technique)
                                      : technique_fragment_shader(ShaderHome::kWeb, *state.technique)));
  names.merge(names_reached(shader_text(background_fragment_shader(ShaderHome::kWeb))));
  ViewData part = light;
  std::erase_if(part.textures, [&](const ViewTexture& texture) { return !names.contains(texture.name); });
  return part;
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
  return Object{{"worker", text_of(page_part("worker"))}, {"layouts", std::move(layouts)}};
}

}  // namespace

ViewPageTables view_page_tables(const ViewData& light, const ViewPageOptions& options) {
  PageBytes bytes;
  const auto meshes = page_meshes(options);
  // Arrays that are in the bytes stay where they are when they are added again.
  (void)light_tables(opening_light(light, options.state), bytes);
  const auto& [first_name, first_mesh] = opening_mesh(meshes, options.state);
  (void)mesh_table(first_name, first_mesh, bytes);
  const Object arrow = mesh_table("arrow", arrow_mesh(), bytes);
  const std::size_t opening = bytes.size();
  Object light_fields = light_tables(light, bytes);
  Array objects;
  for (const auto& [name, mesh] : meshes) objects.push_back(mesh_table(name, mesh, bytes));
  const std::span<const std::byte> all = std::as_bytes(std::span(bytes.bytes()));
  return {.tables = Object{{"title", options.title},
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
                           {"arrow", arrow},
                           {"chooser", chooser(options)}},
          .opening = packed_text(all.first(opening)),
          .rest = packed_text(all.subspan(opening))};
}

}  // namespace zonal
