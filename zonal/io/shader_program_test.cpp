#include "zonal/io/shader_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "zonal/base/error.h"
#include "zonal/io/shader_workshop_test.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

constexpr ShaderLanguage kLanguages[] = {ShaderLanguage::kGlsl, ShaderLanguage::kHlsl, ShaderLanguage::kMsl,
                                         ShaderLanguage::kWgsl, ShaderLanguage::kCpp};
constexpr ShadingStage kStages[] = {ShadingStage::kVertex, ShadingStage::kFragment};

ShFile random_light(int bands, ShQuantity quantity = ShQuantity::kRadiance) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> value(-1, 1);
  ShFile file{quantity, Sh<RgbD>(bands)};
  for (RgbD& c : file.coefficients.values()) c = {value(random), value(random), value(random)};
  return file;
}

std::size_t occurrences(const std::string& text, std::string_view what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(ShaderProgram, IsTheHomeworkOfTheLecture) {
  const ShaderProgram program = shader_program(random_light(3), {.frame = "those of the lecture"});
  EXPECT_EQ(program.vertex.find("#version 410\n"), 0u);
  EXPECT_EQ(program.fragment.find("#version 410\n"), 0u);
  for (const std::string_view line :
       {"\nuniform vec3 sh[9];\n", "\nlayout(location = 0) in vec4 pv;", "\nlayout(location = 1) in vec4 nv;",
        "\nuniform mat4 mc;", "\nuniform mat4 mg;", "\nout vec3 idiff;\n", "  gl_Position = mc * pv;\n",
        "// c00, c1-1, c10, c11, c2-2, c2-1, c20, c21, c22.\n", "those of the lecture.\n"}) {
    EXPECT_EQ(occurrences(program.vertex, line), 1u) << line;
  }
  EXPECT_EQ(occurrences(program.fragment, "\nin vec3 idiff;\n"), 1u);
  // The constants that the lecture prints, with the digits that it lacks: k3 is 0.743124, not 0.743125.
  EXPECT_EQ(occurrences(program.vertex,
                        "k1 = 0.42904276, k2 = 0.5116634, k3 = 0.7431239, k4 = 0.88622695, k5 = 0.24770796;"),
            1u);
}

TEST(ShaderProgram, ShadesInTheStageThatIsAskedFor) {
  int compared = 0;
  for (const ShaderLanguage language : kLanguages) {
    const ShaderProgram vertex = shader_program(random_light(3), {.language = language});
    const ShaderProgram fragment =
        shader_program(random_light(3), {.language = language, .stage = ShadingStage::kFragment});
    EXPECT_GE(occurrences(vertex.vertex, "zonal_irradiance("), 2u) << name_of(language);
    EXPECT_EQ(occurrences(vertex.fragment, "zonal_irradiance("), 0u) << name_of(language);
    EXPECT_EQ(occurrences(fragment.vertex, "zonal_irradiance("), 0u) << name_of(language);
    EXPECT_GE(occurrences(fragment.fragment, "zonal_irradiance("), 2u) << name_of(language);
    for (const std::string& text : {vertex.vertex, vertex.fragment, fragment.vertex, fragment.fragment}) {
      for (const auto& [open, close] : {std::pair("(", ")"), std::pair("{", "}"), std::pair("[", "]")}) {
        EXPECT_EQ(occurrences(text, open), occurrences(text, close)) << text;
      }
      EXPECT_EQ(occurrences(text, "$"), 0u);
      EXPECT_EQ(text.back(), '\n');
      ++compared;
    }
  }
  EXPECT_EQ(compared, 20);
}

TEST(ShaderProgram, TheUniformIsTheRadianceInOrder) {
  const ShFile light = random_light(3);
  const std::string names[] = {"c00", "c1-1", "c10", "c11", "c2-2", "c2-1", "c20", "c21", "c22"};
  int compared = 0;
  for (const ShaderLanguage language : kLanguages) {
    const ShaderProgram program = shader_program(light, {.language = language});
    const bool tight = language == ShaderLanguage::kGlsl || language == ShaderLanguage::kCpp;
    EXPECT_EQ(program.uniform_c.find(tight ? "const float sh[9][3] = {\n" : "const float sh[9][4] = {\n"), 0u);
    std::istringstream lines(program.uniform_c);
    std::string line;
    std::getline(lines, line);
    const nlohmann::json json = nlohmann::json::parse(program.uniform_json);
    EXPECT_EQ(json["quantity"], "radiance");
    EXPECT_EQ(json["condon_shortley"], false);
    ASSERT_EQ(json["values"].size(), 9u);
    for (std::size_t i = 0; i < 9; ++i, ++compared) {
      float r = 0, g = 0, b = 0;
      ASSERT_TRUE(std::getline(lines, line));
      ASSERT_EQ(std::sscanf(line.c_str(), " {%ff, %ff, %ff", &r, &g, &b), 3) << line;
      const Rgb expected(light.coefficients[i]);
      EXPECT_EQ(Rgb(r, g, b), expected) << "the very float";
      EXPECT_NE(line.find(tight ? "}," : ", 0.0f},"), line.npos);
      EXPECT_EQ(line.substr(line.find("// ") + 3), names[i]);
      EXPECT_EQ(json["order"][i], names[i]);
      EXPECT_EQ(static_cast<float>(json["values"][i][2]), expected.b);
    }
  }
  EXPECT_EQ(compared, 45);
}

TEST(ShaderProgram, TakesAnyQuantityAndBands) {
  const ShFile radiance = random_light(6);
  const std::string uniform = shader_program(radiance).uniform_json;
  EXPECT_EQ(shader_program({ShQuantity::kRadiance, with_bands(radiance.coefficients, 3)}).uniform_json, uniform);
  // E of six bands has lost l = 3 and 5, but not what the program needs. Its numbers went to and fro: a float's
  // rounding.
  const nlohmann::json there = nlohmann::json::parse(uniform)["values"];
  for (const ShQuantity quantity : {ShQuantity::kIrradiance, ShQuantity::kIrradianceOverPi}) {
    const nlohmann::json back =
        nlohmann::json::parse(shader_program(to_quantity(radiance, quantity)).uniform_json)["values"];
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_NEAR(back[i][0].get<double>(), there[i][0].get<double>(), 1.2e-7) << i;
    }
  }
  const nlohmann::json one = nlohmann::json::parse(shader_program(random_light(1)).uniform_json)["values"];
  EXPECT_NE(one[0][0], 0);
  for (std::size_t i = 1; i < 9; ++i) EXPECT_EQ(one[i][1], 0);
}

