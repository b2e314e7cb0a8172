#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "zonal/io/sh_json.h"

namespace zonal {

enum class ShaderLanguage {
  kGlsl,  ///< GLSL 1.30 and later, GLSL ES 3.00 and later
  kHlsl,
  kMsl,
  kWgsl,
  kCpp,  ///< a template on the caller's vector type: x, y, z, Vec3(r, g, b), v + v and float * v (as glm::vec3 has)
};

std::string_view name_of(ShaderLanguage);  // "glsl", "hlsl", "msl", "wgsl", "cpp"
std::optional<ShaderLanguage> shader_language_named(std::string_view name);

struct ShaderOptions {
  ShaderLanguage language = ShaderLanguage::kGlsl;
  ShQuantity returns = ShQuantity::kIrradiance;
  /// In words, for the comment: the axes of the normal that the function takes. Whoever has turned the coefficients
  /// (engine.h) says so here. One line.
  std::string frame = "right-handed, +Z up, +X the centre of the panorama";
};

/// One function without textures or tables that evaluates the coefficients as a polynomial of the unit normal:
/// zonal_irradiance(n), zonal_irradiance_over_pi(n) or zonal_radiance(n), after what it returns. A comment before it
/// states quantity, frame and units. 1 to 6 bands, N^2 constants; more would cancel in 32-bit floats. Throws
/// Error{kUsage} for more bands or a quantity that cannot be had (to_quantity), Error{kInput} for coefficients beyond
/// the floats.
std::string shader_text(const ShFile&, const ShaderOptions& = {});

}  // namespace zonal
