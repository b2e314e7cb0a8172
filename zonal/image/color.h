#pragma once

#include <cstdint>

#include "zonal/math/vec.h"

namespace zonal {

/// The sRGB transfer curve of IEC 61966-2-1, exact in both directions: encoded value 0..1 to linear and back.
/// Odd-symmetric for negative values and continued above 1, so that a round trip returns what went in.
float srgb_decode(float encoded);
float srgb_encode(float linear);
Rgb srgb_decode(Rgb encoded);
Rgb srgb_encode(Rgb linear);

/// Linear to the nearest 8-bit code, clamped to 0..255; NaN becomes 0. srgb8(srgb_decode(i / 255)) == i for every i.
std::uint8_t srgb8(float linear);

}  // namespace zonal