TEST(ShaderProgram, RefusesWhatItCannotWrite) {
  EXPECT_THROW((void)shader_program({}), Error);
  EXPECT_THROW((void)shader_program(random_light(3), {.albedo = {1, -0.1, 1}}), Error);
  EXPECT_THROW((void)shader_program(random_light(3), {.scale = std::nan("")}), Error);
  EXPECT_THROW((void)shader_program(random_light(3), {.scale = 1e39}), Error);
  EXPECT_THROW((void)shader_program(random_light(3), {.frame = "a\nfloat evil;"}), std::logic_error);
  ShFile huge = random_light(2);
  huge.coefficients[1].r = 1e39;
  EXPECT_THROW((void)shader_program(huge), Error);
  huge.coefficients[1].r = std::nan("");
  EXPECT_THROW((void)shader_program(huge), Error);
}

// The Khronos reference compiler's opinion of GLSL (both stages, linked) and HLSL.
TEST(SlowShaderProgram, TheReferenceCompilerAcceptsIt) {
  if (!has_program("glslangValidator")) GTEST_SKIP() << "glslangValidator is not installed";
  const Workshop workshop("zonal_program_glslang");
  const std::string vertex = workshop / "program.vert", fragment = workshop / "program.frag", log = workshop / "log";
  const auto compiles = [&](const std::string& words) {
    return std::system(("glslangValidator " + words + " > " + log + " 2>&1").c_str()) == 0;
  };
  int accepted = 0;
  for (const ShadingStage stage : kStages) {
    for (const ShaderLanguage language : {ShaderLanguage::kGlsl, ShaderLanguage::kHlsl}) {
      const ShaderProgram program = shader_program(random_light(3), {.language = language, .stage = stage});
      std::ofstream(vertex) << program.vertex;
      std::ofstream(fragment) << program.fragment;
      if (language == ShaderLanguage::kGlsl) {
        EXPECT_TRUE(compiles("-l " + vertex + " " + fragment)) << content(log);
        std::ofstream(fragment) << program.fragment + "void broken() { return 1; }\n";
        EXPECT_FALSE(compiles("-l " + vertex + " " + fragment)) << "it accepts anything";
        accepted += 2;
      } else {
        for (const std::string& file : {vertex, fragment}) {
          EXPECT_TRUE(compiles("-D -V -e main -o " + (workshop / "spirv") + " " + file)) << content(log);
          ++accepted;
        }
        std::ofstream(fragment) << program.fragment + "void broken() { return 1; }\n";
        EXPECT_FALSE(compiles("-D -V -e main -o " + (workshop / "spirv") + " " + fragment)) << "it accepts anything";
      }
    }
  }
  EXPECT_EQ(accepted, 8);
}

