#include "zonal/sh/zonal_lights.h"

#include <cmath>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/math/legendre.h"
#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

std::vector<double> zeros(int bands) {
  check(bands >= 0, "the number of bands must not be negative");
  return std::vector<double>(static_cast<std::size_t>(bands), 0.0);
}

/// 1 - cos(angle), with all digits of a small angle.
double versine(double angle) {
  const double half_sine = std::sin(angle / 2);
  return 2 * half_sine * half_sine;
}

}  // namespace

std::vector<double> delta_zonal(int bands) {
  std::vector<double> factors = zeros(bands);
  for (double& factor : factors) factor = 1;  // convolving with it changes nothing
  return zonal_from_factors(factors);
}

std::vector<double> constant_zonal(int bands) {
  std::vector<double> zonal = zeros(bands);
  if (bands > 0) zonal[0] = std::sqrt(4 * kPi);
  return zonal;
}

std::vector<double> clamped_cosine_zonal(int bands) {
  std::vector<double> factors = cosine_factors(bands);
  for (double& factor : factors) factor *= kPi;
  return zonal_from_factors(factors);
}

std::vector<double> upper_half_zonal(int bands) {
  // Half of what is even is half of one; the odd bands are the cone's of pi/2, for which cos(pi/2) = 0 must be exact:
  // z_l = sqrt(pi/(2l+1)) (P_{l-1}(0) - P_{l+1}(0)).
  std::vector<double> zonal = zeros(bands), p(zonal.size() + 1);
  legendre(0, p);
  if (bands > 0) zonal[0] = std::sqrt(kPi);
  for (std::size_t l = 1; l < zonal.size(); l += 2) {
    zonal[l] = std::sqrt(kPi / (2 * static_cast<double>(l) + 1)) * (p[l - 1] - p[l + 1]);
  }
  return zonal;
}

std::vector<double> cone_zonal(double half_angle, int bands) {
  if (!(half_angle >= 0 && half_angle <= kPi)) {
    throw Error(ErrorKind::kUsage, "the half angle of a cone must lie in [0, pi]");
  }
  std::vector<double> zonal = zeros(bands);
  // A wide cone is everything but the opposite narrow one, whose cosine keeps its digits.
  const bool wide = half_angle > kPi / 2;
  const double rim = wide ? kPi - half_angle : half_angle, sine = std::sin(rim);
  std::vector<double> p(zonal.size()), slope(zonal.size());
  legendre_from_versine(versine(rim), p);
  legendre_derivatives(p, slope);
  for (std::size_t i = 0; i < zonal.size(); ++i) {
    const double l = static_cast<double>(i);
    if (i == 0) {
      zonal[i] = std::sqrt(kPi) * versine(half_angle);
    } else {  // Legendre's equation integrated: int_c^1 P_l = (1 - c^2) P_l'(c)/(l(l+1))
      const double sign = wide && i % 2 == 0 ? -1 : 1;
      zonal[i] = sign * std::sqrt(kPi * (2 * l + 1)) * sine * sine * slope[i] / (l * (l + 1));
    }
  }
  return zonal;
}

std::vector<double> smooth_cone_zonal(double half_angle, int bands) {
  if (!(half_angle > 0 && half_angle <= kPi)) {
    throw Error(ErrorKind::kUsage, "the half angle of a smooth cone must lie in (0, pi]");
  }
  std::vector<double> zonal = zeros(bands), p(zonal.size());
  // Over t in [0, 1] the integrand turns as fast as cos(half_angle bands t). Gauss's rule resolves that from half_angle
  // bands/4 nodes on; a third and 20 more leave nothing above rounding.
  const Quadrature gauss = gauss_legendre(20 + static_cast<int>(half_angle * bands / 3), 0, 1);
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    const double angle = half_angle * gauss.nodes[i];
    legendre_from_versine(versine(angle), p);
    const double weight = gauss.weights[i] * smooth_cone_profile(angle, half_angle) * half_angle * std::sin(angle);
    for (std::size_t l = 0; l < zonal.size(); ++l) zonal[l] += weight * p[l];
  }
  for (std::size_t l = 0; l < zonal.size(); ++l) zonal[l] *= std::sqrt(kPi * (2 * static_cast<double>(l) + 1));
  return zonal;
}

double smooth_cone_profile(double angle, double half_angle) {
  const double u = angle / half_angle;
  return u < 1 ? (1 - u) * (1 - u) * (1 + 2 * u) : 0;
}

double sphere_half_angle(double radius, double distance) {
  if (!(radius >= 0 && distance >= 0 && std::isfinite(radius) && std::isfinite(distance) && radius + distance > 0)) {
    throw Error(ErrorKind::kUsage, "a spherical light needs a radius and a distance that are not negative",
                "and not both zero");
  }
  return distance < radius ? kPi : std::asin(radius / distance);
}

}  // namespace zonal
