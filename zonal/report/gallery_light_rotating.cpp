#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "zonal/light/model.h"
#include "zonal/report/ball.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/picture_sheet.h"
#include "zonal/sh/ambient_cube.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/peaks.h"

namespace zonal {
namespace {

constexpr int kBands = 3, kSteps = 7, kStepDeg = 15, kSizePx = 176;

/// E/pi of a light whose true value is one on a surface that faces it.
Sh<RgbD> matte(double azimuth) {
  return irradiance_over_pi(directional_sh({std::cos(azimuth), std::sin(azimuth), 0}, {kPi, kPi, kPi}, kBands));
}

/// The greatest value of a cube: between its axes it is a mean of its sides.
double peak_of(const AmbientCube<RgbD>& cube) {
  double peak = 0;
  for (const RgbD& side : cube.sides) peak = std::max(peak, side.g);
  return peak;
}

}  // namespace

GalleryFigure rotating_light_figure() {
  PictureSheet sheet = {.name = "rotating-light",
                        .description =
                            "Two rows of seven matte balls under one directional light that turns from 0 to 90 "
                            "degrees. The balls of the upper row, by spherical harmonics, are all alike; those "
                            "of the lower row, by the ambient cube, change their shape and brightness.",
                        .rows = {{"Spherical harmonics, 3 bands", {}}, {"Ambient cube", {}}}};
  double sh_least = 1e9, sh_most = 0, cube_on_axis = 0, cube_between = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double azimuth = radians(i * kStepDeg);
    const Sh<RgbD> light = matte(azimuth);
    const AmbientCube<RgbD> cube = ambient_cube(light);
    const double sh_peak = find_peaks(luminance(light)).maxima[0].value, cube_peak = peak_of(cube);
    sh_least = std::min(sh_least, sh_peak);
    sh_most = std::max(sh_most, sh_peak);
    if (i == 0) cube_on_axis = cube_peak;
    if (i * kStepDeg == 45) cube_between = cube_peak;

    // The viewer goes round with the light, a little above it: where the basis does not matter nothing changes.
    const Rotation view = Rotation::about_z(azimuth - radians(40)) * Rotation::about_y(-radians(25));
    const auto scaled = [](Rgb c) { return (1 / 1.2f) * c; };  // the brightest of all is just below white
    const auto by_sh = seen(light, view);
    const BallOptions options = {.size_px = kSizePx};
    sheet.rows[0].cells.push_back(
        {displayed(draw_ball([&](Vec3 n) { return scaled(by_sh(n)); }, BallKind::kDiffuse, options)),
         fmt::format("{}°\npeak {:.2f}", i * kStepDeg, sh_peak)});
    sheet.rows[1].cells.push_back({displayed(draw_ball([&](Vec3 n) { return scaled(Rgb(evaluate(cube, view * n))); },
                                                       BallKind::kDiffuse, options)),
                                   fmt::format("peak {:.2f}", cube_peak)});
  }

  GalleryFigure figure;
  figure.id = sheet.name;
  figure.title = "A rotating light: spherical harmonics against the ambient cube";
  figure.source = "Sloan 2008, “Basic properties” (figure of two rows of balls) and appendix A9";
  figure.pictures = {{.name = sheet.name, .alt = sheet.description, .svg = picture_sheet(sheet)}};
  figure.caption =
      "A matte ball under one directional light of which a surface that faces it reflects 1 in truth. The light goes "
      "round the horizon and the viewer with it, so every change along a row is the basis’s own. Spherical harmonics "
      "turn with the light; the cube knows six sides and is bright where a side faces the light, dim and broad between "
      "two of them.";
  // The values of a zonal function of 3 bands about an axis, and its least-squares cube, by hand: sides toward a light
  // on the axis see all of band 1 (times 5/4) and of band 2, at 45 degrees 1/sqrt2 and 1/4 of them.
  figure.numbers = {
      {"Brightest of the spherical harmonics, any angle (17 of 16)", "1 + 1/16", sh_most, 17.0 / 16, 1e-12},
      {"Spread of that over the angles, greatest over least less one", "", sh_most / sh_least - 1, 0, 1e-12},
      {"Brightest of the ambient cube, light on an axis", "", cube_on_axis, (1 + 2.5 + 1.25) / 4, 1e-12},
      {"Brightest of the ambient cube, light at 45°", "", cube_between, (1 + 2.5 / std::sqrt(2.0) + 1.25 / 4) / 4,
       1e-12},
  };
  return figure;
}

}  // namespace zonal
