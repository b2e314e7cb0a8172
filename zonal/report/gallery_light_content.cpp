#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/light/lobe.h"
#include "zonal/report/ball.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/picture_sheet.h"
#include "zonal/sh/minimum.h"
#include "zonal/sh/window.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

constexpr int kSizePx = 288;
constexpr double kPower = 10;      // of the paper's ball
constexpr double kBright = 4;      // of the highlight where it is exact: it saturates
constexpr float kAmbient = 0.06f;  // so that what is below it shows

/// The highlight of a directional light by the angle between light and reflection, relative to the exact one's height.
std::vector<double> highlight(const Window& window) {
  std::vector<double> factors = band_factors(Lobe::phong(kPower), kGalleryBands);
  const double height = (kPower + 1) / (2 * kPi);
  for (int l = 0; l < kGalleryBands; ++l) factors[static_cast<std::size_t>(l)] *= window_factor(window, l) / height;
  return zonal_from_factors(factors);
}

double deepest(const std::vector<double>& zonal) {
  return certified_minimum(zonal_toward(zonal, {0, 0, 1}), {.tolerance = 1e-10}).found;
}

/// The least value of a function of the cosine among many: right to the square of their distance, 1e-10.
template <class Function>
double least_of_many(Function&& value) {
  double low = 0;
  for (int i = 0; i <= 200000; ++i) low = std::min(low, value(-1 + 1e-5 * i));
  return low;
}

}  // namespace

GalleryFigure content_window_figure() {
  const Vec3 toward = normalize({0.3, 0.64, 0.71});  // seen in the upper right of the ball
  const Window hann = Window::hann(kGalleryBands);
  const std::vector<double> plain = highlight(Window::none()), windowed = highlight(hann);
  const auto weight = [&](double c) {
    return unwindowed_weight({0, 0, 1}, {std::sqrt(std::max(0.0, 1 - c * c)), 0, c});
  };
  const auto by_content = [&](double c) {
    const double w = weight(c);
    return w * evaluate_zonal(plain, c) + (1 - w) * evaluate_zonal(windowed, c);
  };

  const auto ball = [&](const auto& value, double brightness, float ambient) {
    return displayed(draw_ball(
        [&](Vec3 reflected) {
          const auto light =
              static_cast<float>(brightness * value(std::clamp(dot(toward, reflected), -1.0, 1.0))) + ambient;
          return Rgb{light, light, light};
        },
        BallKind::kMirror, {.size_px = kSizePx, .supersample = 2}));
  };
  const auto of_zonal = [](const std::vector<double>& zonal) {
    return [&](double c) { return evaluate_zonal(zonal, c); };
  };
  const PictureSheet sheet = {
      .name = "content-window",
      .description =
          "Four glossy balls under one bright light: without a window the highlight is small and rings "
          "surround it; with a window the rings are gone and the highlight is broad; blended by the angle to "
          "the light the highlight is small and there are no rings; and the weights of that blend.",
      .columns = {"no window", "windowed", "by content", "weight of no window"},
      .rows = {{"",
                {{ball(of_zonal(plain), kBright, kAmbient)},
                 {ball(of_zonal(windowed), kBright, kAmbient)},
                 {ball(by_content, kBright, kAmbient)},
                 {ball(weight, 1, 0)}}}}};

  GalleryFigure figure;
  figure.id = sheet.name;
  figure.title = "Content-dependent windowing on a glossy ball";
  figure.source = "Sloan 2008, “Content-dependent windowing” (figure of a row of glossy balls)";
  figure.pictures = {{.name = sheet.name, .alt = sheet.description, .svg = picture_sheet(sheet)}};
  figure.caption = fmt::format(
      "Phong’s lobe of power {} in 6 bands under one directional light, whose exact highlight would be {} times white, "
      "and a dim ambient light. The window is Hann’s of width 6. The third ball takes the function without window "
      "with weight w, the windowed one with 1 − w; w = max(0, (d·r − 0.07)/0.93)^0.8 for the light’s direction d and "
      "the reflection r. Heights below are relative to the exact highlight’s.",
      kPower, kBright);
  const ContentWindow defaults;
  const double middle = defaults.threshold + 0.5 * (1 - defaults.threshold);
  // The factors of power 10 by hand: 1, 11/12, 10/13, 33/56, 16/39, 33/128; bands weigh 2l + 1.
  const double sum_of_bands = 1 + 33.0 / 12 + 50.0 / 13 + 7 * 33.0 / 56 + 9 * 16.0 / 39 + 11 * 33.0 / 128;
  figure.numbers = {
      {"Threshold c_t", "0.07", defaults.threshold, 0.07, 0},
      {"Power p", "0.8", defaults.power, 0.8, 0},
      {"Weight halfway between the threshold and the light", "", weight(middle), std::pow(0.5, 0.8), 1e-14},
      {"Highlight, no window", "", evaluate_zonal(plain, 1), sum_of_bands / 22, 1e-12},
      {"Highlight, by content: that of no window", "", by_content(1), sum_of_bands / 22, 1e-12},
      {"Highlight, windowed", "", evaluate_zonal(windowed, 1),
       // Hann of width 6: (1 + cos(pi l/6))/2.
       (1 + 33.0 / 12 * (2 + std::sqrt(3.0)) / 4 + 50.0 / 13 * 0.75 + 7 * 33.0 / 56 * 0.5 + 9 * 16.0 / 39 * 0.25 +
        11 * 33.0 / 128 * (2 - std::sqrt(3.0)) / 4) /
           22,
       1e-12},
      {"Deepest ring, no window", "", deepest(plain), least_of_many(of_zonal(plain)), 1e-9},
      {"Deepest ring, windowed", "", deepest(windowed), least_of_many(of_zonal(windowed)), 1e-9},
      {"Deepest ring, by content: that of the window", "", least_of_many(by_content), deepest(windowed), 1e-9},
  };
  return figure;
}

}  // namespace zonal
