#include "zonal/io/half.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "zonal/base/check.h"
#include "zonal/io/half_kernel.h"

namespace zonal {
namespace {

static_assert(sizeof(Rgb) == 3 * sizeof(float), "texels are read as a run of floats");
static_assert(std::endian::native == std::endian::little, "four halves are packed into one little-endian word");

constexpr std::size_t kTexelsAtOnce = 1024;  // 3 channels of halves: 6 kB, stays in the first cache
constexpr std::uint64_t kColorBits = 0x0000'ffff'ffff'ffff;
constexpr std::uint64_t kAlphaOne = 0x3c00ull << 48;

bool is_clipped(float value) { return std::abs(value) >= kHalfMax + 16; }  // 16: half of the last ulp; false for NaN

}  // namespace

std::size_t halves_from_floats(std::span<const float> in, std::span<std::uint16_t> out, Isa isa) {
  check(in.size() == out.size(), "halves_from_floats: the spans differ in length");
  return half_kernels(isa).halves_from_floats(in.data(), out.data(), in.size());
}

void floats_from_halves(std::span<const std::uint16_t> in, std::span<float> out, Isa isa) {
  check(in.size() == out.size(), "floats_from_halves: the spans differ in length");
  return half_kernels(isa).floats_from_halves(in.data(), out.data(), in.size());
}

std::size_t rgba_halves_from_rgb(std::span<const Rgb> in, std::span<std::uint16_t> out, Isa isa) {
  check(out.size() == 4 * in.size(), "rgba_halves_from_rgb: out must hold four channels a texel");
  std::array<std::uint16_t, 3 * kTexelsAtOnce + 1> colors;  // one more: each texel is read as four halves
  colors.back() = 0;
  std::size_t clipped_texels = 0;
  for (std::size_t begin = 0; begin < in.size(); begin += kTexelsAtOnce) {
    const std::span<const Rgb> texels = in.subspan(begin, std::min(kTexelsAtOnce, in.size() - begin));
    const std::span<const float> channels(&texels[0].r, 3 * texels.size());
    if (halves_from_floats(channels, std::span(colors).first(channels.size()), isa) > 0) {
      clipped_texels += static_cast<std::size_t>(
          std::ranges::count_if(texels, [](Rgb t) { return is_clipped(t.r) || is_clipped(t.g) || is_clipped(t.b); }));
    }
    for (std::size_t i = 0; i < texels.size(); ++i) {
      std::uint64_t texel;
      std::memcpy(&texel, &colors[3 * i], sizeof texel);
      texel = (texel & kColorBits) | kAlphaOne;
      std::memcpy(&out[4 * (begin + i)], &texel, sizeof texel);
    }
  }
  return clipped_texels;
}

}  // namespace zonal
