#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "zonal/math/legendre.h"
#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"
#include "zonal/report/curve_plot.h"
#include "zonal/report/gallery_plots.h"

namespace zonal {
namespace {

/// P_l^m(x) with the Condon-Shortley sign and without normalisation, as the lecture and the paper define it, from ours.
double lecture_legendre(int l, int m, double x) {
  std::vector<double> column(static_cast<std::size_t>(l - m + 1));
  associated_legendre(m, x, std::sqrt(1 - x * x), column);
  double squared_norm = (m == 0 ? 1 : 2) * (2 * l + 1) / (4 * kPi);
  for (int k = l - m + 1; k <= l + m; ++k) squared_norm /= k;  // (l-m)!/(l+m)!
  return (m % 2 == 0 ? 1 : -1) * column.back() / std::sqrt(squared_norm);
}

struct Line {
  Ink ink;
  bool dashed;
};
constexpr std::array<Line, 6> kLines = {Line{Ink::kText, false},  Line{Ink::kRed, false}, Line{Ink::kBlue, false},
                                        Line{Ink::kGreen, false}, Line{Ink::kText, true}, Line{Ink::kRed, true}};

Curve curve_of(int l, int m, std::string name, const Line& line) {
  return {.name = std::move(name),
          .points = sampled([=](double x) { return lecture_legendre(l, m, x); }, -1, 1, 161),
          .ink = line.ink,
          .dashed = line.dashed};
}

GalleryPicture picture_of(std::string name, std::string title, std::string alt, std::vector<Curve> curves) {
  return {.name = std::move(name),
          .alt = alt,
          .svg = curve_plot({.title = std::move(title),
                             .description = alt,
                             .x = {.label = "x", .range = AxisRange{-1, 1}, .marks = {-1, -0.5, 0, 0.5, 1}},
                             .y = {},
                             .curves = std::move(curves),
                             .height = 260})};
}

std::vector<PublishedNumber> table_numbers() {
  const double x = 0.6, root = 0.8;  // x² + root² = 1
  struct Row {
    int l, m;
    const char* printed;
    double value;
  };
  const std::array<Row, 6> rows = {Row{0, 0, "1", 1},
                                   Row{1, 0, "x", x},
                                   Row{1, 1, "−√(1 − x²)", -root},
                                   Row{2, 0, "(3x² − 1)/2", (3 * x * x - 1) / 2},
                                   Row{2, 1, "−3x√(1 − x²)", -3 * x * root},
                                   Row{2, 2, "3(1 − x²)", 3 * root * root}};
  std::vector<PublishedNumber> numbers;
  for (const Row& row : rows) {
    numbers.push_back({fmt::format("P of l = {}, m = {} at x = 0.6", row.l, row.m), row.printed,
                       lecture_legendre(row.l, row.m, x), row.value, 1e-14});
  }
  return numbers;
}

/// The integral of P_i^m P_j^m over [-1, 1].
double product_integral(int i, int j, int m) {
  const Quadrature rule = gauss_legendre(i + j + 1);
  double sum = 0;
  for (std::size_t k = 0; k < rule.size(); ++k)
    sum += rule.weights[k] * lecture_legendre(i, m, rule.nodes[k]) * lecture_legendre(j, m, rule.nodes[k]);
  return sum;
}

GalleryFigure legendre_curves() {
  GalleryFigure figure = {
      .id = "legendre",
      .title = "Legendre functions",
      .source =
          "Lecture “Lighting by the environment” (Special topics in game graphics, no. 10): the table and the "
          "shapes of P of l, m; Sloan 2008, “Definition” and appendix A1",
      .pictures = {},
      .caption =
          "The parts of the basis that depend on latitude, x = cos θ, with the sign (−1)ᵐ of both documents and "
          "without normalisation. Above the Legendre polynomials, m = 0, below a band each with its associated "
          "functions.",
      .numbers = table_numbers()};
  std::vector<Curve> polynomials;
  for (int l = 0; l < 6; ++l) polynomials.push_back(curve_of(l, 0, fmt::format("{}", l), kLines[l]));
  figure.pictures.push_back(
      picture_of("legendre", "m = 0, by l", "The Legendre polynomials of degree 0 to 5.", std::move(polynomials)));
  for (int l = 1; l <= 3; ++l) {
    std::vector<Curve> band;
    for (int m = 0; m <= l; ++m) band.push_back(curve_of(l, m, fmt::format("{}", m), kLines[m]));
    figure.pictures.push_back(picture_of(fmt::format("legendre-{}", l), fmt::format("l = {}, by m", l),
                                         fmt::format("The associated Legendre functions of band {}.", l),
                                         std::move(band)));
  }
  figure.numbers.push_back(
      {"∫ P², l = 2, m = 2", "2/(2n + 1) · (n + m)!/(n − m)!", product_integral(2, 2, 2), 2.0 / 5 * 24, 1e-12});
  figure.numbers.push_back(
      {"∫ P², l = 3, m = 1", "2/(2n + 1) · (n + m)!/(n − m)!", product_integral(3, 3, 1), 2.0 / 7 * 12, 1e-12});
  figure.numbers.push_back({"∫ of l = 1 times l = 3, m = 1", "0", product_integral(1, 3, 1), 0, 1e-13});
  return figure;
}

}  // namespace

std::vector<GalleryFigure> legendre_figures() { return {legendre_curves()}; }

}  // namespace zonal
