#include "zonal/math/legendre.h"

#include <cmath>

#include "zonal/base/check.h"
#include "zonal/math/vec.h"

namespace zonal {
namespace {

/// Bonnet's three-term recurrence.
void legendre_forward(double x, std::span<double> values) {
  double before = 0, now = 1;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = now;
    const double l = static_cast<double>(i), next = ((2 * l + 1) * x * now - l * before) / (l + 1);
    before = now;
    now = next;
  }
}

/// The same by differences d_l = P_l - P_{l-1}, which are small next to x = 1 and never computed by subtraction.
void legendre_by_differences(double versine, std::span<double> values) {
  double difference = 0, now = 1;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = now;
    const double l = static_cast<double>(i);
    difference = (l * difference - (2 * l + 1) * versine * now) / (l + 1);
    now += difference;
  }
}

/// P_l(-x) = (-1)^l P_l(x).
void mirror(std::span<double> values) {
  for (std::size_t l = 1; l < values.size(); l += 2) values[l] = -values[l];
}

}  // namespace

void legendre(double x, std::span<double> values) {
  // From 1/2 up, 1 - x is exact (Sterbenz 1974).
  if (std::abs(x) < 0.5) return legendre_forward(x, values);
  legendre_by_differences(1 - std::abs(x), values);
  if (x < 0) mirror(values);
}

void legendre_from_versine(double versine, std::span<double> values) {
  if (versine < 0.5) return legendre_by_differences(versine, values);
  legendre(1 - versine, values);
}

void legendre_derivatives(std::span<const double> values, std::span<double> derivatives) {
  check(values.size() == derivatives.size(), "one derivative for each value");
  for (std::size_t l = 0; l < values.size(); ++l) {
    if (l == 0) {
      derivatives[l] = 0;
    } else {
      const double before = l >= 2 ? derivatives[l - 2] : 0;
      derivatives[l] = before + (2 * static_cast<double>(l) - 1) * values[l - 1];
    }
  }
}

void associated_legendre(int m, double cos_theta, double sin_theta, std::span<double> values) {
  check(m >= 0, "m counts from 0; the sign of m chooses cosine or sine");
  double now = std::sqrt((m > 0 ? 2 : 1) / (4 * kPi));
  for (int k = 1; k <= m; ++k) now *= sin_theta * std::sqrt((2.0 * k + 1) / (2.0 * k));
  double before = 0, slope_before = 1;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = now;
    const double l = m + static_cast<double>(i) + 1;
    const double slope = std::sqrt((4 * l * l - 1) / ((l - m) * (l + m)));
    const double next = slope * (cos_theta * now - before / slope_before);
    before = now;
    now = next;
    slope_before = slope;
  }
}

}  // namespace zonal
