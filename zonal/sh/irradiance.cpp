#include "zonal/sh/irradiance.h"

namespace zonal {

std::vector<double> cosine_factors(int bands) {
  check(bands >= 0, "the number of bands must not be negative");
  std::vector<double> factors(static_cast<std::size_t>(bands), 0.0);  // A_l = 0 for odd l > 1
  if (bands > 1) factors[1] = 2.0 / 3;
  double even = 1;
  for (int l = 0; l < bands; l += 2) {
    factors[static_cast<std::size_t>(l)] = even;
    even *= -(l - 1.0) / (l + 4.0);
  }
  return factors;
}

}  // namespace zonal
