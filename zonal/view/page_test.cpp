#include "zonal/view/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "zonal/base/error.h"
#include "zonal/io/json_text.h"
#include "zonal/view/packed_text.h"
#include "zonal/view/packed_text_test.h"
#include "zonal/view/page_tables.h"
#include "zonal/view/rgb9e5.h"
#include "zonal/view/shader_names.h"
#include "zonal/view/shader_source.h"

namespace zonal {
namespace {

constexpr const char* kHostile = "</script><script>alert(1)</script><!--\"&'\xff.exr";

/// Light that does not compress.
Environment noise(int rows) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> stops(-4, 4);
  const auto value = [&] { return std::exp2(stops(random)); };
  Environment map = {Image<Rgb>(2 * rows, rows), {Layout::kEquirect}};
  for (Rgb& texel : map.radiance.values()) texel = {value(), value(), value()};
  return map;
}

constexpr ViewDataOptions kSmall = {
    .panorama_px = 32, .cube_px = 16, .chain_px = 16, .irradiance_px = 8, .reference_rows = 16};

const ViewData& small_light() {
  static const ViewData light = view_data(noise(32), kSmall);
  return light;
}

/// What an element of the page holds.
std::string part_of(const std::string& html, std::string_view part) {
  const std::string open = "id=\"zonal-view-" + std::string(part) + "\">";
  const std::size_t begin = html.find(open) + open.size(), end = html.find("</script>", begin);
  return html.substr(begin, end - begin);
}

nlohmann::json tables_of(const std::string& html) { return nlohmann::json::parse(part_of(html, "tables")); }

/// A shader of the page.
std::string shader_of(const nlohmann::json& tables, const nlohmann::json& pieces) {
  std::string text;
  for (const std::size_t piece : pieces) text += tables.at("shaders").at("texts").at(piece).get<std::string>();
  return text;
}

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(SlowViewPage, HoldsEachTechniqueAndEachControlOnce) {
  const nlohmann::json tables = tables_of(view_page_html(small_light()));
  std::vector<std::string> ids, names, fields;
  for (const auto& technique : tables.at("techniques")) {
    ids.push_back(technique.at("id"));
    const Technique* meant = technique_named(ids.back());
    ASSERT_NE(meant, nullptr);
    EXPECT_EQ(technique.at("explanation"), meant->explanation);
    EXPECT_EQ(technique.at("formula"), meant->formula);
    EXPECT_EQ(technique.at("source"), meant->source);
    EXPECT_EQ(technique.at("controls").size(), meant->controls.size());
  }
  for (const auto& control : tables.at("controls")) names.push_back(control.at("name"));
  for (const auto& field : tables.at("camera")) fields.push_back(field.at("name"));
  std::vector<std::string> all_ids, all_names;
  for (const Technique& technique : all_techniques()) all_ids.emplace_back(technique.id);
  for (const Control& control : all_controls()) all_names.emplace_back(control.name);
  EXPECT_EQ(ids, all_ids);
  EXPECT_EQ(names, all_names);
  EXPECT_EQ(fields, (std::vector<std::string>{"yaw", "pitch", "distance", "fov"}));
  EXPECT_GE(ids.size(), 17u);
}

TEST(SlowViewPage, GivesTheShadersAsTheLibraryWritesThem) {
  const nlohmann::json tables = tables_of(view_page_html(small_light())), &shaders = tables.at("shaders");
  constexpr ShaderHome kHome = ShaderHome::kWeb;
  for (const Technique& technique : all_techniques()) {
    EXPECT_EQ(shader_of(tables, shaders.at("compared").at(technique.id)),
              shader_text(technique_fragment_shader(kHome, technique)));
    EXPECT_EQ(shader_of(tables, shaders.at("alone").at(technique.id)),
              shader_text(lone_technique_fragment_shader(kHome, technique)));
  }
  EXPECT_EQ(shader_of(tables, shaders.at("mesh_vertex")), shader_text(mesh_vertex_shader(kHome)));
  EXPECT_EQ(shader_of(tables, shaders.at("background_vertex")), shader_text(background_vertex_shader(kHome)));
  EXPECT_EQ(shader_of(tables, shaders.at("background")), shader_text(background_fragment_shader(kHome)));
  EXPECT_EQ(shader_of(tables, shaders.at("arrow_vertex")), shader_text(arrow_vertex_shader(kHome)));
  EXPECT_EQ(shader_of(tables, shaders.at("arrow")), shader_text(arrow_fragment_shader(kHome)));
  EXPECT_EQ(tables.at("meshes").size(), mesh_shape_names().size());
  EXPECT_EQ(tables.at("light").at("textures").size(), small_light().textures.size());
  EXPECT_EQ(tables.at("light").at("uniforms").size(), small_light().uniforms.size());
}

// Names that its shaders reach lie in the first bytes, and the object does.
TEST(SlowViewPage, OpensFromItsFirstBytes) {
  for (const Technique& technique : all_techniques()) {
    ViewState state;
    state.technique = &technique;
    const ViewPageTables page = view_page_tables(small_light(), {.state = state});
    const auto tables = nlohmann::json::parse(json_text(page.tables));
    const std::size_t opening = unpacked(page.opening).size();
    const std::set<std::string> names =
        names_reached(shader_text(lone_technique_fragment_shader(ShaderHome::kWeb, technique)));
    int read = 0, later = 0;
    for (const auto& texture : tables.at("light").at("textures")) {
      const bool is_first = names.contains(texture.at("name")) || texture.at("name") == "environment";
      read += is_first;
      for (const auto& level : texture.at("levels")) {
        const std::size_t at = level.at(0), width = level.at(1), height = level.at(2);
        const std::size_t end = at + width * height * (texture.at("table") ? 6 : 4);
        EXPECT_TRUE(end <= opening || !is_first) << technique.id << " " << texture.at("name");
        later += end > opening;
      }
    }
    EXPECT_GE(read, 1) << technique.id;
    EXPECT_GE(later, 8) << technique.id;
    for (const auto& uniform : tables.at("light").at("uniforms")) {
      EXPECT_LE(uniform.at("floats").at(0).get<std::size_t>() + 4 * uniform.at("floats").at(1).get<std::size_t>(),
                opening);
    }
    for (const auto& mesh : tables.at("meshes")) {
      const std::size_t end = mesh.at("indices_at").get<std::size_t>() + 4 * mesh.at("index_count").get<std::size_t>();
      EXPECT_EQ(end <= opening, mesh.at("name") == state.mesh) << mesh.at("name");
    }
  }
}

// So that a browser need not decode it.
TEST(SlowViewPage, IsAsciiWhateverItSays) {
  const std::string html = view_page_html(small_light(), {.title = "\xe5\xa4\xa9 \xf0\x9f\x8c\x9e"});
  EXPECT_TRUE(std::ranges::all_of(html, [](char c) { return static_cast<unsigned char>(c) < 128; }));
  EXPECT_EQ(tables_of(html).at("title"), "\xe5\xa4\xa9 \xf0\x9f\x8c\x9e");
}

TEST(SlowViewPage, NoWordOfTheOutsideBecomesMarkup) {
  const std::string plain = view_page_html(small_light());
  const std::string html = view_page_html(small_light(), {.title = kHostile, .subtitle = kHostile});
  EXPECT_EQ(count(html, "<script"), count(plain, "<script"));
  EXPECT_EQ(count(html, "</script"), count(plain, "</script"));
  EXPECT_EQ(count(html, "<!--"), 0u);
  EXPECT_EQ(tables_of(html).at("title"), "</script><script>alert(1)</script><!--\"&'\xef\xbf\xbd.exr");
}

TEST(SlowViewPage, AsksNothingOfTheNetwork) {
  std::string html = view_page_html(small_light());
  // Packed numbers may look like any word.
  for (const char* packed : {"opening", "rest"}) {
    const std::string numbers = part_of(html, packed);
    html.erase(html.find(numbers), numbers.size());
  }
  EXPECT_EQ(count(html, "default-src 'none'"), 1u);
  for (const char* word : {"http:", "https:", "src=", "fetch(", "XMLHttpRequest", "import(", "eval(", "innerHTML"}) {
    EXPECT_EQ(count(html, word), 0u) << word;
  }
}

TEST(SlowViewPage, CarriesTheLibraryWhenItGetsIt) {
  const std::string plain = view_page_html(small_light());
  EXPECT_TRUE(tables_of(plain).at("chooser").is_null());
  EXPECT_EQ(count(plain, "wasm-unsafe-eval") + count(plain, "blob:"), 0u);
  const std::vector<std::byte> module(3000, std::byte{7});
  const std::string html = view_page_html(small_light(), {.module = module, .notices = "Parts by others.\n"});
  EXPECT_EQ(count(html, "<!--\nParts by others.\n-->"), 1u);
  EXPECT_EQ(count(plain, "<!--"), 0u);
  EXPECT_THROW(view_page_html(small_light(), {.module = module, .notices = "-->"}), std::logic_error);
  EXPECT_EQ(count(html, "script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:\""), 1u);
  const nlohmann::json chooser = tables_of(html).at("chooser");
  EXPECT_EQ(part_of(html, "module"), packed_text(module));
  EXPECT_EQ(chooser.at("layouts").size(), all_layouts().size());
  EXPECT_NE(chooser.at("worker").get<std::string>().find("onmessage"), std::string::npos);
  const std::string embedded = view_section(small_light(), {.module = module, .embedded = true}).html;
  EXPECT_TRUE(tables_of(embedded).at("chooser").is_null());
  EXPECT_EQ(part_of(embedded, "module"), "");
}

TEST(SlowViewPage, OpensAsItsStateSays) {
  ViewState state = parse_state("technique=phong&mesh=bumpy&yaw=30&shininess=60");
  EXPECT_EQ(tables_of(view_page_html(small_light(), {.state = state})).at("start"),
            "technique=phong&mesh=bumpy&yaw=30&exposure_ev=" + shortest(std::round(small_light().exposure_ev * 4) / 4) +
                "&shininess=60");
  state.set("exposure_ev", 2);
  const std::string start = tables_of(view_page_html(small_light(), {.state = state})).at("start");
  EXPECT_NE(start.find("exposure_ev=2&"), std::string::npos);
  state.mesh = "teapot";
  EXPECT_THROW(view_page_html(small_light(), {.state = state}), Error);
}

TEST(SlowViewPage, SaysWhatWasCutOff) {
  ViewData bright = small_light();
  EXPECT_EQ(tables_of(view_page_html(bright)).at("light").at("cut_off"), "");
  bright.textures[0].levels[0](3, 3) = {2 * kRgb9e5Max, 0, 0};
  bright.textures[0].levels[0](4, 3) = {0, 0, 2 * kRgb9e5Max};
  const std::string note = tables_of(view_page_html(bright)).at("light").at("cut_off");
  EXPECT_NE(note.find("2 texels of its maps are brighter than 65408"), std::string::npos) << note;
}

TEST(SlowViewPage, IsSmallForNoise) {
  std::vector<std::byte> module(275'000);  // the packed size of the real one
  std::mt19937 random(4);
  for (std::byte& byte : module) byte = static_cast<std::byte>(random());
  const std::string html = view_page_html(view_data(noise(256), view_page_data_options()), {.module = module});
  EXPECT_LT(html.size(), 3.0e6);
  EXPECT_GT(html.size(), 1.0e6);  // noise does not compress
}

}  // namespace
}  // namespace zonal
