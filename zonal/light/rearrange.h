#pragma once

#include <optional>

#include "zonal/light/environment.h"
#include "zonal/math/vec.h"

namespace zonal {

/// The same texels in another order: what the source shows at d, the result shows at world_from_source * d (orthogonal;
/// a mirror is allowed), without a single value being changed. nullopt unless the centre of every texel of the result
/// falls on the centre of one of the source: cubes of one size in any layout under quarter turns and mirrors along the
/// axes, a panorama under a yaw of whole texels, a half turn. O(texels). Throws Error{kInput} when the size does not
/// fit the projection.
std::optional<Environment> rearranged(const Environment&, const Projection& to, ImageSize,
                                      const Rotation& world_from_source = {});

}  // namespace zonal
