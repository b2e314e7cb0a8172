#pragma once

#include "zonal/base/run.h"
#include "zonal/image/response.h"
#include "zonal/image/response_samples.h"

namespace zonal {

struct RobertsonOptions {
  int most_iterations = 300;
  double tolerance = 1e-4;  ///< done when no point of a curve moves by more than this, the middle exposure being 1
  TrustedRanges trusted = {};
};

/// The response by Robertson, Borman & Stevenson 1999 (2003): exposures X(z) and radiances x that minimise
///
///     sum over texels and exposures w(z) (X(z) - seconds x)²
///
/// with their Gaussian w, by turns: x = Σ w t X / Σ w t² from X, then X(z) as the mean of t x where the code is z,
/// scaled back after each turn. From a straight line. Nothing asks for smoothness, so it wants many texels, and
/// unevenly spaced exposures: see even_steps(). As t² weighs, the longest exposures decide, which is wrong for cameras
/// with a long shoulder (film): Debevec & Malik's estimate is the safer one. Codes that nobody saw are interpolated.
/// Throws Error{kInput} as estimate_response_debevec() does, Error{kCancelled}.
ResponseFit estimate_response_robertson(const CodeSamples&, const RobertsonOptions& = {}, const Run& = {});

/// Whether exposures are spaced evenly in stops (within 2 %). They leave a curve free up to a factor that repeats with
/// their step (Grossberg & Nayar 2003): only smoothness can then choose.
bool even_steps(std::span<const double> seconds);

}  // namespace zonal
