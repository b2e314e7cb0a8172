#include "zonal/view/technique.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "zonal/io/shader_workshop_test.h"
#include "zonal/light/synthetic.h"
#include "zonal/view/control.h"
#include "zonal/view/shader_bodies.h"
#include "zonal/view/shader_source.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {
namespace {

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Technique, EachHasItsNameItsWordsAndItsControls) {
  std::set<std::string_view> ids, titles;
  for (const Technique& technique : all_techniques()) {
    EXPECT_TRUE(ids.insert(technique.id).second) << technique.id;
    EXPECT_TRUE(titles.insert(technique.title).second) << technique.title;
    EXPECT_EQ(technique_named(technique.id), &technique);
    EXPECT_GT(technique.explanation.size(), 80u) << technique.id;
    EXPECT_FALSE(technique.formula.empty() || technique.source.empty() || technique.group.empty()) << technique.id;
    for (const std::string_view name : technique.controls) {
      const Control& control = control_named(name);
      EXPECT_TRUE(std::ranges::none_of(common_controls(), [&](const Control& c) { return c.name == name; })) << name;
      // A control of a technique is in its shader, and not only declared there.
      EXPECT_GE(count(shader_text(technique_fragment_shader(ShaderHome::kDesktop, technique)), control.name), 2u)
          << technique.id << " " << name;
    }
  }
  EXPECT_EQ(technique_named("none"), nullptr);
  EXPECT_GE(ids.size(), 20u);
}

TEST(Technique, EveryControlBelongsToATechniqueOrToAll) {
  std::set<std::string_view> used;
  for (const Control& control : common_controls()) used.insert(control.name);
  for (const Technique& technique : all_techniques()) used.insert(technique.controls.begin(), technique.controls.end());
  for (const Control& control : all_controls()) {
    EXPECT_TRUE(used.contains(control.name)) << control.name;
    EXPECT_LT(control.least, control.greatest) << control.name;
    EXPECT_TRUE(control.least <= control.initial && control.initial <= control.greatest) << control.name;
    EXPECT_EQ(control.choices.size(),
              control.kind == ControlKind::kChoice ? static_cast<std::size_t>(control.greatest) + 1 : 0u)
        << control.name;
  }
  EXPECT_EQ(used.size(), all_controls().size());
}

// Every sampler of the shaders is a texture of the data and the other way round; every array has the length declared.
TEST(Technique, TheDataIsWhatTheShadersDeclare) {
  const Environment light = testcard({Layout::kEquirect}, {64, 32});
  const ViewData data =
      view_data(light, {.panorama_px = 32, .cube_px = 16, .chain_px = 16, .irradiance_px = 8, .reference_rows = 8});
  const std::string_view declared = shader_body("uniforms");
  EXPECT_EQ(count(declared, "uniform sampler"), data.textures.size());
  for (const ViewTexture& texture : data.textures) {
    const std::string kind = texture.shape == TextureShape::kCube ? "samplerCube " : "sampler2D ";
    EXPECT_TRUE(has(declared, "uniform " + kind + texture.name + ";")) << texture.name;
    ASSERT_FALSE(texture.levels.empty());
    for (std::size_t i = 0; i < texture.levels.size(); ++i) {
      const Image<Rgb>& level = texture.levels[i];
      EXPECT_EQ(level.width(), std::max(1, texture.levels[0].width() >> i)) << texture.name;
      if (texture.shape == TextureShape::kCube) {
        EXPECT_EQ(level.height(), 6 * level.width()) << texture.name;
      }
      for (const Rgb& value : level.values()) {
        ASSERT_TRUE(texture.table || (value.r >= 0 && value.g >= 0 && value.b >= 0)) << texture.name;
      }
    }
  }
  for (const ViewUniform& uniform : data.uniforms) {
    const std::string kind = uniform.components == 1 ? "float" : "vec" + std::to_string(uniform.components);
    const std::size_t length = uniform.values.size() / static_cast<std::size_t>(uniform.components);
    const std::string whole = "uniform " + kind + " " + uniform.name;
    EXPECT_TRUE(has(declared, whole + ";") ? length == 1 : has(declared, whole + "[" + std::to_string(length) + "];"))
        << uniform.name << " of " << length;
  }
}

