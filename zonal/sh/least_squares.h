#pragma once

#include <span>

#include "zonal/sh/sh.h"

namespace zonal {

/// A value that was seen in a direction. T is double or RgbD.
template <class T>
struct ShSample {
  Vec3 direction;  ///< of any length but zero
  T value = {};
  double weight = 1;  ///< >= 0; only ratios matter. Equal: each sample counts the same. Solid angle: as in an integral
};

/// The fit and how well it stands.
template <class T>
struct LeastSquaresFit {
  Sh<T> coefficients;
  T residual = {};       ///< sqrt(sum weight (fit - value)^2 / sum weight), for each channel
  double condition = 1;  ///< at most this factor lies between relative errors of the values and of the coefficients
};

/// The coefficients f that minimise 4 pi sum weight (f(direction) - value)^2 / sum weight + ridge |f|^2. With samples
/// spread evenly over the sphere the first term is the integral of the squared error over it, so a ridge of 0.01 means
/// the same for ten samples and a million: it draws a function that the samples determine well towards zero by 1 %, and
/// one that they do not see at all to zero.
///
/// Orthogonal throughout (QR by blocks of rows, then the singular values of what is left): nothing is squared, so
/// digits are lost by `condition` and not by its square. O(samples bands^4 + bands^6) time, O(bands^4) memory.
///
/// Throws Error{kUsage} for a ridge that is negative or not finite, and for bands outside 1..32 (more: fill a panorama
/// and project it). Throws Error{kInput} where a direction is zero, a number is not finite, a weight is negative, all
/// weights are zero; and, without a ridge, where samples of positive weight are fewer than coefficients or lie so that
/// they leave some combination of coefficients open.
LeastSquaresFit<double> fit_sh(std::span<const ShSample<double>>, int bands, double ridge = 0);
LeastSquaresFit<RgbD> fit_sh(std::span<const ShSample<RgbD>>, int bands, double ridge = 0);

}  // namespace zonal
