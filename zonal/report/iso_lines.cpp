#include "zonal/report/iso_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "zonal/base/check.h"

namespace zonal {
namespace {

/// A colour as the display's own codes, 0..255.
using Code = std::array<double, 3>;

// White lines must show on all of them.
constexpr Code kZero = {28, 122, 62}, kMiddle = {196, 150, 18}, kHigh = {178, 24, 18};
constexpr Code kBelowZero = {84, 134, 246}, kLow = {8, 18, 110};
constexpr Code kUnknown = {128, 128, 128};
constexpr double kLineWidthPx = 1.5, kMostWhite = 0.85;

Code mix(const Code& a, const Code& b, double t) {
  Code c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = a[i] + t * (b[i] - a[i]);
  return c;
}

Code color(double value, double limit) {
  if (std::isnan(value)) return kUnknown;
  const double t = limit > 0 ? std::clamp(value / limit, -1.0, 1.0) : 0;
  if (value < 0) return mix(kBelowZero, kLow, -t);
  return t < 0.5 ? mix(kZero, kMiddle, 2 * t) : mix(kMiddle, kHigh, 2 * t - 1);
}

Rgb8 encoded(const Code& c) {
  const auto code = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
  return {code(c[0]), code(c[1]), code(c[2])};
}

/// How much of a pixel a line covers: from the distance to the nearest level, in pixels, by the slope there.
double coverage(const Image<double>& values, int x, int y, double step) {
  const auto at = [&](int i, int j) {
    return values(std::clamp(i, 0, values.width() - 1), std::clamp(j, 0, values.height() - 1));
  };
  const double value = at(x, y), slope = 0.5 * std::hypot(at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1));
  const double distance = std::abs(value - step * std::round(value / step));
  if (!(slope > 1e-6 * step)) return 0;  // level ground has no lines
  return std::clamp((kLineWidthPx + 1) / 2 - distance / slope, 0.0, 1.0);
}

}  // namespace

Rgb8 iso_color(double value, const IsoScale& scale) { return encoded(color(value, scale.limit)); }

Image<Rgb8> iso_lines(const Image<double>& values, const IsoScale& scale) {
  check(scale.limit >= 0 && scale.step >= 0, "a scale of iso-lines must not be negative");
  Image<Rgb8> picture(values.width(), values.height());
  for (int y = 0; y < values.height(); ++y) {
    for (int x = 0; x < values.width(); ++x) {
      const double white = scale.step > 0 ? kMostWhite * coverage(values, x, y, scale.step) : 0;
      picture(x, y) = encoded(mix(color(values(x, y), scale.limit), {255, 255, 255}, white));
    }
  }
  return picture;
}

Image<Rgb8> iso_key(const IsoScale& scale, int width_px, int height_px) {
  check(width_px > 0 && height_px > 0, "a key needs a positive size");
  Image<double> ramp(width_px, height_px);
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) ramp(x, y) = scale.limit * (2 * (x + 0.5) / width_px - 1);
  }
  return iso_lines(ramp, scale);
}

}  // namespace zonal
