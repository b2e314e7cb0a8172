#pragma once

#include <array>
#include <cstdint>

namespace zonal {

/// A pixel of a Radiance file: three mantissas and the exponent they share.
using Rgbe = std::array<std::uint8_t, 4>;

/// The widths whose rows may be in the new run-length code, which states them in 15 bits.
inline constexpr int kMinRunWidth = 8;
inline constexpr int kMaxRunWidth = 0x7fff;

}  // namespace zonal
