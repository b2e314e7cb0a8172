#pragma once

#include "zonal/image/response.h"
#include "zonal/image/response_samples.h"

namespace zonal {

// What the estimators of a response share.

/// Throws Error{kInput} unless every channel has enough texels with two exposures or more at trusted codes.
void check_samples(const CodeSamples&, const TrustedRanges&);

/// Levels where raw curves fall, sets their scale (see Response) and fills in the counts and the residual of a fit.
void finish(const CodeSamples&, CodeWeight, const TrustedRanges&, ResponseFit&);

}  // namespace zonal
