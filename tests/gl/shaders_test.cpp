// The shader texts that the library writes, executed: drawn by OpenGL without a window (Mesa's software renderer will
// do) and compared with the library's own numbers. Exit code 77 (skipped) where there is no such OpenGL.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <limits>
#include <random>

#include "tests/gl/context.h"
#include "zonal/io/shader.h"
#include "zonal/io/shader_program.h"
#include "zonal/io/shader_workshop_test.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

constexpr double kFloatEps = std::numeric_limits<float>::epsilon();
constexpr std::size_t kNormals = 100;
constexpr int kHeight = (static_cast<int>(kNormals) + kGlWidth - 1) / kGlWidth;
constexpr std::array kQuantities = {ShQuantity::kRadiance, ShQuantity::kIrradiance, ShQuantity::kIrradianceOverPi};
constexpr std::array<std::string_view, 3> kFunctions = {"zonal_radiance", "zonal_irradiance",
                                                        "zonal_irradiance_over_pi"};

ShFile random_light(int bands) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> value(-1, 1);
  ShFile file{ShQuantity::kRadiance, Sh<RgbD>(bands)};
  for (RgbD& c : file.coefficients.values()) c = {value(random), value(random), value(random)};
  return file;
}

std::vector<Vec3> normals() {
  std::vector<Vec3> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  while (all.size() < kNormals) all.push_back(normalize({normal(random), normal(random), normal(random)}));
  return all;
}

void expect_near(const GlColor& drawn, RgbD expected, double allowed, const std::string& where) {
  EXPECT_NEAR(drawn.r, expected.r, allowed) << where;
  EXPECT_NEAR(drawn.g, expected.g, allowed) << where;
  EXPECT_NEAR(drawn.b, expected.b, allowed) << where;
  EXPECT_EQ(drawn.a, 1) << where;
}

/// Three targets, one for each quantity.
int compare_functions(const GlProgram& program, int bands) {
  const std::vector<std::vector<GlColor>> drawn = draw_points(program, normals(), 3);
  // Floats: each constant and each step rounds once; powers of z in band l have coefficients up to 2^l.
  const double allowed = kFloatEps * bands * std::ldexp(1, bands) * 3;
  int compared = 0;
  for (std::size_t q = 0; q < 3; ++q) {
    const Sh<RgbD> truth = to_quantity(random_light(bands), kQuantities[q]).coefficients;
    for (std::size_t i = 0; i < kNormals; ++i, ++compared) {
      expect_near(drawn[q][i], evaluate(truth, normals()[i]), allowed, std::string(kFunctions[q]));
    }
  }
  return compared;
}

TEST(ShadersInOpenGl, EveryGlslFunctionReturnsTheLibrarysNumbers) {
  int compared = 0;
  for (int bands = 1; bands <= 6; ++bands) {
    std::string fragment = "#version 330\nflat in vec3 normal;\n", body;
    for (std::size_t q = 0; q < 3; ++q) {
      fragment += "layout(location = " + std::to_string(q) + ") out vec4 color" + std::to_string(q) + ";\n";
      fragment += shader_text(random_light(bands), {.returns = kQuantities[q]});
      body += "  color" + std::to_string(q) + " = vec4(" + std::string(kFunctions[q]) + "(normal), 1.0);\n";
    }
    const GlProgram program = GlProgram::from_glsl(
        "#version 330\nlayout(location = 0) in vec4 pv;\nlayout(location = 1) in vec4 nv;\nuniform mat4 mc;\n"
        "flat out vec3 normal;\nvoid main() {\n  normal = nv.xyz;\n  gl_Position = mc * pv;\n}\n",
        fragment + "void main() {\n" + body + "}\n");
    glUseProgram(program.id());
    glUniformMatrix4fv(glGetUniformLocation(program.id(), "mc"), 1, GL_FALSE, clip_from_pixel(kHeight).data());
    compared += compare_functions(program, bands);
  }
  EXPECT_EQ(compared, 6 * 3 * static_cast<int>(kNormals));
}

// What the programs are drawn with: normals are turned (x to y, y to z, z to x), lengthened and must lose their w.
constexpr std::array<float, 16> kTurn = {0, 3, 0, 0, 0, 0, 3, 0, 3, 0, 0, 0, 7, 7, 7, 1};
constexpr RgbD kAlbedo = {0.9, 0.5, 0.25};
constexpr double kScale = 0.75;

ShaderProgram homework(ShaderLanguage language, ShadingStage stage) {
  return shader_program(random_light(3), {.language = language, .stage = stage, .albedo = kAlbedo, .scale = kScale});
}

int compare_program(const GlProgram& program, const std::string& where) {
  const std::vector<std::vector<GlColor>> drawn = draw_points(program, normals(), 1);
  const Sh<RgbD> truth = to_quantity(random_light(3), ShQuantity::kIrradiance).coefficients;
  int compared = 0;
  for (std::size_t i = 0; i < kNormals; ++i, ++compared) {
    const Vec3 n = normals()[i];
    const RgbD e = evaluate(truth, {n.z, n.x, n.y});
    // Nine products of floats near 1, and a normal of a few roundings.
    expect_near(drawn[0][i], (kScale / kPi) * (kAlbedo * e), 16 * kFloatEps, where);
  }
  return compared;
}

