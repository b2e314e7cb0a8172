#pragma once

#include <cstdint>

#include "zonal/math/vec.h"

namespace zonal {

/// The largest number that a channel of rgb9e5() can hold: 511/512 * 2^16.
inline constexpr float kRgb9e5Max = 65408.0f;

/// A colour in 32 bits: nine bits for each channel, red lowest, and a power of two that they share (the texture format
/// GL_RGB9_E5; OpenGL 3.0 specification, 3.8.2). Each channel is within max_channel / 512 of what it was, or within
/// 2^-25 for colours that are darker than the smallest power of two. Negative channels and NaN become 0, what is
/// above kRgb9e5Max becomes that.
std::uint32_t rgb9e5(const Rgb&);

/// Exact: what a graphics card reads.
Rgb rgb_from_rgb9e5(std::uint32_t packed);

}  // namespace zonal
