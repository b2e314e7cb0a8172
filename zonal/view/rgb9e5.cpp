#include "zonal/view/rgb9e5.h"

#include <algorithm>
#include <cmath>

namespace zonal {
namespace {

constexpr int kBits = 9, kBias = 15;
constexpr std::uint32_t kMask = (1u << kBits) - 1;

}  // namespace

std::uint32_t rgb9e5(const Rgb& color) {
  // NaN compares false with everything and is 0 therefore.
  const auto held = [](float c) { return c > 0 ? std::min(c, kRgb9e5Max) : 0.0f; };
  const float r = held(color.r), g = held(color.g), b = held(color.b), most = std::max({r, g, b});
  int exponent = most > 0 ? std::max(0, std::ilogb(most) + 1 + kBias) : 0;
  const auto steps = [&](float c) {
    return static_cast<std::uint32_t>(std::ldexp(c, kBits + kBias - exponent) + 0.5f);
  };
  if (steps(most) > kMask) ++exponent;  // rounded up to the next power of two
  return steps(r) | steps(g) << kBits | steps(b) << 2 * kBits | static_cast<std::uint32_t>(exponent) << 3 * kBits;
}

Rgb rgb_from_rgb9e5(std::uint32_t packed) {
  const int exponent = static_cast<int>(packed >> 3 * kBits) - kBias - kBits;
  const auto channel = [&](int place) {
    return std::ldexp(static_cast<float>(packed >> place * kBits & kMask), exponent);
  };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace zonal
