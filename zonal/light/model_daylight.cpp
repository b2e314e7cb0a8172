#include "zonal/light/model_daylight.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/light/model.h"
#include "zonal/light/model_argument.h"
#include "zonal/light/project.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr double kSunDiameterDeg = 0.533;  // of daylight_sky(); a test compares them

/// Large enough for what is the same all over the picture, or for a sum over it.
constexpr ImageSize kSmall = {64, 32};

Vec3 toward_sun(const DaylightOptions& options) {
  const double elevation = radians(options.elevation_deg), azimuth = radians(options.azimuth_deg);
  const double level = std::cos(elevation);
  return direction_of({level * std::cos(azimuth), level * std::sin(azimuth), std::sin(elevation)}, "the sun");
}

/// The integral of the sun's radiance over its disc: what it adds to the picture of a sky over black ground.
RgbD sun_irradiance(DaylightOptions options, const Run& run) {
  options.ground_albedo = {};
  options.sun = true;
  const Environment with = daylight_sky({}, kSmall, options, run);
  options.sun = false;
  const Environment without = daylight_sky({}, kSmall, options, run);
  const Mapping mapping({}, kSmall);
  RgbD sum;
  for (int y = 0; y < kSmall.height; ++y) {
    for (int x = 0; x < kSmall.width; ++x) {
      sum += mapping.solid_angle(x, y) * (RgbD(with.radiance(x, y)) - RgbD(without.radiance(x, y)));
    }
  }
  return sum;
}

}  // namespace

Sh<RgbD> clear_sky_sh(DaylightOptions options, int bands, int rows, const Run& run) {
  check(bands >= 1 && rows >= 2 * bands && rows % 2 == 0,
        "a sky needs a band, and for each two rows that meet at the horizon");
  toward_sun(options);  // refuses an azimuth that is none
  options.ground_albedo = {};
  options.sun = false;
  // Texels count with their centre's value, a midpoint rule: its error at the horizon, where the sky ends between two
  // rows, falls with the square of their height, so two heights tell what is left at none (Richardson 1911).
  const auto in_rows = [&](int n) { return project(daylight_sky({}, {2 * n, n}, options, run), bands, run); };
  const Sh<RgbD> coarse = in_rows(rows), fine = in_rows(2 * rows);
  return fine + (1.0 / 3) * (fine - coarse);
}

Sh<RgbD> daylight_sh(const DaylightOptions& options, int bands, const Run& run) {
  check(bands >= 1, "a sky needs at least one band");
  finite(RgbD(options.ground_albedo), "the albedo of the ground");
  Sh<RgbD> light = clear_sky_sh(options, bands, std::max(256, 4 * bands), run);
  const RgbD ground(
      daylight_sky({}, kSmall, options, run).radiance(0, kSmall.height - 1));  // the same everywhere below
  light += hemisphere_sh({0, 0, 1}, {}, ground, bands);
  if (options.sun) {
    const double radius = radians(kSunDiameterDeg) / 2, half_sine = std::sin(radius / 2);
    const RgbD radiance = (1 / (4 * kPi * half_sine * half_sine)) * sun_irradiance(options, run);
    light += cone_sh(toward_sun(options), radius, radiance, bands);
  }
  return light;
}

}  // namespace zonal
