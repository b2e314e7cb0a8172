#include "zonal/light/fisheye_pixels.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/base/error.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr double kLargestExponent = 1e4;
// Powers below are left out: the sums of a whole picture of them stay within float's range, and so do their products
// with radiance.
constexpr double kLeastPower = 1e-30;

ImageSize size_of(const Environment& e) { return {e.radiance.width(), e.radiance.height()}; }

bool inside(const Image<Rgb>& image, int x, int y) {
  return x >= 0 && y >= 0 && x < image.width() && y < image.height();
}

double sinc(double angle) { return angle > 0 ? std::sin(angle) / angle : 1; }

/// sin(a)/a as a function of x = 2 cos(a) - 1, a in [0, π/2], as a Chebyshev series. Its nearest singularity, a = π, is
/// at x = -3: each term is (3 + √8) times smaller than the one before, 11 of them reach float's rounding.
std::vector<float> sinc_series() {
  constexpr int kTerms = 11;
  std::vector<float> series;
  for (int k = 0; k < kTerms; ++k) {
    double sum = 0;
    for (int j = 0; j < kTerms; ++j) {
      const double angle = kPi * (j + 0.5) / kTerms;
      sum += sinc(std::acos((std::cos(angle) + 1) / 2)) * std::cos(k * angle);
    }
    series.push_back(static_cast<float>((k == 0 ? 1.0 : 2.0) / kTerms * sum));
  }
  return series;
}

}  // namespace

FisheyePixels::FisheyePixels(PixelBox box) : box_(box) {
  const std::size_t count = static_cast<std::size_t>(box.x1 - box.x0) * static_cast<std::size_t>(box.y1 - box.y0);
  for (std::vector<float>* values : {&x_, &y_, &z_, &weight_, &r_, &g_, &b_}) values->assign(count, 0);
}

std::size_t FisheyePixels::index(int x, int y) const {
  return static_cast<std::size_t>(y - box_.y0) * static_cast<std::size_t>(box_.x1 - box_.x0) +
         static_cast<std::size_t>(x - box_.x0);
}

void FisheyePixels::set(int x, int y, Vec3 toward, double weight, RgbD radiance) {
  const std::size_t i = index(x, y);
  x_[i] = static_cast<float>(toward.x), y_[i] = static_cast<float>(toward.y), z_[i] = static_cast<float>(toward.z);
  weight_[i] = static_cast<float>(weight);
  const Rgb light(weight * radiance);
  r_[i] = light.r, g_[i] = light.g, b_[i] = light.b;
}

LobePixels FisheyePixels::row(int x, int y) const {
  const std::size_t i = index(x, y);
  return {&x_[i], &y_[i], &z_[i], &weight_[i], &r_[i], &g_[i], &b_[i]};
}

PixelCircle fisheye_circle(const Environment& photograph) {
  if (photograph.projection.layout != Layout::kFisheye) {
    throw Error(ErrorKind::kUsage,
                "a fisheye photograph is wanted, not " + std::string(name_of(photograph.projection.layout)),
                "convert it first: zonal convert --to fisheye");
  }
  const Mapping checked(photograph.projection, size_of(photograph));  // throws where the lens is impossible
  return circle_of(photograph.projection, checked.size());
}

void require_equidistant_half_sphere(const Environment& photograph) {
  const Lens& lens = photograph.projection.lens;
  if (lens.model == LensModel::kEquidistant && lens.fov_deg == 180) return;
  throw Error(ErrorKind::kUsage, "the published program takes equidistant fisheyes of 180 degrees only",
              "the corrected one takes every lens");
}

FisheyePixels pixels_of_plane(const Environment& photograph, const PixelCircle& circle, PixelBox box, Rgb ground,
                              bool by_solid_angle) {
  require_equidistant_half_sphere(photograph);
  FisheyePixels pixels(box);
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const double s = (x + 0.5 - circle.center_x) / circle.radius_x;
      const double t = (circle.center_y - (y + 0.5)) / circle.radius_y;
      const double r = std::hypot(s, t), angle = r * kPi / 2;
      // As published: the root of 1 - cos², which is never negative, beyond the nadir neither.
      const double side = r > 0 ? std::abs(std::sin(angle)) / r : 0;
      const bool sky = r < 1 && inside(photograph.radiance, x, y);
      pixels.set(x, y, {t * side, s * side, std::cos(angle)}, by_solid_angle ? sinc(angle) : 1,
                 RgbD(sky ? photograph.radiance(x, y) : ground));
    }
  }
  return pixels;
}

FisheyePixels pixels_of_sky(const Environment& photograph, bool by_solid_angle) {
  const ImageSize size = size_of(photograph);
  const Mapping mapping(photograph.projection, size);
  FisheyePixels pixels({0, 0, size.width, size.height});
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto toward = by_solid_angle ? mapping.texel_direction(x, y) : mapping.direction({x + 0.5, y + 0.5});
      if (!toward) continue;
      pixels.set(x, y, *toward, by_solid_angle ? mapping.solid_angle(x, y) : 1, RgbD(photograph.radiance(x, y)));
    }
  }
  return pixels;
}

FisheyeLobe::FisheyeLobe(double exponent, bool by_angle_to_lobe)
    : exponent_(exponent), factor_(by_angle_to_lobe ? sinc_series() : std::vector<float>{1}) {
  if (exponent >= 0 && exponent <= kLargestExponent) return;
  throw Error(ErrorKind::kUsage, "a sum over pixels takes a shininess from 0 to 10000",
              "sharper lobes are narrower than a pixel");
}

LobeShape FisheyeLobe::shape() const {
  const double least = exponent_ > 0 ? std::pow(kLeastPower, 1 / exponent_) : 0;
  return {static_cast<int>(exponent_), static_cast<float>(exponent_ - std::floor(exponent_)), static_cast<float>(least),
          factor_.data(), static_cast<int>(factor_.size())};
}

LobeSum lobe_sum(const FisheyePixels& pixels, const PixelBox& window, const FisheyeLobe& lobe, Vec3 toward, Isa isa) {
  const FisheyeMeansKernels& kernels = fisheye_means_kernels(isa);
  const LobeShape shape = lobe.shape();
  const float q[3] = {static_cast<float>(toward.x), static_cast<float>(toward.y), static_cast<float>(toward.z)};
  double sums[4] = {};
  for (int y = window.y0; y < window.y1; ++y) {
    kernels.add(shape, pixels.row(window.x0, y), window.x1 - window.x0, q, sums);
  }
  return {{sums[1], sums[2], sums[3]}, sums[0]};
}

}  // namespace zonal
