#include "zonal/light/model.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/light/model_argument.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

void check_bands(int bands) { check(bands >= 1, "a light needs at least one band"); }

double clamped_asin(double sine) { return std::asin(std::clamp(sine, -1.0, 1.0)); }
double clamped_sqrt(double square) { return std::sqrt(std::max(square, 0.0)); }

/// A cone of at most pi/2, partly below the horizon: pi/2 - half_angle < from_normal < pi/2 + half_angle.
double clipped_irradiance(double half_angle, double from_normal) {
  const double cos_w = std::cos(from_normal), sin_w = std::sin(from_normal);
  const double cos_s = std::cos(half_angle), sin_s = std::sin(half_angle);
  const double g = clamped_asin(cos_s / sin_w), sin_g = std::sin(g), cos_g = std::cos(g);
  const double lune = -2 * sin_w * cos_s * cos_g + kPi / 2 - g + sin_g * cos_g;
  const double cap =
      cos_w * (cos_g * clamped_sqrt(sin_s * sin_s - cos_g * cos_g) + sin_s * sin_s * clamped_asin(cos_g / sin_s));
  return from_normal <= kPi / 2 ? kPi * cos_w * sin_s * sin_s + lune - cap : lune + cap;
}

}  // namespace

Sh<RgbD> directional_sh(Vec3 toward_light, RgbD irradiance, int bands) {
  check_bands(bands);
  return finite(irradiance, "the irradiance") *
         zonal_toward(delta_zonal(bands), direction_of(toward_light, "the way toward the light"));
}

Sh<RgbD> ambient_sh(RgbD radiance, int bands) {
  check_bands(bands);
  Sh<RgbD> sh(bands);
  sh(0, 0) = constant_zonal(1)[0] * finite(radiance, "the radiance");
  return sh;
}

Sh<RgbD> hemisphere_sh(Vec3 up, RgbD sky, RgbD ground, int bands) {
  const RgbD step = finite(sky, "the sky's radiance") - finite(ground, "the ground's radiance");
  return ambient_sh(ground, bands) + step * zonal_toward(upper_half_zonal(bands), direction_of(up, "the way up"));
}

Sh<RgbD> cone_sh(Vec3 toward_light, double half_angle, RgbD radiance, int bands) {
  check_bands(bands);
  return finite(radiance, "the radiance") *
         zonal_toward(cone_zonal(half_angle, bands), direction_of(toward_light, "the way toward the light"));
}

Sh<RgbD> smooth_cone_sh(Vec3 toward_light, double half_angle, RgbD radiance, int bands) {
  check_bands(bands);
  return finite(radiance, "the radiance") *
         zonal_toward(smooth_cone_zonal(half_angle, bands), direction_of(toward_light, "the way toward the light"));
}

Sh<RgbD> sphere_sh(Vec3 to_center, double radius, RgbD radiance, int bands) {
  const double half_angle = sphere_half_angle(radius, std::hypot(to_center.x, to_center.y, to_center.z));
  if (half_angle == kPi) return ambient_sh(radiance, bands);  // its centre may be where we are
  return cone_sh(to_center, half_angle, radiance, bands);
}

double cone_irradiance(double half_angle, double from_normal) {
  if (!(half_angle >= 0 && half_angle <= kPi && from_normal >= 0 && from_normal <= kPi)) {
    throw Error(ErrorKind::kUsage, "the half angle of a light and its angle to a normal must lie in [0, pi]");
  }
  // A wide cone is everything but the opposite narrow one.
  if (half_angle > kPi / 2) return kPi - cone_irradiance(kPi - half_angle, kPi - from_normal);
  if (from_normal >= kPi / 2 + half_angle) return 0;
  const double sine = std::sin(half_angle);
  if (from_normal + half_angle <= kPi / 2) return kPi * sine * sine * std::cos(from_normal);
  return clipped_irradiance(half_angle, from_normal);
}

}  // namespace zonal
