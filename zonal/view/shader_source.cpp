#include "zonal/view/shader_source.h"

#include <fmt/format.h>

#include <functional>

#include "zonal/base/check.h"
#include "zonal/image/tonemap.h"
#include "zonal/io/json_text.h"
#include "zonal/sh/basis_constants.h"
#include "zonal/view/control.h"
#include "zonal/view/shader_bodies.h"

namespace zonal {
namespace {

std::string head(ShaderHome home) {
  if (home == ShaderHome::kDesktop) return "#version 410 core\n";
  return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
         "precision highp samplerCube;\n";
}

std::string control_uniforms() {
  std::string text;
  for (const Control& control : all_controls()) {
    text += fmt::format("uniform {} {};\n", control.kind == ControlKind::kSlider ? "float" : "int", control.name);
  }
  return text;
}

std::string literal(double value) {
  std::string digits = shortest(static_cast<float>(value));
  if (digits.find_first_of(".e") == digits.npos) digits += ".0";
  return digits;
}

/// What the shaders show light by is the library's own (math/vec.h, image/tonemap.h).
std::string display_constants() {
  const auto weight = [](RgbD primary) { return literal(luminance(primary)); };
  return fmt::format("const vec3 luminance_weights = vec3({}, {}, {});\nconst float tone_white = {};\n",
                     weight({1, 0, 0}), weight({0, 1, 0}), weight({0, 0, 1}), literal(Tonemap{}.white));
}

/// Straight-line code, from the constants of the library's own recurrence (sh/eval.h), of six bands at a unit
/// direction: `use(l, m)` is what to do once `now` is y_lm but for its longitude, (c, s) being r^m times cosine and
/// sine of m longitudes.
std::string basis_steps(const std::function<std::string(int l, int m)>& use) {
  constexpr int kBands = 6;
  constexpr const BasisConstants<kBands>& k = kBasisConstants<kBands>;
  std::string text = "  float c = 1.0, s = 0.0, before, now, next;\n";
  for (int m = 0; m < kBands; ++m) {
    text += fmt::format("  before = 0.0; now = {};\n", literal(k.start[m]));
    for (int l = m; l < kBands; ++l) {
      if (l > m) {
        text += fmt::format("  next = {} * d.z * now - {} * before; before = now; now = next;\n",
                            literal(k.slope[l][m]), literal(k.offset[l][m]));
      }
      text += "  " + use(l, m) + "\n";
    }
    text += "  next = d.x * c - d.y * s; s = d.x * s + d.y * c; c = next;\n";
  }
  return text;
}

std::string basis_function() {
  return "void sh_basis(vec3 d, out float y[36]) {\n" + basis_steps([](int l, int m) {
           const int zero = l * (l + 1);
           if (m == 0) return fmt::format("y[{}] = now;", zero);
           return fmt::format("y[{}] = now * c; y[{}] = now * s;", zero + m, zero - m);
         }) +
         "}\n";
}

/// The coefficients, turned or not, times the basis and a weight for each band.
std::string sum_function() {
  return "vec3 sh_sum(vec3 d, float weights[6]) {\n  vec3 sum = vec3(0.0);\n" + basis_steps([](int l, int m) {
           const int zero = l * (l + 1);
           if (m == 0) return fmt::format("sum += weights[{}] * now * sh_turned[{}];", l, zero);
           return fmt::format("sum += weights[{}] * now * (c * sh_turned[{}] + s * sh_turned[{}]);", l, zero + m,
                              zero - m);
         }) +
         "  return sum;\n}\n";
}

/// What every fragment shader starts with.
std::string shared(ShaderHome home) {
  std::string text = head(home) + control_uniforms() + display_constants();
  for (const std::string_view stem : {"uniforms", "surface", "display"}) text += shader_body(stem);
  return text;
}

std::string_view exact_stem(Exact exact) {
  switch (exact) {
    case Exact::kDiffuse:
      return "exact_diffuse";
    case Exact::kMirror:
      return "exact_mirror";
    case Exact::kGlossy:
      return "exact_glossy";
    case Exact::kBentMirror:
      return "exact_bent_mirror";
    case Exact::kLamp:
      return "exact_lamp";
    case Exact::kNine:
      return "exact_nine";
    case Exact::kSkyMap:
      return "exact_sky_map";
    case Exact::kPhong:
      break;
  }
  return "exact_phong";
}

/// What several techniques share, for those that call it.
std::string functions_for(std::string_view bodies) {
  std::string text;
  const auto calls = [&](std::string_view function) { return bodies.find(function) != std::string_view::npos; };
  if (calls("sh_basis(")) text += basis_function();
  if (calls("sh_sum(")) text += sum_function();
  if (calls("polynomial_irradiance(")) text += shader_body("polynomial");
  if (calls("lamp_center(")) text += shader_body("lamp");
  if (calls("glossy_sum(")) text += shader_body("glossy_sum");
  if (calls("phong_sum(")) text += shader_body("phong_sum");
  if (calls("exponent_level(")) text += shader_body("exponent_level");
  return text;
}

std::string fragment_shader(ShaderHome home, const std::string& bodies) {
  return shared(home) + functions_for(bodies) + bodies + std::string(shader_body("surface_main"));
}

}  // namespace

std::string_view shader_body(std::string_view stem) {
  for (const ShaderBody& body : shader_bodies()) {
    if (body.stem == stem) return body.text;
  }
  check(false, "there is no shader body of this name");
  return {};
}

std::string mesh_vertex_shader(ShaderHome home) { return head(home) + std::string(shader_body("mesh_vertex")); }

std::string technique_fragment_shader(ShaderHome home, const Technique& technique) {
  return fragment_shader(
      home, std::string(shader_body(technique.id)) + std::string(shader_body(exact_stem(technique.exact))));
}

std::string lone_technique_fragment_shader(ShaderHome home, const Technique& technique) {
  return fragment_shader(home,
                         std::string(shader_body(technique.id)) + "vec3 exact(Surface s) { return vec3(0.0); }\n");
}

std::string background_vertex_shader(ShaderHome home) {
  return head(home) + std::string(shader_body("background_vertex"));
}

std::string background_fragment_shader(ShaderHome home) {
  return shared(home) + std::string(shader_body("background"));
}

std::string arrow_vertex_shader(ShaderHome home) {
  return head(home) + std::string(shader_body("uniforms")) + std::string(shader_body("arrow_vertex"));
}

std::string arrow_fragment_shader(ShaderHome home) { return shared(home) + std::string(shader_body("arrow")); }

}  // namespace zonal
