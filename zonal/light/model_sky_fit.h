#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// The sky of daylight_sky() (no sun's disc, black ground) as coefficients that are polynomials in the sun's elevation
/// and the turbidity, for a sun that moves every frame (the idea of Sloan 2008). Made once, in about a second; then a
/// value takes a microsecond at 3 bands.
class SkyFit {
 public:
  static constexpr double kLowestElevationDeg = 1, kHighestElevationDeg = 90, kClearest = 2, kHaziest = 10;

  /// 1 to 6 bands, or std::logic_error. Throws Error{kCancelled}.
  explicit SkyFit(int bands = 3, const Run& = {});

  /// In kcd/m^2. Throws Error{kUsage} outside the ranges above and for an azimuth that is not finite.
  Sh<RgbD> operator()(double elevation_deg, double azimuth_deg, double turbidity) const;

  /// The greatest error of any coefficient between the points that were fitted, relative to the luminance in l = 0;
  /// measured when the fit was made, 2e-4. What was fitted has an error of its own of the same size: see clear_sky_sh.
  double error() const { return error_; }

 private:
  Sh<RgbD> at(double elevation_deg, double turbidity) const;

  int bands_;
  std::vector<Sh<RgbD>> terms_;  // [elevation][turbidity]: products of Chebyshev polynomials, sun at azimuth 0
  double error_ = 0;
};

}  // namespace zonal
