#pragma once

#include <cstdint>
#include <span>

#include "zonal/image/image.h"
#include "zonal/math/vec.h"

namespace zonal {

/// How far one picture is from another. "Relative" is to the root mean square of the reference.
struct Comparison {
  std::int64_t texels = 0;       ///< compared: weight above 0 and finite in both
  std::int64_t not_finite = 0;   ///< left out: NaN or Inf in either picture
  double rmse = 0;               ///< over the three channels, weighted
  double relative_rmse = 0;      ///< rmse / rms of the reference; 0 when both are black, infinity when only it is
  double mean_error = 0;         ///< signed, image minus reference: a change of energy
  double psnr_db = 0;            ///< peak: the reference's largest absolute channel; infinity when equal
  double max_error = 0;          ///< largest absolute channel difference
  int worst_x = 0, worst_y = 0;  ///< where that is
  double max_relative_error =
      0;  ///< largest channel difference over the reference's channel (floored at 1e-3 of its rms)
};

/// Compares two pictures of the same size, texels weighted by `weights` (row by row; empty: all alike), e.g. by solid
/// angle. Throws Error{kInput} when the sizes differ.
Comparison compare(const Image<Rgb>& image, const Image<Rgb>& reference, std::span<const double> weights = {});

/// The largest absolute channel difference of each texel; NaN where either is not finite. Throws Error{kInput} as
/// above.
Image<float> difference(const Image<Rgb>& image, const Image<Rgb>& reference);

}  // namespace zonal
