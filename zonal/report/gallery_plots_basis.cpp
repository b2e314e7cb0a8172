#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "zonal/math/sphere_rule.h"
#include "zonal/report/basis_shape.h"
#include "zonal/report/gallery_plots.h"
#include "zonal/report/svg.h"
#include "zonal/report/text.h"
#include "zonal/report/unfolded_cube.h"
#include "zonal/sh/eval.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr int kBands = 6;
constexpr Rgb kPaper = {0.0119f, 0.0116f, 0.0109f};  // dark on light pages and on dark ones
constexpr int kShapePx = 150, kGapPx = 10;

Sh<double> basis_function(int l, int m) {
  Sh<double> f(kBands);
  f(l, m) = 1;
  return f;
}

/// Pictures of one size for the functions of some bands: a row for each from the top, m = -l..l from the left.
Image<Rgb> pyramid(int first_band, int last_band, int width, int height,
                   const std::function<Image<Rgb>(const Sh<double>&)>& draw) {
  const int columns = 2 * last_band + 1, rows = last_band - first_band + 1;
  Image<Rgb> all(columns * (width + kGapPx) + kGapPx, rows * (height + kGapPx) + kGapPx, kPaper);
  for (int l = first_band; l <= last_band; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Image<Rgb> one = draw(basis_function(l, m));
      const int left = kGapPx + (last_band + m) * (width + kGapPx);
      const int top = kGapPx + (l - first_band) * (height + kGapPx);
      for (int y = 0; y < height; ++y) std::ranges::copy(one.row(y), all.row(top + y).begin() + left);
    }
  }
  return all;
}

/// A polynomial of the paper's appendix A2 at (2, 3, 6)/7. Only even m: the others differ from ours in sign by
/// convention.
std::vector<PublishedNumber> polynomial_numbers() {
  const double x = 2.0 / 7, y = 3.0 / 7, z = 6.0 / 7, root_pi = std::sqrt(kPi);
  struct Row {
    int l, m;
    const char* printed;
    double value;
  };
  const std::vector<Row> rows = {
      {0, 0, "1/(2√π)", 1 / (2 * root_pi)},
      {1, 0, "√3 z/(2√π)", std::sqrt(3) * z / (2 * root_pi)},
      {2, -2, "√15 xy/(2√π)", std::sqrt(15) * x * y / (2 * root_pi)},
      {3, 2, "√105 z(x² − y²)/(4√π)", std::sqrt(105) * z * (x * x - y * y) / (4 * root_pi)},
      {4, 0, "3(35z⁴ − 30z² + 3)/(16√π)", 3 * (35 * std::pow(z, 4) - 30 * z * z + 3) / (16 * root_pi)},
      {5, 4, "3√385 z(x⁴ − 6x²y² + y⁴)/(16√π)",
       3 * std::sqrt(385) * z * (std::pow(x, 4) - 6 * x * x * y * y + std::pow(y, 4)) / (16 * root_pi)},
  };
  std::vector<PublishedNumber> numbers;
  for (const Row& row : rows) {
    // A few roundings in each of the bands' steps.
    numbers.push_back({fmt::format("y of l = {}, m = {} at (2, 3, 6)/7", row.l, number(row.m, 1)), row.printed,
                       evaluate(basis_function(row.l, row.m), {x, y, z}), row.value, 1e-14});
  }
  return numbers;
}

GalleryFigure shapes() {
  const Image<Rgb> picture = pyramid(0, kBands - 1, kShapePx, kShapePx, [](const Sh<double>& f) {
    return basis_shape(f, {.size_px = kShapePx, .paper = kPaper});
  });
  return {.id = "basis-shapes",
          .title = "The basis as shapes",
          .source =
              "Sloan 2008, “Definition”: the basis functions as distorted spheres (there the first bands); the "
              "polynomials are those of appendix A2",
          .pictures = {{.name = "basis-shapes",
                        .alt = "A triangle of 36 shapes: a ball on top, two lobes below, then more and more lobes, red "
                               "where the function is positive and blue where it is negative.",
                        .picture = picture,
                        .scale = 2}},
          .caption =
              "Each point of the unit sphere is moved as far from the centre as the function is large there; red is "
              "positive, blue negative. One row for each band l = 0 to 5, m = −l to l from the left; each shape is "
              "scaled to its place. +Z is up, +X comes forward to the left. The middle column, m = 0, has circles "
              "of latitude for zeros; the ends of the rows, |m| = l, slices of an apple. The paper’s basis carries "
              "the Condon-Shortley sign: there the shapes of odd m have red and blue exchanged.",
          .numbers = polynomial_numbers()};
}

