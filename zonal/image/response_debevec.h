#pragma once

#include "zonal/image/response.h"
#include "zonal/image/response_samples.h"

namespace zonal {

struct DebevecOptions {
  /// How smooth the curve is made, for a sum over 150 texels; the sum is scaled so that more of them leave the balance
  /// as it is. More: smoother, less: closer to noisy data.
  double smoothness = 20;
  TrustedRanges trusted = {};
};

/// The response by Debevec & Malik 1997: g(z) = ln exposure and the texels' ln radiance that minimise
///
///     sum over texels and exposures (w(z) (g(z) - ln radiance - ln seconds))² + smoothness² sum over z (w(z) g''(z))²
///
/// with the hat w (eq. 3 and 4). The texels' radiances are eliminated beforehand (each appears in its own equations
/// only), which leaves a system of 256 unknowns a channel however many texels there are. Where the solution falls it is
/// levelled and counted. Throws Error{kInput} when a channel has too few texels that two exposures see well.
ResponseFit estimate_response_debevec(const CodeSamples&, const DebevecOptions& = {});

}  // namespace zonal
