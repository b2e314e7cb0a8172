#include "zonal/view/page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "zonal/base/error.h"
#include "zonal/io/json_text.h"
#include "zonal/view/packed_text.h"
#include "zonal/view/rgb9e5.h"

namespace zonal {
namespace {

constexpr const char* kHostile = "</script><script>alert(1)</script><!--\"&'\xff.exr";

/// Light that does not compress.
Environment noise(int rows) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> value(0, 2);
  Environment map = {Image<Rgb>(2 * rows, rows), {Layout::kEquirect}};
  for (Rgb& texel : map.radiance.values()) texel = {value(random), value(random), value(random)};
  return map;
}

constexpr ViewDataOptions kSmall = {
    .panorama_px = 32, .cube_px = 16, .chain_px = 16, .irradiance_px = 8, .reference_rows = 16};

const ViewData& small_light() {
  static const ViewData light = view_data(noise(32), kSmall);
  return light;
}

/// What the page's script reads.
nlohmann::json tables_of(const std::string& html) {
  const std::string_view open = R"(<script type="application/json" id="zonal-view-data">)";
  const std::size_t begin = html.find(open) + open.size(), end = html.find("</script>", begin);
  return nlohmann::json::parse(html.substr(begin, end - begin));
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
    for (const char* kind : {"compared", "alone"}) {
      const std::string shader = tables.at("shaders").at(kind).at(ids.back());
      EXPECT_NE(shader.find("vec3 shade(Surface s)"), std::string::npos) << ids.back();
    }
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
  const nlohmann::json tables = tables_of(view_page_html(small_light()));
  const std::string shared = tables.at("shaders").at("shared");
  EXPECT_TRUE(shared.starts_with("#version 300 es\n"));
  EXPECT_GT(shared.size(), 1000u);
  EXPECT_EQ(tables.at("meshes").size(), mesh_shape_names().size());
  EXPECT_EQ(tables.at("light").at("textures").size(), small_light().textures.size());
  EXPECT_EQ(tables.at("light").at("uniforms").size(), small_light().uniforms.size());
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
  const std::string html = view_page_html(small_light());
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
  const std::string html = view_page_html(small_light(), {.module = module});
  EXPECT_EQ(count(html, "script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:\""), 1u);
  const nlohmann::json chooser = tables_of(html).at("chooser");
  EXPECT_EQ(chooser.at("module"), packed_text(module));
  EXPECT_EQ(chooser.at("layouts").size(), all_layouts().size());
  EXPECT_NE(chooser.at("worker").get<std::string>().find("onmessage"), std::string::npos);
  EXPECT_TRUE(
      tables_of(view_section(small_light(), {.module = module, .embedded = true}).html).at("chooser").is_null());
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
  const std::string html = view_page_html(view_data(noise(256), view_page_data_options()));
  EXPECT_LT(html.size(), 3.0e6);
  EXPECT_GT(html.size(), 1.0e6);  // noise does not compress: nothing real is larger
}

}  // namespace
}  // namespace zonal
