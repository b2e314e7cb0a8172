#include "zonal/light/normalise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/light/model.h"
#include "zonal/light/model_argument.h"
#include "zonal/math/quadrature.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

double factor_of(double reflected) {
  if (!(reflected > 0 && std::isfinite(1 / reflected))) {
    throw Error(ErrorKind::kUsage, "a surface that faces this light reflects nothing, so no factor makes it one",
                "choose a light above the horizon of the surface, or more bands");
  }
  return 1 / reflected;
}

void check_angle(double half_angle) {
  if (!(half_angle > 0 && half_angle <= kPi)) {
    throw Error(ErrorKind::kUsage, "the half angle of a light to be normalised must lie in (0, pi]");
  }
}

}  // namespace

double normalising_factor(std::span<const double> zonal) {
  std::vector<double> reflected = cosine_factors(static_cast<int>(zonal.size()));
  for (std::size_t l = 0; l < zonal.size(); ++l) reflected[l] *= zonal[l];
  return factor_of(evaluate_zonal(reflected, 1));
}

double normalising_factor(const Sh<double>& radiance, Vec3 facing) {
  return factor_of(evaluate(irradiance_over_pi(radiance), direction_of(facing, "the normal of the surface")));
}

double directional_normalising_factor() { return kPi; }

double cone_normalising_factor(double half_angle) {
  check_angle(half_angle);
  return factor_of(cone_irradiance(half_angle, 0) / kPi);
}

double smooth_cone_normalising_factor(double half_angle) {
  check_angle(half_angle);
  // E/pi = int of the profile times 2 sin cos, above the horizon. The profile is a cubic and the rest turns less than
  // half a circle: 20 nodes leave nothing above rounding.
  const Quadrature gauss = gauss_legendre(20, 0, std::min(half_angle, kPi / 2));
  double reflected = 0;
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    const double angle = gauss.nodes[i];
    reflected += gauss.weights[i] * smooth_cone_profile(angle, half_angle) * std::sin(2 * angle);
  }
  return factor_of(reflected);
}

}  // namespace zonal
