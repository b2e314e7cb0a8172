#include "zonal/view/shader_source.h"

#include <fmt/format.h>

#include "zonal/base/check.h"
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

/// The first six bands at a unit direction, from the constants of the library's own recurrence (sh/eval.h).
std::string basis_function() {
  constexpr int kBands = 6;
  constexpr const BasisConstants<kBands>& k = kBasisConstants<kBands>;
  std::string text = "void sh_basis(vec3 d, out float y[36]) {\n  float c = 1.0, s = 0.0, before, now, next;\n";
  for (int m = 0; m < kBands; ++m) {
    text += fmt::format("  before = 0.0; now = {};\n", literal(k.start[m]));
    for (int l = m; l < kBands; ++l) {
      if (l > m) {
        text += fmt::format("  next = {} * d.z * now - {} * before; before = now; now = next;\n", literal(k.slope[l][m]),
                            literal(k.offset[l][m]));
      }
      text += fmt::format("  y[{}] = now{};\n", l * (l + 1) + m, m > 0 ? " * c" : "");
      if (m > 0) text += fmt::format("  y[{}] = now * s;\n", l * (l + 1) - m);
    }
    text += "  next = d.x * c - d.y * s; s = d.x * s + d.y * c; c = next;\n";
  }
  return text + "}\n";
}

/// What every fragment shader starts with.
std::string shared(ShaderHome home) {
  std::string text = head(home) + control_uniforms();
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
    case Exact::kPhong:
      break;
  }
  return "exact_phong";
}

}  // namespace

std::string_view shader_body(std::string_view stem) {
  for (const ShaderBody& body : shader_bodies()) {
    if (body.stem == stem) return body.text;
  }
  check(false, "there is no shader body of this name");
  return {};
}

std::string mesh_vertex_shader(ShaderHome home) {
  return head(home) + std::string(shader_body("mesh_vertex"));
}

std::string technique_fragment_shader(ShaderHome home, const Technique& technique) {
  std::string text = shared(home);
  if (shader_body(technique.id).find("sh_basis") != std::string_view::npos) text += basis_function();
  for (const std::string_view stem : {technique.id, exact_stem(technique.exact), std::string_view("surface_main")}) {
    text += shader_body(stem);
  }
  return text;
}

std::string background_vertex_shader(ShaderHome home) {
  return head(home) + std::string(shader_body("background_vertex"));
}

std::string background_fragment_shader(ShaderHome home) {
  return shared(home) + std::string(shader_body("background"));
}

}  // namespace zonal
