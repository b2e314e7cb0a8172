#pragma once

#include "zonal/base/run.h"
#include "zonal/light/environment.h"

namespace zonal {

/// A room to light things with when nobody gives a probe: a warm lamp high on the right, a cool window on the left and
/// a small red lamp behind, over a dark floor; equirectangular, 512 x 256. The lamp is a hundred times as bright as the
/// walls: enough to ring.
Environment gallery_probe(const Run& = {});

}  // namespace zonal
