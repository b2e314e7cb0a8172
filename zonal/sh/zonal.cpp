#include "zonal/sh/zonal.h"

#include <cmath>

#include "zonal/math/legendre.h"

namespace zonal {
namespace {

double weight(std::size_t l) { return std::sqrt((2.0 * static_cast<double>(l) + 1) / (4 * kPi)); }

}  // namespace

std::vector<double> zonal_from_factors(std::span<const double> factors) {
  std::vector<double> zonal(factors.begin(), factors.end());
  for (std::size_t l = 0; l < zonal.size(); ++l) zonal[l] *= weight(l);
  return zonal;
}

void factors_from_zonal(std::span<const double> zonal, std::span<double> factors) {
  check(zonal.size() == factors.size(), "one factor for each zonal coefficient");
  for (std::size_t l = 0; l < factors.size(); ++l) factors[l] = zonal[l] / weight(l);
}

std::vector<double> factors_from_zonal(std::span<const double> zonal) {
  std::vector<double> factors(zonal.size());
  factors_from_zonal(zonal, factors);
  return factors;
}

double evaluate_zonal(std::span<const double> zonal, double c) {
  std::vector<double> p(zonal.size());
  legendre(c, p);
  double sum = 0;
  for (std::size_t l = 0; l < zonal.size(); ++l) sum += zonal[l] * weight(l) * p[l];
  return sum;
}

}  // namespace zonal
