#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "zonal/light/extract.h"
#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// Where a light is and how large, without its intensity.
struct LightShape {
  Vec3 direction;
  double versine = 0;  ///< 1 - cos(half angle) of a uniform disc, in [0, 1]
  int maximum = -1;    ///< the maximum of the probe it started from, if any
};

/// lambda_l of a uniform disc of unit integral: (1 + c) P_l'(c)/(l(l+1)), c = 1 - versine; 1 for l = 0. And their
/// derivatives with respect to the versine. Without cancellation at any angle.
struct DiscFactors {
  std::vector<double> factors, slopes;
};
DiscFactors disc_factors(double versine, int bands);

/// Lights with the intensities that fit a probe best.
struct LightFit {
  std::vector<LightShape> shapes;
  Eigen::MatrixX3d flux;  ///< integral of the radiance of each light over the sphere: a row each, a column a channel
  Eigen::MatrixX3d rest;  ///< what is left of bands 1 and up, in the metric; a column a channel. Both scaled
  double residual = 0;    ///< as in ExtractedLights
};

/// How residual^2 changes with the shape of one light.
struct ShapeSlope {
  Vec3 direction;      ///< per radian, tangent
  double versine = 0;  ///< per unit
};

/// A probe, made ready for fitting lights to it again and again.
class LightFitter {
 public:
  /// Throws Error{kInput} when a coefficient is not finite, Error{kUsage} for fewer than two bands.
  LightFitter(const Sh<RgbD>& radiance, ExtractMetric, bool nonnegative);

  int bands() const { return bands_; }
  /// The same from everywhere, as far as pictures of floats tell: there is nothing for lights to explain.
  bool constant() const { return size_ == 0; }

  LightFit fit(std::vector<LightShape>) const;
  /// One for each light. The intensities being the best ones, only the direct influence counts (envelope theorem).
  std::vector<ShapeSlope> slopes(const LightFit&) const;
  /// What is left, by luminance and in the metric once more: highest about where another light would explain most.
  Sh<double> unexplained(const LightFit&) const;
  /// In the units of the probe, the brightest light first; without the maxima.
  ExtractedLights result(const LightFit&) const;

 private:
  Eigen::VectorXd column(const LightShape&) const;

  int bands_;
  bool nonnegative_;
  double scale_ = 1;                 // of the coefficients
  std::array<double, 3> flux_ = {};  // of the whole probe, scaled
  std::vector<double> weights_;      // of each band in the metric
  Eigen::MatrixX3d probe_;           // bands 1 and up in the metric, scaled; a column a channel
  double size_ = 0;                  // its sum of squares, weighted like luminance
};

}  // namespace zonal