std::vector<float> nine_colors(int floats_apart) {
  const ShFile light = random_light(3);
  std::vector<float> values;
  for (const RgbD c : light.coefficients.values()) {
    const Rgb stored(c);
    values.insert(values.end(), {stored.r, stored.g, stored.b});
    if (floats_apart == 4) values.push_back(0);
  }
  return values;
}

TEST(ShadersInOpenGl, TheGlslProgramReturnsTheLibrarysNumbers) {
  int compared = 0;
  for (const ShadingStage stage : {ShadingStage::kVertex, ShadingStage::kFragment}) {
    const ShaderProgram text = homework(ShaderLanguage::kGlsl, stage);
    const GlProgram program = GlProgram::from_glsl(text.vertex, text.fragment);
    glUseProgram(program.id());
    const auto location = [&](const char* name) { return glGetUniformLocation(program.id(), name); };
    glUniformMatrix4fv(location("mc"), 1, GL_FALSE, clip_from_pixel(kHeight).data());
    glUniformMatrix4fv(location("mg"), 1, GL_FALSE, kTurn.data());
    glUniform3fv(location("sh"), 9, nine_colors(3).data());
    compared += compare_program(program, "GLSL");
  }
  EXPECT_EQ(compared, 2 * static_cast<int>(kNormals));
}

/// HLSL by way of the reference compiler and SPIR-V, which OpenGL draws too.
class HlslInOpenGl : public testing::Test {
 protected:
  void SetUp() override {
    if (!epoxy_has_gl_extension("GL_ARB_gl_spirv")) GTEST_SKIP() << "this OpenGL reads no SPIR-V";
    if (!has_program("glslangValidator")) GTEST_SKIP() << "glslangValidator is not installed";
  }
  std::string spirv(const std::string& text, const std::string& stage) const {
    std::ofstream(workshop_ / "text") << text;
    const std::string command = "glslangValidator -D -V -e main -S " + stage + " -o " + (workshop_ / "module") + " " +
                                (workshop_ / "text") + " > " + (workshop_ / "log") + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << content(workshop_ / "log");
    return content(workshop_ / "module");
  }
  static void set_block(GLuint binding, const std::vector<float>& values) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);  // lives as long as the context
    glBindBuffer(GL_UNIFORM_BUFFER, buffer);
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(),
                 GL_STATIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
  }

 private:
  Workshop workshop_{"zonal_hlsl_in_gl"};
};

TEST_F(HlslInOpenGl, EveryFunctionReturnsTheLibrarysNumbers) {
  set_block(0, clip_from_pixel(kHeight));
  const std::string varying =
      "struct Varying { float4 position : SV_Position; nointerpolation float3 n : TEXCOORD0; };\n";
  const std::string vertex =
      spirv(varying +
                "cbuffer Transform : register(b0) { float4x4 mc; };\nVarying main(float4 pv : POSITION, float4 nv : "
                "NORMAL) {\n  Varying v;\n  v.position = mul(mc, pv);\n  v.n = nv.xyz;\n  return v;\n}\n",
            "vert");
  int compared = 0;
  for (int bands = 1; bands <= 6; ++bands) {
    std::string functions, outputs, body;
    for (std::size_t q = 0; q < 3; ++q) {
      const std::string number = std::to_string(q);
      functions += shader_text(random_light(bands), {.language = ShaderLanguage::kHlsl, .returns = kQuantities[q]});
      outputs += "float4 c" + number + " : SV_Target" + number + "; ";
      body += "  o.c" + number + " = float4(" + std::string(kFunctions[q]) + "(v.n), 1);\n";
    }
    const std::string fragment = spirv(varying + functions + "struct Out { " + outputs +
                                           "};\nOut main(Varying v) {\n  Out o;\n" + body + "  return o;\n}\n",
                                       "frag");
    compared += compare_functions(GlProgram::from_spirv(vertex, fragment), bands);
  }
  EXPECT_EQ(compared, 6 * 3 * static_cast<int>(kNormals));
}

TEST_F(HlslInOpenGl, TheProgramReturnsTheLibrarysNumbers) {
  std::vector<float> matrices = clip_from_pixel(kHeight);
  matrices.insert(matrices.end(), kTurn.begin(), kTurn.end());
  set_block(0, matrices);
  set_block(1, nine_colors(4));
  int compared = 0;
  for (const ShadingStage stage : {ShadingStage::kVertex, ShadingStage::kFragment}) {
    const ShaderProgram text = homework(ShaderLanguage::kHlsl, stage);
    const GlProgram program = GlProgram::from_spirv(spirv(text.vertex, "vert"), spirv(text.fragment, "frag"));
    compared += compare_program(program, "HLSL");
  }
  EXPECT_EQ(compared, 2 * static_cast<int>(kNormals));
}

}  // namespace
}  // namespace zonal

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::unique_ptr<zonal::GlContext> context;
  try {
    context = std::make_unique<zonal::GlContext>();
  } catch (const std::exception& e) {
    std::printf("skipped: %s\n", e.what());
    return 77;
  }
  std::printf("drawn by %s\n", context->renderer().c_str());
  return RUN_ALL_TESTS();
}
