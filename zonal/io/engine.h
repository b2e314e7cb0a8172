#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "zonal/io/roughness_map.h"
#include "zonal/io/sh_json.h"
#include "zonal/math/vec.h"

namespace zonal {

/// The form in which a program stores spherical-harmonic coefficients.
struct ShForm {
  ShQuantity quantity = ShQuantity::kRadiance;
  bool condon_shortley = false;
  /// Times the constants of the basis functions, so that the program evaluates bare polynomials 1, y, z, x, xy, yz,
  /// 3z^2-1, xz, x^2-y^2.
  bool times_constants = false;
  std::span<const int> order = {};  ///< order[i]: the index l(l+1)+m of stored number i; empty: that very order
  int max_bands = 0;                ///< 0: any
};

/// What one program takes for granted about the light it is given. Everything else in this library has one convention
/// (math/vec.h); this table is the only place that knows others.
struct EngineConvention {
  std::string_view name;
  std::string_view source;  ///< how we know: measured in the program, read in its source or documentation, or assumed
  /// World axes. A panorama's centre, right and top come to lie as the program's own loader of panoramas has them.
  /// Determinant -1 where the program is left-handed.
  Rotation engine_from_world;
  /// A prefiltered cube map is looked up in direction cube_from_engine * d, in the one sampler definition that OpenGL,
  /// Vulkan, Direct3D, KTX and our cube layouts share; the coefficients in direction sh_from_engine * n.
  Rotation cube_from_engine, sh_from_engine;
  RoughnessMap roughness_map = RoughnessMap::kLinear;
  ShForm sh;

  /// Turn the light by this before it is drawn into the cube map that the program is given.
  Rotation cube_from_world() const { return cube_from_engine * engine_from_world; }
  Rotation sh_from_world() const { return sh_from_engine * engine_from_world; }
};

/// three, filament, unity, unreal, godot, babylon, babylon-right-handed, playcanvas, blender, gltf, opengl, directx.
std::span<const EngineConvention> all_engines();
/// nullptr: no such name.
const EngineConvention* engine_named(std::string_view name);

/// The light turned, or mirrored, by an orthogonal matrix: what the result has at to_from * d the argument has at d. By
/// exact quadrature, O(bands^4): at most 32 bands, else Error{kUsage}.
Sh<RgbD> transformed(const Sh<RgbD>&, const Rotation& to_from);

/// The numbers to put into the program, in its order. Throws Error{kUsage} when the program takes fewer bands than
/// there are.
std::vector<RgbD> engine_coefficients(const ShFile&, const EngineConvention&);

/// And back: its quantity is the program's. Throws Error{kInput} when the number of coefficients is not that of whole
/// bands.
ShFile from_engine_coefficients(std::span<const RgbD>, const EngineConvention&);

}  // namespace zonal
