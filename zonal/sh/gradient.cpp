#include "zonal/sh/gradient.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/math/legendre.h"

namespace zonal {
namespace {

/// The associated functions of order m > 0 over sin(theta): finite at the poles, where only m = 1 is left.
void associated_over_sine(int m, double z, double sine, std::span<double> column) {
  constexpr double kPole = 1e-150;  // sine^2 is nothing beside 1, and 1/sine is still a number
  if (sine > kPole) {
    associated_legendre(m, z, sine, column);
    for (double& value : column) value /= sine;
  } else if (m == 1) {
    associated_legendre(1, z, 1, column);  // sine^1 over sine
  } else {
    std::fill(column.begin(), column.end(), 0.0);
  }
}

}  // namespace

ValueAndGradient value_and_gradient(std::span<const double> sh, int bands, Vec3 direction, std::span<double> column) {
  check(bands >= 1 && sh.size() == static_cast<std::size_t>(coefficient_count(bands)) &&
            column.size() == static_cast<std::size_t>(bands),
        "a gradient needs at least one band, and room for one number a band");
  check(std::abs(length(direction) - 1) <= 1e-6, "a gradient is taken at a unit direction");  // false for NaN as well
  const auto coefficient = [&](int l, int m) { return sh[static_cast<std::size_t>(coefficient_index(l, m))]; };
  const double z = direction.z, sine = std::hypot(direction.x, direction.y);
  // At a pole any phi names the same tangents, if everything below uses the same one.
  const double cos_phi = sine > 0 ? direction.x / sine : 1, sin_phi = sine > 0 ? direction.y / sine : 0;

  double value = 0, along_theta = 0, along_phi = 0;  // along_phi: d/dphi over sin(theta)
  associated_legendre(0, z, sine, column);
  for (int l = 0; l < bands; ++l) value += coefficient(l, 0) * column[static_cast<std::size_t>(l)];

  double cosine_m = 1, sine_m = 0;  // of m phi
  for (int m = 1; m < bands; ++m) {
    const double next = cosine_m * cos_phi - sine_m * sin_phi;
    sine_m = sine_m * cos_phi + cosine_m * sin_phi;
    cosine_m = next;
    const std::span<double> p = column.first(static_cast<std::size_t>(bands - m));
    associated_over_sine(m, z, sine, p);
    for (int l = m; l < bands; ++l) {
      const double now = p[static_cast<std::size_t>(l - m)], ll = l;
      const double even = coefficient(l, m), odd = coefficient(l, -m);
      const double wave = even * cosine_m + odd * sine_m;
      value += wave * now * sine;
      along_phi += m * (odd * cosine_m - even * sine_m) * now;
      // sin(theta) dP_l/dtheta = l cos(theta) P_l - sqrt((2l+1)(l^2-m^2)/(2l-1)) P_{l-1}, all of order m.
      const double before = l > m ? p[static_cast<std::size_t>(l - m - 1)] : 0;
      const double share = std::sqrt((2 * ll + 1) * (ll - m) * (ll + m) / (2 * ll - 1));
      along_theta += wave * (ll * z * now - share * before);
      // And for order 0 the derivative is a multiple of the function of order 1.
      if (m == 1) along_theta -= coefficient(l, 0) * std::sqrt(ll * (ll + 1) / 2) * now * sine;
    }
  }
  const Vec3 toward_theta = {z * cos_phi, z * sin_phi, -sine}, toward_phi = {-sin_phi, cos_phi, 0};
  return {value, along_theta * toward_theta + along_phi * toward_phi};
}

}  // namespace zonal
