#include "zonal/light/extract_closed.h"

#include <cmath>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/light/model_argument.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

constexpr double kSingular = 1e-10;  // of a determinant of columns of size one: directions some 1e-5 apart

/// The inner products that the normal equations are made of, for lights of irradiance 1.
class Products {
 public:
  Products(const Sh<double>& radiance, ExtractMetric metric) : mean_(0) {
    const int bands = radiance.bands();
    if (bands < 2) throw Error(ErrorKind::kUsage, "lights are found in a probe of at least two bands");
    for (const double value : radiance.values()) {
      if (!std::isfinite(value)) throw Error(ErrorKind::kInput, "a coefficient of the probe is not finite");
    }
    std::vector<double> squares(static_cast<std::size_t>(bands), 1.0);
    if (metric == ExtractMetric::kIrradiance) {
      squares = cosine_factors(bands);
      for (double& factor : squares) factor *= factor;
    }
    mean_ = radiance(0, 0);
    squares[0] = 0;
    directional_ = convolve(radiance, squares);
    light_ = convolve(zonal_toward(delta_zonal(bands), {0, 0, 1}), squares);
  }

  /// Of a light with the probe, without the mean.
  double with_probe(Vec3 light) const { return evaluate(directional_, light); }
  /// Of two lights, without the mean.
  double of_lights(Vec3 a, Vec3 b) const {
    const double angle = angle_between(a, b);
    return evaluate(light_, {std::sin(angle), 0, std::cos(angle)});
  }
  double mean() const { return mean_; }
  /// What is left of the mean; a light of irradiance E adds E/sqrt(4pi) to it.
  double ambient(double irradiance) const { return (mean_ - irradiance / std::sqrt(4 * kPi)) / std::sqrt(4 * kPi); }

 private:
  double mean_;
  Sh<double> directional_, light_;
};

Vec3 toward(Vec3 direction) { return direction_of(direction, "the way toward a light"); }

double regular(double determinant, double size) {
  if (!(std::abs(determinant) > kSingular * size)) {
    throw Error(ErrorKind::kUsage, "the probe's bands cannot tell these lights apart",
                "drop one of two equal directions, or use fit_lights()");
  }
  return determinant;
}

}  // namespace

ClosedFit<1> fit_one_light(const Sh<double>& radiance, Vec3 direction, ExtractMetric metric) {
  const Products products(radiance, metric);
  const Vec3 d = toward(direction);
  const double irradiance = products.with_probe(d) / products.of_lights(d, d);
  return {{irradiance}, products.ambient(irradiance)};
}

ClosedFit<1> fit_one_light_coupled(const Sh<double>& radiance, Vec3 direction, ExtractMetric metric) {
  const Products products(radiance, metric);
  const Vec3 d = toward(direction);
  // The ambient of radiance 1 is sqrt(4pi) in l = 0, a light of irradiance 1 is 1/sqrt(4pi) there.
  const double light_light = products.of_lights(d, d) + 1 / (4 * kPi), light_ambient = 1, ambient_ambient = 4 * kPi;
  const double with_light = products.with_probe(d) + products.mean() / std::sqrt(4 * kPi);
  const double with_ambient = products.mean() * std::sqrt(4 * kPi);
  const double determinant = light_light * ambient_ambient - light_ambient * light_ambient;
  return {{(ambient_ambient * with_light - light_ambient * with_ambient) / determinant},
          (light_light * with_ambient - light_ambient * with_light) / determinant};
}

ClosedFit<2> fit_two_lights(const Sh<double>& radiance, const std::array<Vec3, 2>& directions, ExtractMetric metric) {
  const Products products(radiance, metric);
  const Vec3 d0 = toward(directions[0]), d1 = toward(directions[1]);
  const double a = products.of_lights(d0, d0), b = products.of_lights(d0, d1);
  const double p0 = products.with_probe(d0), p1 = products.with_probe(d1);
  const double determinant = regular((a - b) * (a + b), a * a);
  const double e0 = (a * p0 - b * p1) / determinant, e1 = (a * p1 - b * p0) / determinant;
  return {{e0, e1}, products.ambient(e0 + e1)};
}

ClosedFit<3> fit_three_lights(const Sh<double>& radiance, const std::array<Vec3, 3>& directions, ExtractMetric metric) {
  const Products products(radiance, metric);
  const Vec3 d0 = toward(directions[0]), d1 = toward(directions[1]), d2 = toward(directions[2]);
  const double a = products.of_lights(d0, d0);
  const double b = products.of_lights(d0, d1), c = products.of_lights(d0, d2), d = products.of_lights(d1, d2);
  const double p0 = products.with_probe(d0), p1 = products.with_probe(d1), p2 = products.with_probe(d2);
  const double determinant = regular(2 * b * c * d + a * (a * a - b * b - c * c - d * d), a * a * a);
  // The adjugate is symmetric; the paper prints its last row's middle entry as BD - AD.
  const double off01 = c * d - a * b, off02 = b * d - a * c, off12 = b * c - a * d;
  const double e0 = ((a * a - d * d) * p0 + off01 * p1 + off02 * p2) / determinant;
  const double e1 = (off01 * p0 + (a * a - c * c) * p1 + off12 * p2) / determinant;
  const double e2 = (off02 * p0 + off12 * p1 + (a * a - b * b) * p2) / determinant;
  return {{e0, e1, e2}, products.ambient(e0 + e1 + e2)};
}

}  // namespace zonal
