#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/light/lobe.h"
#include "zonal/math/legendre.h"
#include "zonal/sh/irradiance.h"

// The band factors of each lobe, by a recurrence that is stable in the direction it is used. Derivations:
// docs/notes/lobes.md.

namespace zonal {
namespace {

/// lambda_{l+2} = lambda_l (s-l)/(s+l+3), from two integrations by parts of int_0^1 c^s P_l.
std::vector<double> phong_factors(double s, int bands) {
  std::vector<double> factors(bands);
  for (int l = 0; l < bands; ++l) {
    if (l == 0) factors[l] = 1;
    if (l == 1) factors[l] = (s + 1) / (s + 2);
    if (l >= 2) factors[l] = factors[l - 2] * (s - (l - 2)) / (s + l + 1);
  }
  return factors;
}

/// P_l(0) - P_{l+1}(0) for l = 0..n-1.
std::vector<double> steps_at_zero(int n) {
  std::vector<double> p(static_cast<std::size_t>(n) + 1);
  legendre(0, p);
  for (int l = 0; l < n; ++l) p[l] -= p[l + 1];
  p.pop_back();
  return p;
}

/// int_0^1 ((1+c)/2)^p P_l dc.
std::vector<double> upper_moments(double p, const std::vector<double>& steps) {
  std::vector<double> f(steps.size());
  const double edge = std::exp2(-p);
  f[0] = -2 * std::expm1(-(p + 1) * std::numbers::ln2) / (p + 1);
  for (std::size_t i = 0; i + 1 < f.size(); ++i) {
    const double l = static_cast<double>(i);
    f[i + 1] = ((p - l) * f[i] + edge * steps[i]) / (p + l + 2);
  }
  return f;
}

std::vector<double> blinn_phong_factors(double exponent, int bands) {
  const std::vector<double> steps = steps_at_zero(bands);
  const std::vector<double> f = upper_moments(exponent / 2, steps), g = upper_moments(exponent / 2 + 1, steps);
  std::vector<double> factors(bands);
  for (int l = 0; l < bands; ++l) factors[l] = (2 * g[l] - f[l]) / (2 * g[0] - f[0]);
  return factors;
}

/// k = c (1-c)^q. With h_l = int_0^1 (1-c)^q P_l, which obeys the recurrence above seen from the other side of c = 0,
/// the moments of k are h_l(q) - h_l(q+1); carrying that difference itself keeps the digits that a sharp ring (large q)
/// would lose.
std::vector<double> charlie_factors(double alpha, int bands) {
  const double q = 1 / (2 * alpha), scale = (q + 1) * (q + 2);  // k_0 = 1/scale
  const std::vector<double> steps = steps_at_zero(bands);
  std::vector<double> factors(bands);
  double h = 1 / (q + 1), k = 1;
  for (int l = 0; l < bands; ++l) {
    factors[l] = k;
    const double step = l % 2 == 0 ? steps[l] : -steps[l];
    k = ((l - q - 1) * k + scale * ((2.0 * l + 2) * h + step) / (q + l + 2)) / (q + l + 3);
    h = ((l - q) * h + step) / (q + l + 2);
  }
  return factors;
}

/// Multiplying a function of c by 1 - x c acts on its moments y_l = int f P_l as the matrix
///   -l x y_{l-1} + (2l+1) y_l - (l+1) x y_{l+1}.
/// This divides by it: Gaussian elimination from high l to low. The rows' sums (2l+1)(1-x) are carried instead of the
/// diagonal, so that nothing is ever subtracted (Grassmann, Taksar & Heyman 1985) and a sharp lobe (x near 1) loses no
/// digits.
class DivideByDistance {
 public:
  DivideByDistance(double one_minus_x, int size) : x_(1 - one_minus_x), excess_(size), pivot_(size) {
    double carried = 1;  // of the row below: excess/pivot; 1 where the moments are cut off to zero
    for (int l = size - 1; l >= 0; --l) {
      excess_[l] = (2.0 * l + 1) * one_minus_x + (l + 1) * x_ * carried;
      pivot_[l] = l * x_ + excess_[l];
      carried = excess_[l] / pivot_[l];
    }
  }

  void operator()(std::vector<double>& y) const {
    const int size = static_cast<int>(y.size());
    for (int l = 0; l < size; ++l) y[l] *= 2.0 * l + 1;
    for (int l = size - 2; l >= 0; --l) y[l] += (l + 1) * x_ * y[l + 1] / pivot_[l + 1];
    y[0] /= pivot_[0];
    for (int l = 1; l < size; ++l) y[l] = (y[l] + l * x_ * y[l - 1]) / pivot_[l];
  }

