#pragma once

#include <string>

#include "zonal/io/shader.h"

namespace zonal {

/// Where the irradiance is computed. Per vertex it is interpolated over the triangle, per fragment the normal is.
enum class ShadingStage { kVertex, kFragment };

struct ShaderProgramOptions {
  ShaderLanguage language = ShaderLanguage::kGlsl;
  ShadingStage stage = ShadingStage::kVertex;
  RgbD albedo = {1, 1, 1};  ///< of the surface: K_diff is albedo/pi
  double scale = 1;         ///< f_scale: what E may be too bright by for the picture's range
  /// In words, for the comment: the axes of the coefficients, into which the program turns the normals. One line.
  std::string frame = "right-handed, +Z up, +X the centre of the panorama";
};

/// A program that draws a matte surface in the light of nine coefficients, and those coefficients. GLSL is `#version
/// 410`; the other languages have the same two stages, each a text that compiles by itself (C++: headers with one
/// template each, on the caller's vectors as glm has them).
///
/// The interface is that of a course on game graphics (Tokoi, "lighting by the environment", homework): position pv and
/// normal nv come in at locations 0 and 1; matrix mc takes positions to clip coordinates, mg normals to the axes of the
/// coefficients; the light is `uniform vec3 sh[9]` = c00, c1-1, c10, c11, c2-2, c2-1, c20, c21, c22, which is index
/// l(l+1)+m, of the radiance, in the real basis without the Condon-Shortley sign: our own order and sign. The colour is
/// I_diff = (K_diff * E) f_scale with E(n) in the form of Ramamoorthi & Hanrahan 2001, eq. 13. Not clamped: three bands
/// of a strong light may be negative on its far side.
struct ShaderProgram {
  std::string vertex;
  std::string fragment;
  /// The coefficients to set `sh` from: a C array `const float sh[9][3]` for GLSL and C++ (glUniform3fv(location, 9,
  /// &sh[0][0])), [9][4] with a zero for the others, whose arrays of three floats are 16 bytes apart.
  std::string uniform_c;
  /// The same nine colours as JSON, with order, quantity, sign and axes.
  std::string uniform_json;
};

/// Coefficients of any quantity and bands: those of bands 0 to 2 become radiance; bands beyond are left out (E has
/// next to nothing of them), missing ones are zero. Throws Error{kUsage} for no coefficients or an albedo or a scale
/// that is negative or not finite, Error{kInput} for coefficients that no 32-bit float holds.
ShaderProgram shader_program(const ShFile&, const ShaderProgramOptions& = {});

}  // namespace zonal
