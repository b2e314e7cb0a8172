#pragma once

#include "zonal/image/response.h"
#include "zonal/image/response_samples.h"

namespace zonal {

/// The codes at which each channel answers to light at all. A film's base, a scanner's or a lens's veil and a sensor's
/// offset leave codes above 0 that do not rise when the exposure does; averaged in, they drag dark texels up by whole
/// stops. A code z answers when texels that have it rise, in the next longer exposure, by 0.15 z for each stop on
/// average (a power of 1/2.2 rises by 0.37 z, a linear camera by z); `lowest` is the highest code up to 64
/// that does not. Codes with few texels count together with their neighbours. `highest` stays 255.
TrustedRanges find_trusted_codes(const CodeSamples&);

}  // namespace zonal
