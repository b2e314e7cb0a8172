#include "zonal/light/model_sky_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/light/model_daylight.h"

namespace zonal {
namespace {

TEST(SlowSkyFit, FollowsTheModelWithTheErrorItStates) {
  const SkyFit fit(4);
  EXPECT_LT(fit.error(), 1e-3);
  EXPECT_GT(fit.error(), 0);
  int compared = 0;
  double worst = 0;
  for (const double elevation : {1.0, 3.3, 17.0, 46.0, 71.0, 90.0}) {
    for (const double turbidity : {2.0, 2.4, 5.1, 9.7}) {
      for (const double azimuth : {0.0, 130.0}) {
        const DaylightOptions options = {.elevation_deg = elevation, .azimuth_deg = azimuth, .turbidity = turbidity};
        const Sh<RgbD> expected = clear_sky_sh(options, 4, 128), actual = fit(elevation, azimuth, turbidity);
        ASSERT_EQ(actual.bands(), 4);
        for (std::size_t i = 0; i < actual.size(); ++i, ++compared) {
          const RgbD d = actual[i] - expected[i];
          worst = std::max(worst, std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)}) / luminance(expected[0]));
        }
      }
    }
  }
  EXPECT_EQ(compared, 6 * 4 * 2 * 16);
  // Its own points of measurement may have missed the worst place by this much; and the pictures' 2e-4.
  EXPECT_LT(worst, 2 * fit.error() + 2e-4);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit(0.5, 0, 3), Error);
  EXPECT_THROW(fit(91, 0, 3), Error);
  EXPECT_THROW(fit(nan, 0, 3), Error);
  EXPECT_THROW(fit(30, nan, 3), Error);
  EXPECT_THROW(fit(30, 0, 1.9), Error);
  EXPECT_THROW(fit(30, 0, nan), Error);
  EXPECT_THROW(SkyFit(7), std::logic_error);
  EXPECT_THROW(SkyFit(0), std::logic_error);
}

}  // namespace
}  // namespace zonal