 private:
  double x_;
  std::vector<double> excess_;
  std::vector<double> pivot_;
};

/// k = c/(1 - x c)^2 is the clamped cosine divided twice.
std::vector<double> ggx_factors(double alpha, int bands) {
  const double a2 = alpha * alpha, one_minus_x = 2 * a2 / (1 + a2), x = 1 - one_minus_x;
  // What is cut off at `size` comes back as a solution that falls like exp(-acosh(1/x)) per band: 40 of those and it is
  // gone.
  const double decay = std::log1p((one_minus_x + std::sqrt(one_minus_x * (1 + x))) / x);
  const int margin = 42 + (x > 0 ? static_cast<int>(std::min(40 / decay, 1e7)) : 0);
  std::vector<double> factors = cosine_factors(bands + margin);
  const DivideByDistance divide(one_minus_x, bands + margin);
  divide(factors);
  divide(factors);
  factors.resize(bands);
  for (int l = bands - 1; l >= 0; --l) factors[l] /= factors[0];
  return factors;
}

/// (1+c) P_l'(c)/(l(l+1)) at the rim, from int_c^1 P_l = (1-c^2) P_l'(c)/(l(l+1)).
std::vector<double> cone_factors(double half_angle, int bands) {
  const double sine = std::sin(half_angle / 2), cosine = std::cos(half_angle / 2);
  std::vector<double> p(bands), factors(bands);
  legendre_from_versine(2 * sine * sine, p);
  legendre_derivatives(p, factors);
  for (int l = 1; l < bands; ++l) factors[l] *= 2 * cosine * cosine / (static_cast<double>(l) * (l + 1));
  factors[0] = 1;
  return factors;
}

/// Ratios of modified Bessel functions, r_l = lambda_l/lambda_{l-1} = 1/((2l+1)/kappa + r_{l+1}), from high l to low.
std::vector<double> gaussian_factors(double width, int bands) {
  const double inverse_kappa = width * width;
  // Starting with r = 0 errs by less than 1, and each step down multiplies the error by r^2, about exp(-2l/kappa): from
  // 10 sqrt(kappa) bands above the highest wanted one, by e^-100 in all.
  const int start = bands + 50 + static_cast<int>(std::min(10 / width, 1e7));
  double ratio = 0;
  std::vector<double> factors(bands);
  for (int l = start; l >= 1; --l) {
    ratio = 1 / ((2.0 * l + 1) * inverse_kappa + ratio);
    if (l < bands) factors[l] = ratio;
  }
  factors[0] = 1;
  for (int l = 1; l < bands; ++l) factors[l] *= factors[l - 1];
  return factors;
}

}  // namespace

std::vector<double> band_factors(const Lobe& lobe, int bands) {
  check(bands >= 1, "the number of bands must be positive");
  switch (lobe.kind()) {
    case LobeKind::kCosine:
      return cosine_factors(bands);
    case LobeKind::kPhong:
      return phong_factors(lobe.parameter(), bands);
    case LobeKind::kBlinnPhong:
      return blinn_phong_factors(lobe.parameter(), bands);
    case LobeKind::kGgx:
      return ggx_factors(lobe.parameter(), bands);
    case LobeKind::kCharlie:
      return charlie_factors(lobe.parameter(), bands);
    case LobeKind::kCone:
      return cone_factors(lobe.parameter(), bands);
    case LobeKind::kGaussian:
      return gaussian_factors(lobe.parameter(), bands);
  }
  check(false, "a lobe of unknown kind");
  return {};
}

int bands_for(const Lobe& lobe, double tolerance) {
  check(tolerance > 0 && tolerance <= 1, "the tolerance must lie in (0, 1]");
  constexpr int kMaxBands = 1 << 20;
  // Every lobe's |lambda_l| has a falling envelope, touched at least once per octave of l: when none of the last octave
  // is above, none beyond is.
  for (int bands = 64; bands <= 2 * kMaxBands; bands *= 2) {
    const std::vector<double> factors = band_factors(lobe, bands);
    int needed = bands;
    while (needed > 0 && std::abs(factors[needed - 1]) < tolerance) --needed;
    if (needed <= bands / 2) return needed;
  }
  throw Error(ErrorKind::kUsage,
              "the " + std::string(name_of(lobe.kind())) + " lobe needs more than a million bands for this tolerance",
              "take a wider lobe or a larger tolerance");
}

}  // namespace zonal
