// write_cases FILE: every WGSL text that the library writes, what to feed it and what it must return, as JSON.
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "zonal/io/file.h"
#include "zonal/io/json_text.h"
#include "zonal/io/shader.h"
#include "zonal/io/shader_program.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

constexpr double kFloatEps = std::numeric_limits<float>::epsilon();
constexpr std::size_t kNormals = 64;
constexpr int kWidth = 16, kHeight = 4;  // of the picture that the programs draw, a point for each normal

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

JsonValue color(RgbD c) { return JsonValue::Array{c.r, c.g, c.b}; }

/// A compute shader around one function of shader_text.
JsonValue function_case(int bands, ShQuantity quantity) {
  const ShFile light = random_light(bands);
  const std::string text = shader_text(light, {.language = ShaderLanguage::kWgsl, .returns = quantity});
  const std::size_t name = text.find("fn ") + 3;
  const Sh<RgbD> truth = to_quantity(light, quantity).coefficients;
  JsonValue::Array expected;
  for (const Vec3 n : normals()) expected.push_back(color(evaluate(truth, n)));
  return JsonValue::Object{
      {"name", std::string(name_of(quantity)) + ", bands: " + std::to_string(bands)},
      {"code", text +
                   "@group(0) @binding(0) var<storage, read> normals: array<vec4<f32>>;\n"
                   "@group(0) @binding(1) var<storage, read_write> result: array<vec4<f32>>;\n"
                   "@compute @workgroup_size(1) fn main(@builtin(global_invocation_id) id: vec3<u32>) {\n"
                   "  result[id.x] = vec4<f32>(" +
                   text.substr(name, text.find('(', name) - name) + "(normals[id.x].xyz), 1.0);\n}\n"},
      // Floats: each constant and each step rounds once; powers of z in band l have coefficients up to 2^l.
      {"allowed", kFloatEps * bands * std::ldexp(1, bands) * 3},
      {"expected", std::move(expected)}};
}

/// The two stages of shader_program, with normals turned (x to y, y to z, z to x) and lengthened.
JsonValue program_case(ShadingStage stage) {
  const ShFile light = random_light(3);
  const RgbD albedo = {0.9, 0.5, 0.25};
  constexpr double kScale = 0.75;
  const ShaderProgram program =
      shader_program(light, {.language = ShaderLanguage::kWgsl, .stage = stage, .albedo = albedo, .scale = kScale});
  const Sh<RgbD> truth = to_quantity(light, ShQuantity::kIrradiance).coefficients;
  JsonValue::Array sh, expected;
  for (const RgbD c : light.coefficients.values()) {
    for (const double value : {c.r, c.g, c.b, 0.0}) sh.emplace_back(value);
  }
  for (const Vec3 n : normals())
    expected.push_back(color((kScale / kPi) * (albedo * evaluate(truth, {n.z, n.x, n.y}))));
  return JsonValue::Object{
      {"name", stage == ShadingStage::kVertex ? "program, per vertex" : "program, per fragment"},
      {"vertex", program.vertex},
      {"fragment", program.fragment},
      {"matrices", JsonValue::Array{2.0 / kWidth,
                                    0,
                                    0,
                                    0,
                                    0,
                                    -2.0 / kHeight,
                                    0,
                                    0,
                                    0,
                                    0,
                                    1,
                                    0,
                                    -1,
                                    1,
                                    0,
                                    1,  //
                                    0,
                                    3,
                                    0,
                                    0,
                                    0,
                                    0,
                                    3,
                                    0,
                                    3,
                                    0,
                                    0,
                                    0,
                                    7,
                                    7,
                                    7,
                                    1}},
      {"sh", std::move(sh)},
      {"allowed", 16 * kFloatEps},  // nine products of floats near 1, and a normal of a few roundings
      {"expected", std::move(expected)}};
}

JsonValue cases() {
  JsonValue::Array directions, functions, programs;
  for (const Vec3 n : normals()) directions.push_back(JsonValue::Array{n.x, n.y, n.z});
  for (int bands = 1; bands <= 6; ++bands) {
    for (const ShQuantity quantity : {ShQuantity::kRadiance, ShQuantity::kIrradiance, ShQuantity::kIrradianceOverPi}) {
      functions.push_back(function_case(bands, quantity));
    }
  }
  for (const ShadingStage stage : {ShadingStage::kVertex, ShadingStage::kFragment}) {
    programs.push_back(program_case(stage));
  }
  return JsonValue::Object{{"width", kWidth},
                           {"height", kHeight},
                           {"normals", std::move(directions)},
                           {"functions", std::move(functions)},
                           {"programs", std::move(programs)}};
}

}  // namespace
}  // namespace zonal

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_cases FILE\n");
    return 2;
  }
  zonal::write_file(argv[1], zonal::json_text(zonal::cases()));
  return 0;
}
