#pragma once

#include "zonal/light/convolve.h"
#include "zonal/light/environment.h"

namespace zonal {

// A picture that shows a part of the sphere only, when nothing shall be made up for the rest: the light is black there,
// and a second map, the mask, is 1 where something is shown. What a lobe k makes of it is the mean of what it sees, Σ L
// k / Σ k over the shown part: the convolved light over the convolved mask. A constant stays constant.

/// 1 where the picture shows something, in its projection and size.
Environment mask_of(const Environment&);

/// The convolved light over the convolved mask, texel by texel. Black where less than a hundredth of the lobe sees
/// anything: too little is known there. Both have one size. The report's bound becomes that of the quotient, which
/// grows where little is seen.
void renormalise(Convolved& light, const Convolved& mask);

}  // namespace zonal
