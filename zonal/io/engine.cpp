#include "zonal/io/engine.h"

#include <array>

namespace zonal {
namespace {

constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

/// The matrix that brings a panorama's centre (our +X), right (-Y) and top (+Z) to these directions.
constexpr Rotation panorama_at(Vec3 centre, Vec3 right, Vec3 top) { return transpose({{centre, -right, top}}); }

constexpr Rotation kAsItIs = {};
constexpr Rotation kFlipX{{-kX, kY, kZ}}, kFlipZ{{kX, kY, -kZ}};

constexpr ShForm kPlainRadiance = {};
constexpr ShForm kPlainRadiance3 = {.max_bands = 3};
constexpr ShForm kPolynomial3 = {.quantity = ShQuantity::kIrradianceOverPi, .times_constants = true, .max_bands = 3};
constexpr std::array kPlayCanvasOrder = {0, 3, 1, 2, 7, 5, 4, 6, 8};  // 1, x, y, z, xz, yz, xy, 3z^2-1, x^2-y^2

constexpr EngineConvention kEngines[] = {
    {.name = "three",
     .source = "measured in three.js 0.187",
     .engine_from_world = panorama_at(kX, kZ, kY),
     .cube_from_engine = kFlipX,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kFilament,
     .sh = kPlainRadiance3},
    {.name = "filament",
     .source = "measured in filament.js 1.53; the panorama as cmgen places it, mirrored in X",
     .engine_from_world = panorama_at(kZ, -kX, kY),
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kFilament,
     .sh = kPolynomial3},
    {.name = "unity",
     .source = "read in its shaders; the placement of panoramas assumed",
     .engine_from_world = panorama_at(kX, -kZ, kY),
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kUnity,
     .sh = kPolynomial3},
    {.name = "unreal",
     .source = "roughness and basis read in its shaders; axes assumed",
     .engine_from_world = panorama_at(kX, kY, kZ),
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kUnreal,
     .sh = {.condon_shortley = true}},
    {.name = "godot",
     .source = "panoramas read in its sky shader; it prefilters itself and takes no coefficients",
     .engine_from_world = panorama_at(kZ, -kX, kY),
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kLinear,
     .sh = kPlainRadiance},
    {.name = "babylon",
     .source = "measured in Babylon.js 9.34, its default left-handed mode",
     .engine_from_world = panorama_at(kZ, kX, kY),
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kBabylon,
     .sh = {.quantity = ShQuantity::kIrradianceOverPi, .condon_shortley = true, .max_bands = 3}},
    {.name = "babylon-right-handed",
     .source = "measured in Babylon.js 9.34, its right-handed mode",
     .engine_from_world = panorama_at(-kZ, kX, kY),
     .cube_from_engine = kFlipZ,
     .sh_from_engine = kFlipZ,
     .roughness_map = RoughnessMap::kBabylon,
     .sh = {.quantity = ShQuantity::kIrradianceOverPi, .condon_shortley = true, .max_bands = 3}},
    {.name = "playcanvas",
     .source = "measured in PlayCanvas 2.23",
     .engine_from_world = panorama_at(kZ, -kX, kY),
     .cube_from_engine = kFlipX,
     .sh_from_engine = kFlipX,
     .roughness_map = RoughnessMap::kLinear,
     .sh = {.quantity = ShQuantity::kIrradianceOverPi,
            .times_constants = true,
            .order = kPlayCanvasOrder,
            .max_bands = 3}},
    {.name = "blender",
     .source = "the frame of this library; Cycles takes panoramas, not coefficients",
     .engine_from_world = kAsItIs,
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kLinear,
     .sh = kPlainRadiance},
    {.name = "gltf",
     .source = "EXT_lights_image_based and the Khronos sampler; readers differ by pi: this is the irradiance E",
     .engine_from_world = panorama_at(kX, kZ, kY),
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kLinear,
     .sh = {.quantity = ShQuantity::kIrradiance, .max_bands = 3}},
    {.name = "opengl",
     .source = "no engine: a right-handed world, +Y up, looking along -Z, lookups as they are",
     .engine_from_world = panorama_at(-kZ, kX, kY),
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kLinear,
     .sh = kPlainRadiance},
    {.name = "directx",
     .source = "no engine: a left-handed world, +Y up, looking along +Z, coefficients as DirectXMath has them",
     .engine_from_world = panorama_at(kZ, kX, kY),
     .cube_from_engine = kAsItIs,
     .sh_from_engine = kAsItIs,
     .roughness_map = RoughnessMap::kLinear,
     .sh = {.condon_shortley = true}},
};

}  // namespace

std::span<const EngineConvention> all_engines() { return kEngines; }

const EngineConvention* engine_named(std::string_view name) {
  for (const EngineConvention& engine : kEngines) {
    if (engine.name == name) return &engine;
  }
  return nullptr;
}

}  // namespace zonal