// No program of a page may use more than 16 textures (WebGL 2's least), and a technique names few.
TEST(Technique, NoneUsesMoreTexturesThanAPageHas) {
  const std::string_view declared = shader_body("uniforms");
  for (const Technique& technique : all_techniques()) {
    const std::string text = shader_text(technique_fragment_shader(ShaderHome::kWeb, technique));
    int used = 0;
    for (std::size_t at = declared.find("uniform sampler"); at != declared.npos;
         at = declared.find("uniform sampler", at + 1)) {
      const std::size_t begin = declared.find(' ', at + 8) + 1;
      used += count(text, declared.substr(begin, declared.find(';', begin) - begin)) > 1;
    }
    EXPECT_GE(used, 1) << technique.id;
    EXPECT_LE(used, 16) << technique.id;
  }
}

TEST(SlowTechnique, BothHomesAcceptEveryShader) {
  if (!has_program("glslangValidator")) GTEST_SKIP() << "no glslangValidator";
  const Workshop workshop("zonal_view_shaders");
  int checked = 0;
  const auto check = [&](const std::string& text, const std::string& name) {
    std::ofstream(workshop / name) << text;
    EXPECT_EQ(std::system(("glslangValidator " + (workshop / name) + " > " + (workshop / "log") + " 2>&1").c_str()), 0)
        << name << "\n"
        << content(workshop / "log");
    ++checked;
  };
  for (const ShaderHome home : {ShaderHome::kDesktop, ShaderHome::kWeb}) {
    check(shader_text(mesh_vertex_shader(home)), "mesh.vert");
    check(shader_text(background_vertex_shader(home)), "background.vert");
    check(shader_text(background_fragment_shader(home)), "background.frag");
    check(shader_text(arrow_vertex_shader(home)), "arrow.vert");
    check(shader_text(arrow_fragment_shader(home)), "arrow.frag");
    for (const Technique& technique : all_techniques()) {
      check(shader_text(technique_fragment_shader(home, technique)), std::string(technique.id) + ".frag");
      check(shader_text(lone_technique_fragment_shader(home, technique)), std::string(technique.id) + "-alone.frag");
    }
  }
  EXPECT_EQ(checked, static_cast<int>(2 * (5 + 2 * all_techniques().size())));
}

TEST(ViewState, GoesThroughItsText) {
  ViewState state;
  state.technique = technique_named("reflection-space");
  state.mesh = "bumpy";
  state.camera.pitch_deg = -31.5;
  state.set("f0", 0.25);
  state.set("reflection_by", 2);
  const ViewState again = parse_state(state_text(state));
  EXPECT_EQ(state_text(again), state_text(state));
  EXPECT_EQ(again.technique, state.technique);
  EXPECT_EQ(again.value("f0"), 0.25);
  EXPECT_EQ(again.camera.pitch_deg, -31.5);
}

TEST(ViewState, LightsAreMarkedWhereATechniqueShadesByThem) {
  EXPECT_EQ(marked_lights(parse_state("technique=extracted-lights&light_count=2")), 2);
  EXPECT_EQ(marked_lights(parse_state("technique=lambert")), 1);
  EXPECT_EQ(marked_lights(parse_state("technique=ambient-cube")), 0);
}

TEST(ViewState, MatricesUndoEachOther) {
  const CameraMatrices camera = camera_matrices({.yaw_deg = 33, .pitch_deg = -20, .distance = 4}, 1.7);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) {
        sum += static_cast<double>(camera.world_from_clip[static_cast<std::size_t>(4 * k + row)]) *
               camera.clip_from_world[static_cast<std::size_t>(4 * column + k)];
      }
      EXPECT_NEAR(sum, row == column ? 1 : 0, 2e-4) << row << " " << column;  // floats, near 0.05 and far 100
    }
  }
}

}  // namespace
}  // namespace zonal
