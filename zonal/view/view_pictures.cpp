#include "zonal/view/view_pictures.h"

#include <array>
#include <cmath>
#include <optional>

#include "zonal/light/resample.h"
#include "zonal/light/sample.h"
#include "zonal/sh/window.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

/// Fills the texels that a picture shows nothing in with the light from the direction that `toward` gives them.
template <class Toward>
Image<Rgb> filled(const Environment& source, const Projection& to, int size_px, const Run& run, Toward toward) {
  Environment picture = resample(source, to, size_px, {}, run);
  Image<Rgb>& texels = picture.radiance;
  const Mapping mapping(to, {texels.width(), texels.height()});
  const Sampler sample(source);
  for (int y = 0; y < texels.height(); ++y) {
    for (int x = 0; x < texels.width(); ++x) {
      if (!mapping.texel_direction(x, y)) texels(x, y) = sample(toward(x + 0.5, y + 0.5));
    }
  }
  return std::move(texels);
}

Rgb mean(const Image<Rgb>& image, int x, int y, int columns, int rows) {
  RgbD sum;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) sum += RgbD(image(x + i, y + j));
  }
  return Rgb((1.0 / (columns * rows)) * sum);
}

}  // namespace

std::vector<Image<Rgb>> halved_pictures(Image<Rgb> image) {
  std::vector<Image<Rgb>> levels = {std::move(image)};
  while (levels.back().width() > 1 || levels.back().height() > 1) {
    const Image<Rgb>& last = levels.back();
    const int columns = last.width() > 1 ? 2 : 1, rows = last.height() > 1 ? 2 : 1;
    Image<Rgb> half(last.width() / columns, last.height() / rows);
    for (int y = 0; y < half.height(); ++y) {
      for (int x = 0; x < half.width(); ++x) half(x, y) = mean(last, columns * x, rows * y, columns, rows);
    }
    levels.push_back(std::move(half));
  }
  return levels;
}

Image<Rgb> sphere_map_picture(const Environment& source, int size_px, const Run& run) {
  return filled(source, {Layout::kSphereMap}, size_px, run, [](double, double) { return Vec3{1, 0, 0}; });
}

Image<Rgb> dual_paraboloid_picture(const Environment& source, int size_px, const Run& run) {
  return filled(source, {Layout::kDualParaboloid}, size_px, run, [&](double x, double y) {
    const bool back = x > size_px;
    const double u = 2 * (back ? x - size_px : x) / size_px - 1, v = 2 * y / size_px - 1;
    // Two texels beside the rim are blended with it; farther out nothing is looked up, and what is alike packs well.
    if (std::hypot(u, v) > 1 + 4.0 / size_px) return Vec3{1, 0, 0};
    const double square = u * u + v * v, forward = (1 - square) / (1 + square);
    return Vec3{back ? -forward : forward, -2 * u / (1 + square), -2 * v / (1 + square)};
  });
}

Image<Rgb> bump_picture(int size_px) {
  Image<Rgb> picture(size_px, size_px);
  const double turn = 2 * kPi / size_px;
  for (int y = 0; y < size_px; ++y) {
    for (int x = 0; x < size_px; ++x) {
      const double u = turn * (x + 0.5), v = turn * (y + 0.5);
      // A quarter of cos u + cos v + cos(2u + v)/2, which lies in [-2.5, 2.5], over a tile 2 pi wide.
      const double height = std::cos(u) + std::cos(v) + 0.5 * std::cos(2 * u + v);
      const double slope_u = -0.25 * (std::sin(u) + std::sin(2 * u + v)),
                   slope_v = -0.25 * (std::sin(v) + 0.5 * std::sin(2 * u + v));
      const Vec3 n = normalize(Vec3{-slope_u, -slope_v, 1});
      picture(x, y) = Rgb(RgbD(0.5 + 0.5 * n.x, 0.5 + 0.5 * n.y, 0.5 + 0.2 * height));
    }
  }
  return picture;
}

Image<Rgb> window_picture() {
  constexpr int kRows = 51, kBands = 6;
  constexpr double kNarrowest = 3;    // bands
  constexpr double kHeaviest = 0.05;  // weight of the Laplacian
  Image<Rgb> picture(6, kRows, Rgb(1, 1, 1));
  for (int row = 1; row < kRows; ++row) {
    const double strength = row / (kRows - 1.0);
    const std::array<Window, 3> windows = {Window::hann(kNarrowest / strength), Window::lanczos(kNarrowest / strength),
                                           Window::laplacian(kHeaviest * strength * strength * strength)};
    for (int i = 0; i < 3; ++i) {
      const std::vector<double> w = window_factors(windows[static_cast<std::size_t>(i)], kBands);
      picture(2 * i, row) = Rgb(RgbD(w[0], w[1], w[2]));
      picture(2 * i + 1, row) = Rgb(RgbD(w[3], w[4], w[5]));
    }
  }
  return picture;
}

Image<Rgb> highlight_picture(int size_px, RgbD light) {
  const Vec3 toward_light = normalize(Vec3{-0.5, 0.6, 0.7}), half = normalize(toward_light + Vec3{0, 0, 1});
  Image<Rgb> picture(size_px, size_px);
  for (int y = 0; y < size_px; ++y) {
    for (int x = 0; x < size_px; ++x) {
      const double nx = 2 * (x + 0.5) / size_px - 1, ny = 1 - 2 * (y + 0.5) / size_px, square = nx * nx + ny * ny;
      if (square >= 1) continue;
      const double cosine = std::max(0.0, dot(half, Vec3{nx, ny, std::sqrt(1 - square)}));
      picture(x, y) = Rgb(10 * std::pow(cosine, 40) * light);
    }
  }
  return picture;
}

Image<Rgb> drawn_highlight(int size_px, RgbD light) {
  Image<Rgb> picture(size_px, size_px);
  // A soft rectangle over [-1, 1]^2 of its own with a bar across and a bar down.
  const auto pane = [](double x, double y) {
    const auto edge = [](double inside) { return std::clamp(8 * inside, 0.0, 1.0); };
    return edge(1 - std::abs(x)) * edge(1 - std::abs(y)) * edge(std::abs(x) - 0.08) * edge(std::abs(y) - 0.08);
  };
  for (int y = 0; y < size_px; ++y) {
    for (int x = 0; x < size_px; ++x) {
      const double nx = 2 * (x + 0.5) / size_px - 1, ny = 1 - 2 * (y + 0.5) / size_px, square = nx * nx + ny * ny;
      if (square >= 1) continue;
      const double bend = 1 + 0.6 * square;
      const double bright = pane((bend * nx + 0.45) / 0.28, (bend * ny - 0.5) / 0.3);
      const double faint = 0.12 * pane((bend * nx - 0.6) / 0.2, (bend * ny + 0.6) / 0.2);
      picture(x, y) = Rgb((3 * (bright + faint)) * light);
    }
  }
  return picture;
}

}  // namespace zonal
