#pragma once

#include "zonal/gl/technique_reference_test.h"

namespace zonal {

/// The technique fisheye-maps: the program's own map of the upper half, for these settings alone, and read as its
/// renderers read it.
PointLight fisheye_maps_reference(const Environment& panorama, const ViewState&);

}  // namespace zonal
