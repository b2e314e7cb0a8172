#include "zonal/view/opening_exposure.h"

#include <algorithm>
#include <cmath>

#include "zonal/view/control.h"

namespace zonal {

double opening_exposure_ev(const ViewData& data) {
  const Control& exposure = control_named("exposure_ev");
  return std::clamp(std::round(4 * data.exposure_ev) / 4, exposure.least, exposure.greatest);
}

}  // namespace zonal
