#include "zonal/sh/irradiance.h"

namespace zonal {

void cosine_factors(std::span<double> factors) {
  double even = 1;
  for (std::size_t l = 0; l < factors.size(); ++l) {
    if (l % 2 == 1) {
      factors[l] = l == 1 ? 2.0 / 3 : 0;
    } else {
      factors[l] = even;
      const auto band = static_cast<double>(l);
      even *= -(band - 1) / (band + 4);
    }
  }
}

std::vector<double> cosine_factors(int bands) {
  check(bands >= 0, "the number of bands must not be negative");
  std::vector<double> factors(static_cast<std::size_t>(bands));
  cosine_factors(factors);
  return factors;
}

}  // namespace zonal
