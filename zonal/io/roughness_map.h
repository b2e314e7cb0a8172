#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace zonal {

/// Which level of a prefiltered chain a renderer reads for a perceptual roughness r (alpha = r^2), with L = levels - 1:
enum class RoughnessMap {
  kLinear,    ///< L r (Khronos glTF viewer, glTF extension EXT_lights_image_based)
  kFilament,  ///< L r (2 - r) (Filament; three.js for a ready-made chain)
  kUnity,     ///< L r (1.7 - 0.7 r) (Unity's built-in pipeline, which has L = 6)
  kUnreal,    ///< L - 1 + 1.2 log2 r: the last level but one is r = 1, and level 0 is not r = 0
  kBabylon,   ///< 0.8 (L + 2 log2 r) of a full chain down to one texel: level 0 is not r = 0
};

std::string_view name_of(RoughnessMap);  // "linear", "filament", "unity", "unreal", "babylon"
std::optional<RoughnessMap> roughness_map_named(std::string_view name);
std::span<const RoughnessMap> all_roughness_maps();

/// The level, between levels where it is not whole, for a roughness in [0, 1]; never outside [0, levels - 1]. levels
/// >= 1.
double level_of_roughness(RoughnessMap, double roughness, int levels);

/// The roughness a level has to be prefiltered for, at most 1; level in [0, levels - 1], need not be whole. The inverse
/// of level_of_roughness where that is neither held at 0 nor this at 1. With one level only: 0.
double roughness_of_level(RoughnessMap, double level, int levels);

}  // namespace zonal