/// The few types of the Metal language that its texts use, as C++: no compiler of that language can be had here, but it
/// is a dialect of C++ and its words for memory and stages can be defined away.
constexpr std::string_view kMetal = R"(#pragma once
#include <cmath>
#define vertex
#define fragment
#define constant const
namespace metal {
struct float3 { float x, y, z; float3() = default; float3(float a, float b, float c) : x(a), y(b), z(c) {} };
struct float4 {
  union { struct { float x, y, z, w; }; float3 xyz; };
  float4() = default;
  float4(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {}
  float4(float3 v, float d) : x(v.x), y(v.y), z(v.z), w(d) {}
};
struct float4x4 { float4 c[4]; };
inline float3 operator+(float3 a, float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline float3 operator*(float3 a, float3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline float3 operator*(float s, float3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline float3 operator*(float3 a, float s) { return s * a; }
inline float4 operator*(const float4x4& m, float4 v) {
  const auto row = [&](float float4::*r) { return m.c[0].*r * v.x + m.c[1].*r * v.y + m.c[2].*r * v.z + m.c[3].*r * v.w; };
  return {row(&float4::x), row(&float4::y), row(&float4::z), row(&float4::w)};
}
inline float3 normalize(float3 v) { return (1 / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z)) * v; }
}
)";

// Runs vertex and fragment of `language` as C++ over some normals; each line: clip position, then colour.
std::string main_of(ShaderLanguage language, ShadingStage stage) {
  const bool msl = language == ShaderLanguage::kMsl, late = stage == ShadingStage::kFragment;
  std::string text = msl ? "" : "#include \"metal_stdlib\"\nusing namespace metal;\n";
  text += "#include <cstdio>\n#include \"program.vert.h\"\n";
  // As separate texts both stages define the same struct; here they meet in one program.
  text += msl ? "namespace second {\n#define Varying SecondVarying\n#include \"program.frag.h\"\n}\n#undef Varying\n"
              : "#include \"program.frag.h\"\n";
  text +=
      "#include \"uniform.h\"\nint main() {\n  float3 light[9];\n"
      "  for (int i = 0; i < 9; ++i) light[i] = float3(sh[i][0], sh[i][1], sh[i][2]);\n"
      "  float4x4 mc{}, mg{};\n"
      "  mc.c[0].x = 2; mc.c[1].y = 3; mc.c[2].z = 4; mc.c[3] = float4(5, 6, 7, 1);\n"
      "  mg.c[0].y = 3; mg.c[1].z = 3; mg.c[2].x = 3; mg.c[3] = float4(9, 9, 9, 9);\n"
      "  float x, y, z;\n  while (std::scanf(\"%f %f %f\", &x, &y, &z) == 3) {\n"
      "    const float4 pv(x, y, z, 1), nv(x, y, z, 1);\n";
  const std::string sh_late = late ? ", light" : "", sh_early = late ? "" : ", light";
  const std::string handed = late ? "normal" : "idiff";
  if (msl) {
    text += "    const Varying a = zonal_vertex({pv, nv}, {mc, mg}" + sh_early + ");\n" +
            "    const float4 c = second::zonal_fragment({a.position, a." + handed + "}" + sh_late + ");\n";
  } else {
    text += "    const auto a = zonal_vertex<float3, float4>(pv, nv, mc, mg" + sh_early + ");\n" +
            "    const float4 c = zonal_fragment<float4>(a." + handed + sh_late + ");\n";
  }
  return text +
         "    std::printf(\"%.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g\\n\", a.position.x, a.position.y, a.position.z, "
         "a.position.w, c.x, c.y, c.z, c.w);\n  }\n}\n";
}

TEST(SlowShaderProgram, AsCppAndAsMslItReturnsTheIrradiance) {
  if (!has_program("c++")) GTEST_SKIP() << "no compiler";
  const Workshop workshop("zonal_program_cpp");
  const ShFile light = random_light(5, ShQuantity::kIrradiance);
  const Sh<RgbD> truth = with_bands(light.coefficients, 3);
  const RgbD albedo = {0.9, 0.5, 0.25};
  constexpr double kScale = 0.75;
  std::vector<Vec3> normals = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  while (normals.size() < 40) normals.push_back(normalize({normal(random), normal(random), normal(random)}));
  {
    std::ofstream input(workshop / "normals");
    input.precision(9);
    for (const Vec3 n : normals) input << n.x << ' ' << n.y << ' ' << n.z << '\n';
  }
  std::ofstream(workshop / "metal_stdlib") << kMetal;
  int compared = 0;
  for (const ShaderLanguage language : {ShaderLanguage::kCpp, ShaderLanguage::kMsl}) {
    for (const ShadingStage stage : kStages) {
      const ShaderProgram program =
          shader_program(light, {.language = language, .stage = stage, .albedo = albedo, .scale = kScale});
      std::ofstream(workshop / "program.vert.h") << program.vertex;
      std::ofstream(workshop / "program.frag.h") << program.fragment;
      std::ofstream(workshop / "uniform.h") << program.uniform_c;
      std::ofstream(workshop / "main.cpp") << main_of(language, stage);
      // Metal's attributes mean nothing here.
      ASSERT_EQ(
          std::system(("c++ -std=c++17 -Wall -Wextra -Werror -Wno-attributes -I" + (workshop / ".") + " -o " +
                       (workshop / "run") + " " + (workshop / "main.cpp") + " > " + (workshop / "log") + " 2>&1 && " +
                       (workshop / "run") + " < " + (workshop / "normals") + " > " + (workshop / "values"))
                          .c_str()),
          0)
          << content(workshop / "log");
      std::ifstream values(workshop / "values");
      for (const Vec3 n : normals) {
        double px = 0, py = 0, pz = 0, pw = 0, r = 0, g = 0, b = 0, a = 0;
        ASSERT_TRUE(values >> px >> py >> pz >> pw >> r >> g >> b >> a) << name_of(language);
        EXPECT_NEAR(px, 2 * n.x + 5, 1e-6);
        EXPECT_NEAR(py, 3 * n.y + 6, 1e-6);
        EXPECT_NEAR(pz, 4 * n.z + 7, 1e-6);
        EXPECT_EQ(pw, 1);
        EXPECT_EQ(a, 1);
        // mg carries x to y, y to z, z to x and makes the normal three times as long.
        const RgbD e = (kScale / kPi) * (albedo * evaluate(truth, {n.z, n.x, n.y}));
        // Nine products of floats near 1, and a normal of three roundings.
        const double allowed = 16 * double{std::numeric_limits<float>::epsilon()};
        EXPECT_NEAR(r, e.r, allowed) << name_of(language);
        EXPECT_NEAR(g, e.g, allowed) << name_of(language);
        EXPECT_NEAR(b, e.b, allowed) << name_of(language);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 2 * 2 * 40);
}

}  // namespace
}  // namespace zonal
