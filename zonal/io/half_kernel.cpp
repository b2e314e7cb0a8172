#include "zonal/io/half_kernel.h"

// __builtin_bit_cast rather than std::bit_cast: an inline function of another header, compiled here for a newer
// instruction set, could be the copy that the linker keeps for everyone.
namespace zonal::ZONAL_ISA {
namespace {

// A float has 8 exponent bits with bias 127 and 23 fraction bits, a half 5 with bias 15 and 10.
constexpr std::uint32_t kDroppedBits = 23 - 10;
constexpr std::uint32_t kRebias = (127u - 15u) << 23;
constexpr std::uint32_t kFloatInfinity = 255u << 23;
constexpr std::uint32_t kSmallestNormalHalf = (127u - 14u) << 23;
constexpr std::uint32_t kHalfMaxBits = 0x7bff;
constexpr std::uint32_t kQuietNan = 0x7e00;
// 65520 lies halfway between the largest half and the next power of two: from here on rounding would give infinity.
constexpr std::uint32_t kFirstOverflow = __builtin_bit_cast(std::uint32_t, 65520.0f);

// All cases are computed and one is chosen without a branch, so that the loop vectorises.
std::size_t halves_from_floats(const float* in, std::uint16_t* out, std::size_t count) {
  std::size_t clipped = 0;
  constexpr std::size_t kRun = 4096;  // a run's count fits the vector lanes of 32 bits
  for (std::size_t begin = 0; begin < count; begin += kRun) {
    const std::size_t end = begin + kRun < count ? begin + kRun : count;
    std::uint32_t clipped_here = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t bits = __builtin_bit_cast(std::uint32_t, in[i]);
      const std::uint32_t magnitude = bits & 0x7fffffffu;
      const std::uint32_t sign = (bits >> 16) & 0x8000u;
      // Half an ulp less one, plus the kept bit that decides a tie; a carry runs into the exponent as it should.
      const std::uint32_t tie = (magnitude >> kDroppedBits) & 1u;
      const std::uint32_t normal = (magnitude - kRebias + ((1u << (kDroppedBits - 1)) - 1) + tie) >> kDroppedBits;
      // One ulp of 0.5f is the quantum of denormal halves, so that the addition rounds for us, ties to even.
      const float shifted = __builtin_bit_cast(float, magnitude) + 0.5f;
      const std::uint32_t denormal =
          __builtin_bit_cast(std::uint32_t, shifted) - __builtin_bit_cast(std::uint32_t, 0.5f);
      const std::uint32_t nan = kQuietNan | ((magnitude >> kDroppedBits) & 0x3ffu);

      const std::uint32_t is_nan = magnitude > kFloatInfinity;
      const std::uint32_t too_large = magnitude >= kFirstOverflow;
      std::uint32_t half = magnitude < kSmallestNormalHalf ? denormal : normal;
      half = too_large ? kHalfMaxBits : half;
      half = is_nan ? nan : half;
      out[i] = static_cast<std::uint16_t>(sign | half);
      clipped_here += too_large & ~is_nan;
    }
    clipped += clipped_here;
  }
  return clipped;
}

void floats_from_halves(const std::uint16_t* in, float* out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t half = in[i];
    const std::uint32_t sign = (half & 0x8000u) << 16;
    const std::uint32_t magnitude = (half & 0x7fffu) << kDroppedBits;
    // Rebiasing a denormal as if it were normal adds an implicit one that the subtraction takes off again.
    const float denormal =
        __builtin_bit_cast(float, magnitude + kSmallestNormalHalf) - __builtin_bit_cast(float, kSmallestNormalHalf);
    const std::uint32_t infinite_or_nan = magnitude >= (31u << 23) ? kRebias : 0u;
    const std::uint32_t normal = magnitude + kRebias + infinite_or_nan;
    const std::uint32_t bits = magnitude < (1u << 23) ? __builtin_bit_cast(std::uint32_t, denormal) : normal;
    out[i] = __builtin_bit_cast(float, sign | bits);
  }
}

}  // namespace

const HalfKernels kHalfKernels = {halves_from_floats, floats_from_halves};

}  // namespace zonal::ZONAL_ISA
