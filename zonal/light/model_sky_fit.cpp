#include "zonal/light/model_sky_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/light/model_daylight.h"

namespace zonal {
namespace {

constexpr int kTerms = 12;  // in each of both variables
constexpr int kRows = 64;   // of the pictures: as good as the fit, see clear_sky_sh

/// The model divides by Perez's function at the zenith, which vanishes near this turbidity, outside its domain. A
/// polynomial follows the product with the distance from there, not the quotient.
constexpr double kPole = 1.65;

using Chebyshev = std::array<double, kTerms>;

/// T_0..T_11 at x in [-1, 1].
Chebyshev chebyshev(double x) {
  Chebyshev t = {1, x};
  for (std::size_t k = 2; k < t.size(); ++k) t[k] = 2 * x * t[k - 1] - t[k - 2];
  return t;
}

double to_unit(double value, double low, double high) { return (2 * value - low - high) / (high - low); }
double from_unit(double x, double low, double high) { return (low + high + x * (high - low)) / 2; }
double elevation_at(double x) { return from_unit(x, SkyFit::kLowestElevationDeg, SkyFit::kHighestElevationDeg); }
double turbidity_at(double x) { return from_unit(x, SkyFit::kClearest, SkyFit::kHaziest); }

Sh<RgbD> model(double elevation_deg, double turbidity, int bands, const Run& run) {
  return clear_sky_sh({.elevation_deg = elevation_deg, .turbidity = turbidity}, bands, kRows, run);
}

double worst_error(const Sh<RgbD>& fit, const Sh<RgbD>& truth) {
  double worst = 0;
  for (std::size_t i = 0; i < fit.size(); ++i) {
    const RgbD d = fit[i] - truth[i];
    worst = std::max({worst, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
  }
  return worst / luminance(truth(0, 0));
}

}  // namespace

SkyFit::SkyFit(int bands, const Run& run) : bands_(bands), terms_(kTerms * kTerms, Sh<RgbD>(bands)) {
  check(bands >= 1 && bands <= 6, "a fitted sky has 1 to 6 bands");
  // Interpolation at the zeros of T_12, where its polynomials are orthogonal as vectors.
  const auto zero = [](int i) { return std::cos(kPi * (i + 0.5) / kTerms); };
  for (int i = 0; i < kTerms; ++i) {
    for (int j = 0; j < kTerms; ++j) {
      const double turbidity = turbidity_at(zero(j));
      const Sh<RgbD> sample = (turbidity - kPole) * model(elevation_at(zero(i)), turbidity, bands, run);
      const Chebyshev u = chebyshev(zero(i)), v = chebyshev(zero(j));
      for (int a = 0; a < kTerms; ++a) {
        for (int b = 0; b < kTerms; ++b) {
          const double norm = (a > 0 ? 2.0 : 1.0) * (b > 0 ? 2.0 : 1.0) / (kTerms * kTerms);
          terms_[a * kTerms + b] += (norm * u[a] * v[b]) * sample;
        }
      }
    }
  }
  constexpr int kChecks = 8;  // evenly, both ends included
  for (int i = 0; i < kChecks; ++i) {
    for (int j = 0; j < kChecks; ++j) {
      const double elevation = elevation_at(2.0 * i / (kChecks - 1) - 1),
                   turbidity = turbidity_at(2.0 * j / (kChecks - 1) - 1);
      error_ = std::max(error_, worst_error(at(elevation, turbidity), model(elevation, turbidity, bands, run)));
    }
  }
}

Sh<RgbD> SkyFit::at(double elevation_deg, double turbidity) const {
  const Chebyshev u = chebyshev(to_unit(elevation_deg, kLowestElevationDeg, kHighestElevationDeg));
  const Chebyshev v = chebyshev(to_unit(turbidity, kClearest, kHaziest));
  Sh<RgbD> sh(bands_);
  for (int a = 0; a < kTerms; ++a) {
    for (int b = 0; b < kTerms; ++b) {
      const double weight = u[a] * v[b] / (turbidity - kPole);
      const Sh<RgbD>& term = terms_[a * kTerms + b];
      for (std::size_t i = 0; i < sh.size(); ++i) sh[i] += weight * term[i];
    }
  }
  return sh;
}

Sh<RgbD> SkyFit::operator()(double elevation_deg, double azimuth_deg, double turbidity) const {
  if (!(elevation_deg >= kLowestElevationDeg && elevation_deg <= kHighestElevationDeg)) {
    throw Error(ErrorKind::kUsage, "the fitted sky holds for a sun 1 to 90 degrees above the horizon");
  }
  if (!(turbidity >= kClearest && turbidity <= kHaziest)) {
    throw Error(ErrorKind::kUsage, "the sky model holds for a turbidity of 2 to 10");
  }
  if (!std::isfinite(azimuth_deg)) throw Error(ErrorKind::kUsage, "the azimuth of the sun must be finite");
  Sh<RgbD> sh = at(elevation_deg, turbidity);
  // With the sun at azimuth 0 the sky is even in y: no m < 0. Turning it about Z makes cos(m azimuth) of that and sin.
  for (int m = 1; m < bands_; ++m) {
    const double angle = m * radians(azimuth_deg);
    for (int l = m; l < bands_; ++l) {
      sh(l, -m) = std::sin(angle) * sh(l, m);
      sh(l, m) = std::cos(angle) * sh(l, m);
    }
  }
  return sh;
}

}  // namespace zonal
