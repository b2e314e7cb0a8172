#pragma once

#include <optional>
#include <string>

#include "zonal/io/engine.h"
#include "zonal/io/shader.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace zonal {

// The choices that verbs on coefficients share.

/// radiance, irradiance or irradiance/pi.
CLI::Option* add_quantity_choice(CLI::App&, const std::string& option, std::optional<ShQuantity>&,
                                 const std::string& help);
/// glsl, hlsl, msl, wgsl or cpp.
CLI::Option* add_language_choice(CLI::App&, const std::string& option, std::optional<ShaderLanguage>&,
                                 const std::string& help);
/// --to ENGINE.
void add_engine_choice(CLI::App&, const EngineConvention*&, const std::string& help, const std::string& group);

/// The axes of an engine's world in words, for the comments of shaders.
std::string shader_frame_of(const EngineConvention&);
/// A shader function, in the axes of an engine where there is one.
std::string shader_in_axes_of(const EngineConvention* engine, ShFile, ShaderLanguage, ShQuantity returns);

}  // namespace zonal
