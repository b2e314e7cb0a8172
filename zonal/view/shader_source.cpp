#include "zonal/view/shader_source.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

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

std::string body(std::string_view stem) { return std::string(shader_body(stem)); }

/// What every fragment shader starts with.
ShaderPieces shared(ShaderHome home) {
  return {head(home), control_uniforms() + display_constants(), body("uniforms"), body("surface"), body("display")};
}

ShaderPieces with(ShaderPieces pieces, std::string more) {
  pieces.push_back(std::move(more));
  return pieces;
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
void add_functions(std::string_view bodies, ShaderPieces& pieces) {
  const auto calls = [&](std::string_view function) { return bodies.find(function) != std::string_view::npos; };
  if (calls("ball_toward(") || calls("ball_with_normal(")) pieces.push_back(body("ball"));
  if (calls("paraboloid_toward(")) pieces.push_back(body("paraboloid"));
  if (calls("sh_basis(")) pieces.push_back(basis_function());
  if (calls("sh_sum(")) pieces.push_back(sum_function());
  if (calls("polynomial_irradiance(")) pieces.push_back(body("polynomial"));
  if (calls("lamp_center(")) pieces.push_back(body("lamp"));
  if (calls("glossy_sum(")) pieces.push_back(body("glossy_sum"));
  if (calls("phong_sum(")) pieces.push_back(body("phong_sum"));
  if (calls("exponent_level(")) pieces.push_back(body("exponent_level"));
}

/// `main`: the stem of what begins it all.
ShaderPieces fragment_shader(ShaderHome home, const ShaderPieces& bodies, std::string_view main) {
  ShaderPieces pieces = shared(home);
  add_functions(shader_text(bodies), pieces);
  pieces.insert(pieces.end(), bodies.begin(), bodies.end());
  pieces.push_back(body("surface_of_pixel"));
  pieces.push_back(body(main));
  return pieces;
}

}  // namespace

std::string_view shader_body(std::string_view stem) {
  for (const ShaderBody& body : shader_bodies()) {
    if (body.stem == stem) return body.text;
  }
  check(false, "there is no shader body of this name");
  return {};
}

std::string shader_text(const ShaderPieces& pieces) {
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  return text;
}

ShaderPieces mesh_vertex_shader(ShaderHome home) { return {head(home), body("mesh_vertex")}; }

ShaderPieces technique_fragment_shader(ShaderHome home, const Technique& technique) {
  return fragment_shader(home, {body(technique.id), body(exact_stem(technique.exact))}, "compared_main");
}

ShaderPieces lone_technique_fragment_shader(ShaderHome home, const Technique& technique) {
  return fragment_shader(home, {body(technique.id)}, "lone_main");
}

ShaderPieces background_vertex_shader(ShaderHome home) { return {head(home), body("background_vertex")}; }

ShaderPieces background_fragment_shader(ShaderHome home) { return with(shared(home), body("background")); }

ShaderPieces arrow_vertex_shader(ShaderHome home) { return {head(home), body("uniforms"), body("arrow_vertex")}; }

ShaderPieces arrow_fragment_shader(ShaderHome home) { return with(shared(home), body("arrow")); }

}  // namespace zonal
