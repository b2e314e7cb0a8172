#include <algorithm>
#include <cmath>

#include "zonal/light/model.h"
#include "zonal/light/project.h"
#include "zonal/light/sample.h"
#include "zonal/light/synthetic.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/picture_sheet.h"
#include "zonal/report/sphere_disc.h"
#include "zonal/sh/axial_product.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/product.h"
#include "zonal/sh/product_matrix.h"

namespace zonal {
namespace {

constexpr int kSizePx = 288, kRows = 256;
constexpr double kHalfAngle = radians(35);

struct Hole {
  Vec3 toward;
  double cosine = std::cos(kHalfAngle);
  bool blocks(Vec3 d) const { return dot(d, toward) > cosine; }
};

/// The visibility of 6 bands in the middle of the hole: the bands of the cone (Sloan 2008, A3) telescope there, and
/// what is left of one is the mean of the two Legendre polynomials at the cut, P5 and P6.
double middle_of_hole(double c) {
  const double p5 = c * (63 * c * c * c * c - 70 * c * c + 15) / 8;
  const double p6 = (231 * c * c * c * c * c * c - 315 * c * c * c * c + 105 * c * c - 5) / 16;
  return (p5 + p6) / 2;
}

/// Sky where nothing is before it, none where the hole is: the mean over each texel of the exact visibility.
Environment seen_through(const Environment& sky, const Hole& hole, const Run& run) {
  const auto visible = [&](Vec3 d) { return hole.blocks(d) ? Rgb{} : Rgb{1, 1, 1}; };
  Environment left = paint(sky.projection, {sky.radiance.width(), sky.radiance.height()}, visible, 4, run);
  std::ranges::transform(left.radiance.values(), sky.radiance.values(), left.radiance.values().begin(),
                         [](Rgb a, Rgb b) { return a * b; });
  return left;
}

/// The bands of f times the visibility with its edge, in the frame of the hole.
Sh<RgbD> times_exact_visibility(const Sh<RgbD>& f, const Hole& hole) {
  const AxialProduct<> blocked(
      gauss_legendre(f.bands(), hole.cosine, 1), [](double) { return 1.0; }, f.bands());
  return f - blocked.apply(f, hole.toward);
}

double square_sum(const Sh<RgbD>& sh) {
  double sum = 0;
  for (const RgbD& c : sh.values()) sum += c.r * c.r + c.g * c.g + c.b * c.b;
  return sum;
}

double square_integral(const Sh<RgbD>& sh) {
  double sum = 0;
  for (const auto& [direction, weight] : sphere_rule(sh.bands())) {
    const RgbD c = evaluate(sh, direction);
    sum += weight * (c.r * c.r + c.g * c.g + c.b * c.b);
  }
  return sum;
}

/// What a light is wrong by, relative to the true one: the root of mean squares.
PublishedNumber error_of(const std::string& what, const Sh<RgbD>& light, const Sh<RgbD>& truth) {
  return {what, "", std::sqrt(square_sum(light - truth) / square_sum(truth)),
          std::sqrt(square_integral(light - truth) / square_integral(truth)), 1e-12};
}

}  // namespace

GalleryFigure hole_in_the_sky_figure() {
  Run run;
  run.threads = 1;  // a figure is one task among others
  const Projection flat = {Layout::kEquirect};
  const Hole hole = {normalize({0.62, -0.42, 0.66})};
  const Environment sky =
      daylight_sky(flat, image_size(flat.layout, kRows), {.elevation_deg = 25, .azimuth_deg = 60, .sun = false}, run);
  const Environment left = seen_through(sky, hole, run);

  const Sh<RgbD> sky_sh = project(sky, kGalleryBands, run);
  Sh<double> visibility = luminance(cone_sh(hole.toward, kHalfAngle, {-1, -1, -1}, kGalleryBands));
  visibility[0] += 2 * std::sqrt(kPi);
  const Sh<RgbD> of_both = product(sky_sh, visibility);
  const Sh<RgbD> with_edge = times_exact_visibility(sky_sh, hole);
  const Sh<RgbD> truth = project(left, kGalleryBands, run);

  const Tonemap curve = {.exposure_ev = auto_exposure_ev(sky.radiance)};
  const auto pixels = [&](const Environment& map) {
    const Sampler sampler(map);
    return tonemap(draw_sphere_disc([&](Vec3 d) { return sampler(d); }, kSizePx, 2), curve);
  };
  const auto bands = [&](const Sh<RgbD>& sh) { return tonemap(draw_sphere_disc(seen(sh), kSizePx), curve); };
  const auto grey = [](double value) { return Rgb(RgbD(value, value, value)); };
  const auto exact_visibility = [&](Vec3 d) { return grey(hole.blocks(d) ? 0 : 1); };
  const auto visibility_seen = seen(visibility);
  const auto few_bands_visibility = [&](Vec3 d) { return grey(visibility_seen(d)); };
  const PictureSheet sheet = {
      .name = "hole-in-the-sky",
      .description =
          "A clear sky, a disc-shaped visibility and their product, as pixels and in 6 bands of spherical "
          "harmonics, where the hole is a soft dark dent.",
      .rows = {{"As they are",
                {{pixels(sky), "sky"},
                 {displayed(draw_sphere_disc(exact_visibility, kSizePx, 3)), "visibility"},
                 {pixels(left), "sky × visibility"},
                 {bands(truth), "that, in 6 bands"}}},
               {"In 6 bands",
                {{bands(sky_sh), "sky"},
                 {displayed(draw_sphere_disc(few_bands_visibility, kSizePx)), "visibility"},
                 {bands(of_both), "product of the two"},
                 {bands(with_edge), "sky × exact visibility"}}}}};

  GalleryFigure figure;
  figure.id = sheet.name;
  figure.title = "A hole in the sky";
  figure.source = "Sloan 2008, “SH products” (its first use: a large object before the sky; no figure there)";
  figure.pictures = {{.name = sheet.name, .alt = sheet.description, .svg = picture_sheet(sheet)}};
  figure.caption =
      "Something of 35° radius flies before a clear sky. The product of sky and visibility, each known in 6 bands, "
      "should be the upper right disc: the exact product, projected. The last disc multiplies the 6 bands of the sky "
      "by the visibility with its edge, as the paper does with the horizon in appendix A8.";
  const ProductMatrix<> matrix(visibility, kGalleryBands);
  const Sh<RgbD> by_matrix = matrix.apply(sky_sh);
  const double size = std::sqrt(square_sum(of_both));
  figure.numbers = {
      {"Multiplications by the product matrix of 6 bands", "1296",
       static_cast<double>(sky_sh.size() * visibility.size()), 1296, 0},
      {"By the matrix against by the list of Gaunt integrals, relative", "",
       std::sqrt(square_sum(by_matrix - of_both)) / size, 0, 1e-13},
      error_of("Error of the product of two truncated functions (on the sphere, against coefficients)", of_both, truth),
      error_of("Error with the exact visibility", with_edge, truth),
      {"Visibility in the middle of the hole, 6 bands: (P5 + P6)/2", "", evaluate(visibility, hole.toward),
       middle_of_hole(hole.cosine), 1e-14},
  };
  return figure;
}

}  // namespace zonal
