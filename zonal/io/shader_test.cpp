#include "zonal/io/shader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "zonal/base/error.h"
#include "zonal/io/shader_workshop_test.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

ShFile random_light(int bands, unsigned seed = 4) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  ShFile file{ShQuantity::kRadiance, Sh<RgbD>(bands)};
  for (RgbD& c : file.coefficients.values()) c = {value(random), value(random), value(random)};
  return file;
}

std::size_t occurrences(const std::string& text, std::string_view what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(Shader, LooksAsPromised) {
  ShFile light{ShQuantity::kIrradianceOverPi, Sh<RgbD>(2)};
  const double constant = std::sqrt(1 / (4 * kPi)), linear = std::sqrt(3 / (4 * kPi));
  light.coefficients(0, 0) = (1 / constant) * RgbD{1, 2, 0.5};
  light.coefficients(1, 0) = (1 / linear) * RgbD{0.25, 0, 0};
  light.coefficients(1, -1) = (1 / linear) * RgbD{0, 0, -4};
  EXPECT_EQ(shader_text(light, {.returns = ShQuantity::kIrradianceOverPi, .frame = "right-handed, +Y up"}),
            R"(// Irradiance over pi on a surface with normal n, in the units of the picture's radiance.
// A matte surface reflects albedo times this.
// n: unit vector; axes: right-handed, +Y up.
// 2 bands of spherical harmonics; between bright lights the sum may be slightly negative.
highp vec3 zonal_irradiance_over_pi(highp vec3 n) {
  highp float x = n.x;
  highp float y = n.y;
  highp float z = n.z;
  return (vec3(1.0, 2.0, 0.5) + z * vec3(0.25, 0.0, 0.0))
      + y * vec3(0.0, 0.0, -4.0);
}
)");
}

TEST(Shader, HasOneConstantForEachCoefficientThatCounts) {
  for (int bands = 1; bands <= 6; ++bands) {
    const std::string radiance = shader_text(random_light(bands), {.returns = ShQuantity::kRadiance});
    EXPECT_EQ(occurrences(radiance, "vec3("), static_cast<std::size_t>(bands * bands));
    EXPECT_EQ(occurrences(radiance, "zonal_radiance"), 1u);
  }
  // The cosine removes l = 3 and l = 5: 1 + 3 + 5 + 9 coefficients stay.
  EXPECT_EQ(occurrences(shader_text(random_light(4)), "vec3("), 9u);
  EXPECT_EQ(occurrences(shader_text(random_light(6)), "vec3("), 18u);
  EXPECT_EQ(occurrences(shader_text({ShQuantity::kRadiance, Sh<RgbD>(6)}), "vec3(0.0, 0.0, 0.0)"), 1u);
}

TEST(Shader, EveryLanguageHasItsSpelling) {
  const std::pair<ShaderLanguage, std::string_view> heads[] = {
      {ShaderLanguage::kGlsl, "highp vec3 zonal_irradiance(highp vec3 n) {"},
      {ShaderLanguage::kHlsl, "\nfloat3 zonal_irradiance(float3 n) {"},
      {ShaderLanguage::kMsl, "inline float3 zonal_irradiance(float3 n) {"},
      {ShaderLanguage::kWgsl, "fn zonal_irradiance(n: vec3<f32>) -> vec3<f32> {"},
      {ShaderLanguage::kCpp, "template <class Vec3>\nVec3 zonal_irradiance(const Vec3& n) {"}};
  for (const auto& [language, head] : heads) {
    EXPECT_EQ(occurrences(shader_text(random_light(3), {.language = language}), head), 1u) << name_of(language);
    EXPECT_EQ(shader_language_named(name_of(language)), language);
  }
  EXPECT_EQ(shader_language_named("cg"), std::nullopt);
}

TEST(Shader, RefusesWhatItCannotWrite) {
  EXPECT_THROW((void)shader_text(random_light(7)), Error);
  EXPECT_THROW((void)shader_text({}), Error);
  const ShFile irradiance = to_quantity(random_light(5), ShQuantity::kIrradiance);
  EXPECT_THROW((void)shader_text(irradiance, {.returns = ShQuantity::kRadiance}), Error);
  ShFile huge = random_light(2);
  huge.coefficients[1].r = 1e39;
  EXPECT_THROW((void)shader_text(huge), Error);
  huge.coefficients[1].r = std::nan("");
  EXPECT_THROW((void)shader_text(huge), Error);
  EXPECT_THROW((void)shader_text(random_light(2), {.frame = "a\nfloat evil;"}), std::logic_error);
}

// The emitted C++ is compiled and run: the same polynomial that the other languages spell differently.
TEST(SlowShader, TheCompiledFunctionHasTheValuesOfTheCoefficients) {
  if (!has_program("c++")) GTEST_SKIP() << "no compiler";
  const Workshop workshop("zonal_shader_cpp");
  constexpr int kDirections = 40;
  std::vector<Vec3> directions = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  while (directions.size() < kDirections)
    directions.push_back(normalize({normal(random), normal(random), normal(random)}));

  const std::pair<ShQuantity, std::string> kinds[] = {{ShQuantity::kRadiance, "zonal_radiance"},
                                                      {ShQuantity::kIrradiance, "zonal_irradiance"},
                                                      {ShQuantity::kIrradianceOverPi, "zonal_irradiance_over_pi"}};
  std::string program = R"(#include <cstdio>
struct V { float x, y, z; V(float a, float b, float c) : x(a), y(b), z(c) {} };
V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator*(float s, V a) { return {s * a.x, s * a.y, s * a.z}; }
)";
  std::string body = "int main() {\n  V v(0, 0, 0);\n";
  for (int bands = 1; bands <= 6; ++bands) {
    const std::string space = "bands" + std::to_string(bands);
    program += "namespace " + space + " {\n";
    for (const auto& [quantity, name] : kinds) {
      program += shader_text(random_light(bands), {.language = ShaderLanguage::kCpp, .returns = quantity});
    }
    program += "}\n";
  }
  std::ostringstream calls;
  calls.precision(9);
  for (int bands = 1; bands <= 6; ++bands) {
    for (const auto& [quantity, name] : kinds) {
      for (const Vec3 d : directions) {
        calls << "  v = bands" << bands << "::" << name << "(V(" << d.x << ", " << d.y << ", " << d.z << "));\n"
              << "  std::printf(\"%.9g %.9g %.9g\\n\", v.x, v.y, v.z);\n";
      }
    }
  }
  std::ofstream(workshop / "main.cpp") << program << body << calls.str() << "}\n";
  ASSERT_EQ(std::system(("c++ -std=c++17 -Wall -Wextra -Werror -Wno-unused-variable -o " + (workshop / "run") + " " +
                         (workshop / "main.cpp") + " > " + (workshop / "log") + " 2>&1 && " + (workshop / "run") +
                         " > " + (workshop / "values"))
                            .c_str()),
            0)
      << content(workshop / "log");

  std::ifstream values(workshop / "values");
  int compared = 0;
  for (int bands = 1; bands <= 6; ++bands) {
    for (const auto& [quantity, name] : kinds) {
      const Sh<RgbD> truth = to_quantity(random_light(bands), quantity).coefficients;
      for (const Vec3 d : directions) {
        double r = 0, g = 0, b = 0;
        ASSERT_TRUE(values >> r >> g >> b);
        const RgbD expected = evaluate(truth, d);
        // Floats: each constant and each step rounds once; powers of z in band l have coefficients up to 2^l.
        const double allowed = double{std::numeric_limits<float>::epsilon()} * bands * std::ldexp(1, bands) * 3;
        EXPECT_NEAR(r, expected.r, allowed) << name << ' ' << bands;
        EXPECT_NEAR(g, expected.g, allowed) << name << ' ' << bands;
        EXPECT_NEAR(b, expected.b, allowed) << name << ' ' << bands;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 6 * 3 * kDirections);
}

// The outside opinion on GLSL and HLSL, where the Khronos reference compiler is installed.
TEST(SlowShader, TheReferenceCompilerAcceptsIt) {
  if (!has_program("glslangValidator")) GTEST_SKIP() << "glslangValidator is not installed";
  const Workshop workshop("zonal_shader_glsl");
  const auto compiles = [&](const std::string& source, const std::string& flags) {
    std::ofstream(workshop / "shader.frag") << source;
    const std::string command =
        "glslangValidator " + flags + " " + (workshop / "shader.frag") + " > " + (workshop / "log");
    return std::system(command.c_str()) == 0;
  };
  int accepted = 0;
  for (int bands = 1; bands <= 6; ++bands) {
    const std::string glsl = shader_text(random_light(bands));
    for (const std::string version : {"#version 330\n", "#version 300 es\n"}) {
      const std::string around = "out highp vec4 color;\nin highp vec3 normal;\n";
      const std::string main = "void main() { color = vec4(zonal_irradiance(normalize(normal)), 1.0); }\n";
      EXPECT_TRUE(compiles(version + around + glsl + main, "")) << content(workshop / "log");
      EXPECT_FALSE(compiles(version + around + glsl + "void main() { color = zonal_irradiance(1); }\n", ""));
      ++accepted;
    }
    const std::string hlsl = shader_text(random_light(bands), {.language = ShaderLanguage::kHlsl});
    EXPECT_TRUE(
        compiles(hlsl + "float4 main(float3 n : NORMAL) : SV_Target { return float4(zonal_irradiance(n), 1); }\n",
                 "-D -V -S frag -e main -o " + (workshop / "spirv")))
        << content(workshop / "log");
    ++accepted;
  }
  EXPECT_EQ(accepted, 18);
}

}  // namespace
}  // namespace zonal
