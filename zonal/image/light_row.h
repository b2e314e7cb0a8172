#pragma once

#include <span>
#include <vector>

#include "zonal/image/code_table.h"

namespace zonal {

/// What an aligned photograph says about the light of one texel, in red, green and blue.
using LightTexel = std::array<CodeValue, 3>;

/// Reads row y of an aligned photograph as light.
///
/// Moved by whole texels, each keeps what its code says. Else the exposures (not the codes: light adds) of the four
/// texels around are mixed by a straight line along both axes, which stays between the four and so invents no light;
/// halfway between texels it leaves cos(pi f) of what varies with f cycles a texel. The mixture has the smallest weight
/// of the four, and is no better than the worst of them: without data if one is, else saturated (its exposure a lower
/// bound), else black (an upper bound).
void read_light(const Exposure&, const CodeTable&, int y, std::span<LightTexel> into);

}  // namespace zonal
