#pragma once

#include <span>

#include "zonal/base/run.h"
#include "zonal/image/response.h"

namespace zonal {

/// How a texel's radiance is averaged over the exposures, each channel for itself; X(z) is the response, t the seconds.
enum class MergeRule {
  kLogMean,       ///< ln E = Σ w ln(X(z) / t) / Σ w with the hat w (Debevec & Malik 1997, eq. 6)
  kLeastSquares,  ///< E = Σ w t X(z) / Σ w t² (Robertson et al. 2003), w the Gaussian over the variance that a code's
                  ///< noise has as exposure, X'(z)²: long exposures count most, but not on a curve's shoulder
};

struct MergeOptions {
  MergeRule rule = MergeRule::kLogMean;
  TrustedRanges trusted = {};
  /// For each exposure a factor on its weights, 255 is 1 (see deghost.h); empty: all 1. 0 counts as 1e-4, so that a
  /// texel which only one exposure sees keeps its value.
  std::span<const Image<std::uint8_t>> masks = {};
};

/// In Merge::source: texels that no exposure shows well.
inline constexpr std::uint8_t kOnlySaturated = 255, kOnlyBlack = 254, kInConflict = 253, kNoData = 252;
inline constexpr int kMostExposures = 252;

/// Radiance, in the unit of Response, and where it comes from.
///
/// A channel for which no exposure has a trusted code is not invented. Saturated in all: the value is a lower bound,
/// what saturates the shortest exposure. Black in all: an upper bound, what the longest one's code stands for (0 for
/// given curves). Saturated in some and black in the others (the scene jumped over the trusted codes, or moved): the
/// lower bound by the shortest saturated one. No data in any: 0.
struct Merge {
  Image<Rgb> radiance;
  /// The exposure (its place in the bracket) that counts most in each texel, or one of the constants above:
  /// kOnlySaturated and kInConflict when a channel is, kOnlyBlack when all three are.
  Image<std::uint8_t> source;
  std::int64_t saturated = 0, black = 0, conflicting = 0, no_data = 0;  ///< texels with a channel that is
};

/// Merges an arranged bracket. Rows are worked on one by one: beside the bracket only the result is in memory. Throws
/// Error{kCancelled}; more than kMostExposures exposures break a promise.
Merge merge_exposures(const Exposures&, const Response&, const MergeOptions& = {}, const Run& = {});

}  // namespace zonal
