#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zonal/base/cpu.h"
#include "zonal/math/vec.h"

namespace zonal {

/// The largest finite IEEE 754 binary16 number.
inline constexpr float kHalfMax = 65504.0f;

/// Rounds to the nearest half, ties to even, denormals included. Magnitudes that would round to infinity, and infinity
/// itself, become +-65504 and are counted: the number clipped is returned, so that a caller can report it. NaN stays
/// NaN. `out` is as long as `in`. Every instruction set gives the same bits.
[[nodiscard]] std::size_t halves_from_floats(std::span<const float> in, std::span<std::uint16_t> out,
                                             Isa isa = best_isa());

/// The same for texels, with alpha 1: out[4 i .. 4 i + 3] is r, g, b, 1. Returns the number of texels with a clipped
/// channel.
[[nodiscard]] std::size_t rgba_halves_from_rgb(std::span<const Rgb> in, std::span<std::uint16_t> out,
                                               Isa isa = best_isa());

/// Exact: every half is a float.
void floats_from_halves(std::span<const std::uint16_t> in, std::span<float> out, Isa isa = best_isa());

}  // namespace zonal
