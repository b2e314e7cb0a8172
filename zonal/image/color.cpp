#include "zonal/image/color.h"

#include <algorithm>
#include <cmath>

namespace zonal {
namespace {

// IEC 61966-2-1, section 5: the straight part ends at kEncodedKnee; its slope is 1 / kSlope.
constexpr double kSlope = 12.92;
constexpr double kOffset = 0.055;
constexpr double kGamma = 2.4;
constexpr double kEncodedKnee = 0.04045;
// The standard rounds this to 0.0031308; computed from the other knee, both directions switch at the same place.
constexpr double kLinearKnee = kEncodedKnee / kSlope;

double decode(double encoded) {
  return encoded <= kEncodedKnee ? encoded / kSlope : std::pow((encoded + kOffset) / (1 + kOffset), kGamma);
}

double encode(double linear) {
  return linear <= kLinearKnee ? linear * kSlope : (1 + kOffset) * std::pow(linear, 1 / kGamma) - kOffset;
}

}  // namespace

float srgb_decode(float encoded) {
  return static_cast<float>(std::copysign(decode(std::abs(static_cast<double>(encoded))), encoded));
}

float srgb_encode(float linear) {
  return static_cast<float>(std::copysign(encode(std::abs(static_cast<double>(linear))), linear));
}

Rgb srgb_decode(Rgb encoded) { return {srgb_decode(encoded.r), srgb_decode(encoded.g), srgb_decode(encoded.b)}; }
Rgb srgb_encode(Rgb linear) { return {srgb_encode(linear.r), srgb_encode(linear.g), srgb_encode(linear.b)}; }

std::uint8_t srgb8(float linear) {
  if (!(linear > 0)) return 0;  // NaN too
  return static_cast<std::uint8_t>(std::lround(255 * encode(std::min(linear, 1.0f))));
}

}  // namespace zonal
