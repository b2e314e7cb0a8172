#pragma once

#include "zonal/view/view_data.h"

namespace zonal {

/// The exposure a viewer opens with: the light's own to the nearest quarter of a stop, within what the control takes.
double opening_exposure_ev(const ViewData&);

}  // namespace zonal
