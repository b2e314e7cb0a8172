#pragma once

#include "zonal/base/run.h"
#include "zonal/light/synthetic.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// The radiance of daylight_sky(), in kcd/m^2, as coefficients: the sun as an exact cone, the ground as an exact half,
/// the sky from two pictures of it. Absolute error, relative to the sky's l = 0: 5e-6 up to 64 bands, measured from 0.5
/// to 90 degrees at turbidity 2 and 10; beyond 64 the pictures grow with the bands. 0.1 s. Throws as daylight_sky()
/// does, and Error{kUsage} for an azimuth or a ground that is not finite; bands >= 1, or std::logic_error.
Sh<RgbD> daylight_sh(const DaylightOptions& = {}, int bands = 3, const Run& = {});

/// The sky of daylight_sh() alone: no sun, black ground. From pictures of `rows` and twice as many; rows even and at
/// least 2 bands, or std::logic_error. 64 rows hold 6 bands to 2e-4 of l = 0. Throws Error as daylight_sh() does.
Sh<RgbD> clear_sky_sh(DaylightOptions, int bands, int rows, const Run& = {});

}  // namespace zonal
