#include "zonal/image/tonemap.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "zonal/base/check.h"
#include "zonal/image/color.h"

namespace zonal {
namespace {

/// Moves a colour toward the grey of its luminance (0..1) until no channel exceeds 1.
RgbD fit_display(RgbD c) {
  const double grey = std::min(1.0, luminance(c));
  const double highest = max_channel(c);
  if (highest <= 1) return c;
  const double keep = highest > grey ? (1 - grey) / (highest - grey) : 0;
  return {grey + keep * (c.r - grey), grey + keep * (c.g - grey), grey + keep * (c.b - grey)};
}

Rgb8 encode(RgbD c) {
  return {srgb8(static_cast<float>(c.r)), srgb8(static_cast<float>(c.g)), srgb8(static_cast<float>(c.b))};
}

/// Relative luminance of a CIE lightness L* in 0..100 (CIE 15:2004, eq. 8.4 inverted).
double luminance_of_lightness(double lightness) {
  const double f = (lightness + 16) / 116;
  return f > 6.0 / 29 ? f * f * f : 3 * (6.0 / 29) * (6.0 / 29) * (f - 4.0 / 29);
}

double positive(double value) { return value > 0 ? std::min(value, 1e30) : 0; }  // NaN too becomes 0

}  // namespace

Rgb8 tonemap(Rgb radiance, const Tonemap& how) {
  check(how.white > 0, "the white of a tone curve must be positive");
  const double exposure = std::exp2(how.exposure_ev);
  const RgbD c = {positive(exposure * radiance.r), positive(exposure * radiance.g), positive(exposure * radiance.b)};
  const double light = luminance(c);
  if (light <= 0) return {};
  const double shown = std::min(1.0, light * (1 + light / (how.white * how.white)) / (1 + light));
  return encode(fit_display((shown / light) * c));
}

Image<Rgb8> tonemap(const Image<Rgb>& radiance, const Tonemap& how) {
  Image<Rgb8> picture(radiance.width(), radiance.height());
  std::transform(radiance.values().begin(), radiance.values().end(), picture.values().begin(),
                 [&](Rgb c) { return tonemap(c, how); });
  return picture;
}

double auto_exposure_ev(const Image<Rgb>& radiance) {
  double sum = 0;
  std::size_t count = 0;
  for (const Rgb& c : radiance.values()) {
    const double light = luminance(RgbD(c));
    if (!(light > 0) || !std::isfinite(light)) continue;
    sum += std::log2(light);
    ++count;
  }
  return count == 0 ? 0 : std::log2(0.18) - sum / static_cast<double>(count);
}

Rgb8 false_color(double value) {
  if (std::isnan(value)) return {255, 0, 255};
  // Hues to pass through, linear. Their own luminance does not matter: the value sets it.
  static constexpr RgbD kHues[] = {{0, 0.02, 1}, {0.25, 0, 1}, {1, 0, 0.35}, {1, 0.12, 0}, {1, 0.55, 0}, {1, 1, 1}};
  value = std::clamp(value, 0.0, 1.0);
  constexpr int kSteps = static_cast<int>(std::size(kHues)) - 1;
  const int step = std::min(kSteps - 1, static_cast<int>(value * kSteps));
  const double part = value * kSteps - step;
  const RgbD hue = (1 - part) * kHues[step] + part * kHues[step + 1];
  return encode(fit_display((luminance_of_lightness(100 * value) / luminance(hue)) * hue));
}

Image<Rgb8> false_color(const Image<float>& values, double full_scale) {
  check(full_scale > 0, "the full scale of a false-colour picture must be positive");
  Image<Rgb8> picture(values.width(), values.height());
  std::transform(values.values().begin(), values.values().end(), picture.values().begin(),
                 [&](float value) { return false_color(value / full_scale); });
  return picture;
}

}  // namespace zonal
