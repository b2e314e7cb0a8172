#pragma once

#include <span>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/light/lobe.h"

namespace zonal {

/// The same means as convolve(), by brute force: over all texels, weighted by exact solid angle times the kernel at the
/// texel's centre, in double, for each of these unit directions. Of a picture that shows a part of the sphere, the sum:
/// the rest is black. A second opinion for tests and for --verify. O(texels * directions). The same bits for any number
/// of threads. Throws Error{kCancelled}.
std::vector<RgbD> convolve_at(const Environment&, const Lobe&, std::span<const Vec3> directions, const Run& = {});

}  // namespace zonal
