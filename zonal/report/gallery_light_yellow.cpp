#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/light/model.h"
#include "zonal/report/ball.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/picture_sheet.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/minimum.h"
#include "zonal/sh/window.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

constexpr int kSizePx = 288;
constexpr RgbD kYellow = {2.4, 2.4, 0},
               kAmbient = {0.15, 0.15, 0.15};  // radiance of a white surface that faces the light

/// A matte surface's answer to a light of which it reflects one when it faces it, by the angle between them: zonal.
std::vector<double> answer(int bands, const Window& window) {
  std::vector<double> zonal = delta_zonal(bands);
  const std::vector<double> cosine = cosine_factors(bands);
  for (int l = 0; l < bands; ++l) {
    zonal[static_cast<std::size_t>(l)] *= kPi * cosine[static_cast<std::size_t>(l)] * window_factor(window, l);
  }
  return zonal;
}

/// The least of it, with a proof.
double least(const std::vector<double>& zonal) {
  return certified_minimum(zonal_toward(zonal, {0, 0, 1}), {.tolerance = 1e-10}).found;
}

/// The least of it among many angles: right to the square of their distance, 1e-10.
double least_of_many(const std::vector<double>& zonal) {
  double low = 0;
  for (int i = 0; i <= 200000; ++i) low = std::min(low, evaluate_zonal(zonal, -1 + 1e-5 * i));
  return low;
}

/// The least of 1/4 + a c + b (3c^2 - 1), its vertex being inside [-1, 1].
double vertex(double a, double b) { return 0.25 - b - a * a / (12 * b); }

}  // namespace

GalleryFigure yellow_light_figure() {
  // From the upper right, a little behind the ball.
  const Vec3 toward = normalize({-0.5, 0.68, 0.54});
  const auto ball = [&](const std::vector<double>& zonal) {
    Sh<RgbD> light = kYellow * zonal_toward(zonal, toward);
    light += ambient_sh(kAmbient, light.bands());
    return displayed(draw_ball(seen(light), BallKind::kDiffuse, {.size_px = kSizePx}));
  };
  const auto exact = [&](Vec3 normal) { return Rgb(kAmbient + std::max(0.0, dot(normal, toward)) * kYellow); };

  const std::vector<double> plain3 = answer(3, Window::none()), hann3 = answer(3, Window::hann(4));
  const std::vector<double> plain6 = answer(6, Window::none()), hann6 = answer(6, Window::hann(5));
  const Image<Rgb8> truth = displayed(draw_ball(exact, BallKind::kDiffuse, {.size_px = kSizePx, .supersample = 2}));
  const PictureSheet sheet = {
      .name = "yellow-light",
      .description =
          "A white matte ball under white ambient light and a yellow light from beyond its upper right edge. "
          "Without a window a blue band lies along the shadow’s edge; with one it is fainter.",
      .columns = {"no window", "Hann window", "in truth"},
      .rows = {{"Irradiance map, 3 bands", {{ball(plain3)}, {ball(hann3), "width 4"}, {truth}}},
               {"Cosine in 6 bands", {{ball(plain6)}, {ball(hann6), "width 5"}}}}};

  GalleryFigure figure;
  figure.id = sheet.name;
  figure.title = "Ringing in colour: a yellow light leaves a blue rim";
  figure.source = "Sloan 2008, “Windowing” (figure of a ball lit by a yellow light)";
  figure.pictures = {{.name = sheet.name, .alt = sheet.description, .svg = picture_sheet(sheet)}};
  figure.caption =
      "A white ball, a yellow light of which a surface facing it reflects 2.4, and white ambient light of 0.15. Where "
      "the light’s ringing is negative it takes red and green from the ambient light and leaves the blue. Opposite "
      "the light 3 bands add a yellow lobe; 6 bands take away. The depths below are those of a light of which 1 is "
      "reflected.";
  const auto opposite = [](const std::vector<double>& zonal) {
    return evaluate_zonal(zonal, -1) / evaluate_zonal(zonal, 1);
  };
  const Window hann4 = Window::hann(4);
  figure.numbers = {
      {"Opposite the light over facing it, 3 bands", "1 : 17", opposite(plain3), 1.0 / 17, 1e-14},
      {"Opposite the light over facing it, 6 bands", "−1 : 31", opposite(plain6), -1.0 / 31, 1e-14},
      {"Deepest, 3 bands, no window (at c = −8/15)", "", least(plain3), -19.0 / 480, 1e-9},
      {"Deepest, 3 bands, Hann 4", "", least(hann3),
       vertex(0.5 * window_factor(hann4, 1), 5.0 / 32 * window_factor(hann4, 2)), 1e-9},
      {"Deepest, 6 bands, no window", "", least(plain6), least_of_many(plain6), 1e-9},
      {"Deepest, 6 bands, Hann 5", "", least(hann6), least_of_many(hann6), 1e-9},
  };
  return figure;
}

}  // namespace zonal
