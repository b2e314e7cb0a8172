#include "zonal/light/truncation.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/math/vec.h"

namespace zonal {

Truncation::Truncation(const Lobe& lobe, int max_bands) : factors_(band_factors(lobe, max_bands)) {
  const int rings = std::max(512, 8 * max_bands);
  const double half = kPi / (2 * rings);
  for (int i = 0; i < rings; ++i) {
    const double theta = kPi * (i + 0.5) / rings;
    cosines_.push_back(std::cos(theta));
    solid_angles_.push_back(2 * kPi * 2 * std::sin(theta) * std::sin(half));
    const double sine = std::sin(theta / 2);
    remainder_.push_back(lobe.kernel_from_versine(2 * sine * sine));
  }
  legendre_.assign(rings, 1.0);
  before_.assign(rings, 0.0);
}

void Truncation::extend(int bands) {
  check(bands >= bands_ && bands <= max_bands(), "a truncation only extends");
  for (; bands_ < bands; ++bands_) {
    const double l = bands_, share = (2 * l + 1) / (4 * kPi) * factors_[bands_];
    for (std::size_t i = 0; i < cosines_.size(); ++i) {
      remainder_[i] -= share * legendre_[i];
      const double next = ((2 * l + 1) * cosines_[i] * legendre_[i] - l * before_[i]) / (l + 1);
      before_[i] = legendre_[i];
      legendre_[i] = next;
    }
  }
}

std::vector<double> Truncation::errors() const {
  std::vector<double> errors(remainder_);
  for (double& e : errors) e = std::abs(e);
  return errors;
}

}  // namespace zonal
