#include "zonal/sht/ring_grid.h"

#include <cmath>

#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"

namespace zonal {

double RingGrid::theta(int ring) const { return kPi * (ring + 0.5) / height; }

std::vector<double> RingGrid::weights(RingWeights kind) const {
  const double column = 2 * kPi / width;
  if (kind == RingWeights::kFejer) {
    std::vector<double> weights = fejer_weights(height);
    for (double& weight : weights) weight *= column;
    return weights;
  }
  // cos(top) - cos(bottom) = 2 sin(centre) sin(half height), without its cancellation.
  std::vector<double> weights(height);
  const double half_row = std::sin(kPi / (2 * height));
  for (int j = 0; j < height; ++j) weights[j] = column * 2 * std::sin(theta(j)) * half_row;
  return weights;
}

std::vector<double> RingGrid::response_to_one(RingWeights kind, int bands) const {
  std::vector<double> response(bands);
  const std::vector<double> ring_weights = weights(kind);
  for (int j = 0; j < height; ++j) {
    const double x = std::cos(theta(j)), weight = width * ring_weights[j];
    double before = 0, legendre = 1;
    for (int l = 0; l < bands; ++l) {
      response[l] += weight * legendre;
      const double next = ((2 * l + 1) * x * legendre - l * before) / (l + 1);
      before = legendre;
      legendre = next;
    }
  }
  for (int l = 0; l < bands; ++l) response[l] *= std::sqrt((2 * l + 1) / (4 * kPi));
  return response;
}

}  // namespace zonal