/// Which way each face of the cut-open cube looks.
std::string cube_key() {
  constexpr double kFace = 62, kLeft = 10, kTop = 28;
  const Mapping cross({Layout::kCubeCross}, image_size(Layout::kCubeCross, 1));
  const auto name_of_axis = [](Vec3 d) {
    const double along = std::abs(d.x) > 0.5 ? d.x : std::abs(d.y) > 0.5 ? d.y : d.z;
    const char* axis = std::abs(d.x) > 0.5 ? "X" : std::abs(d.y) > 0.5 ? "Y" : "Z";
    return std::string(along < 0 ? "−" : "+") + axis;
  };
  std::string inside = svg_text(8, 16, "start", "the faces of the cube");
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      const std::optional<Vec3> toward = cross.texel_direction(x, y);
      if (!toward) continue;
      const double left = kLeft + kFace * x, top = kTop + kFace * y;
      inside +=
          fmt::format(R"(<path d="M{0} {1}h{2}v{2}h-{2}z" fill="none" stroke="currentColor" stroke-opacity="0.6"/>)",
                      left, top, kFace);
      inside += svg_text(left + kFace / 2, top + kFace / 2 + 5, "middle", name_of_axis(*toward));
    }
  }
  return svg_frame(2 * kLeft + 4 * kFace, kTop + 3 * kFace + 10, "plot",
                   "A cube cut open: +Z above, −Z below, and in a row +Y, +X, −Y, −X.", inside);
}

/// The largest entry of (integral of y_i y_j) - delta_ij.
double gram_error() {
  constexpr std::size_t kCount = coefficient_count(kBands);
  std::vector<double> gram(kCount * kCount), y(kCount);
  for (const auto& [direction, weight] : sphere_rule(kBands)) {
    basis<double>(kBands, direction, y);
    for (std::size_t i = 0; i < kCount; ++i) {
      for (std::size_t j = 0; j < kCount; ++j) gram[i * kCount + j] += weight * y[i] * y[j];
    }
  }
  double worst = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t j = 0; j < kCount; ++j) worst = std::max(worst, std::abs(gram[i * kCount + j] - (i == j ? 1 : 0)));
  }
  return worst;
}

/// How often a function changes its sign along an arc, `along(t)` for t from 0 to 1.
int sign_changes(const Sh<double>& f, const std::function<Vec3(double t)>& along) {
  constexpr int kSteps = 1001;  // odd: no step falls on a zero of ours
  int changes = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double before = evaluate(f, along((i + 0.25) / kSteps)), after = evaluate(f, along((i + 1.25) / kSteps));
    if ((before < 0) != (after < 0)) ++changes;
  }
  return changes;
}

std::vector<PublishedNumber> basis_numbers() {
  const auto meridian = [](double t) { return Vec3{std::sin(kPi * t), 0, std::cos(kPi * t)}; };
  const auto equator = [](double t) { return Vec3{std::cos(2 * kPi * t), std::sin(2 * kPi * t), 0}; };
  // 36² sums of 72 products, each rounded.
  return {{"largest |∫ yᵢ yⱼ − δᵢⱼ| of the 36 functions", "0: orthonormal", gram_error(), 0, 1e-13},
          {"zeros of l = 5, m = 0 from pole to pole", "",
           static_cast<double>(sign_changes(basis_function(5, 0), meridian)), 5, 0},
          {"zeros of l = 5, m = 5 around the equator", "",
           static_cast<double>(sign_changes(basis_function(5, 5), equator)), 10, 0}};
}

GalleryPicture cubes_picture(std::string name, int first_band, int last_band, int face_px, int steps) {
  return {
      .name = std::move(name),
      .alt = fmt::format("Crosses of six cube faces for the functions of the bands {} to {}, red where they are "
                         "positive, blue where they are negative and green at zero, with white lines of equal value.",
                         first_band, last_band),
      .picture = pyramid(first_band, last_band, 4 * face_px, 3 * face_px,
                         [=](const Sh<double>& f) {
                           return unfolded_cube([&](Vec3 d) { return evaluate(f, d); },
                                                {.face_px = face_px, .steps = steps, .paper = kPaper});
                         }),
      .scale = 2};
}

GalleryFigure cubes() {
  return {.id = "basis-cubes",
          .title = "The basis on unfolded cubes",
          .source =
              "Sloan 2008, “Definition”: the unfolding of the cube, and the basis functions on it with lines of "
              "equal intensity",
          .pictures = {{.name = "cube-key",
                        .alt = "The six faces of a cube in a cross, with the axis of each.",
                        .svg = cube_key()},
                       cubes_picture("basis-cubes", 0, 2, 70, 5),
                       cubes_picture("basis-cubes-high", 3, 5, 37, 2)},
          .caption =
              "Red is positive, blue negative, green zero. Above the bands l = 0 to 2, with a white line at every "
              "fifth of the greatest value, so that lines crowd where the function changes fast; below l = 3 to 5, "
              "with a line at zero and at each half. m = −l to l from the left; each function has its own scale.",
          .numbers = basis_numbers()};
}

}  // namespace

std::vector<GalleryFigure> basis_figures() { return {shapes(), cubes()}; }

}  // namespace zonal
