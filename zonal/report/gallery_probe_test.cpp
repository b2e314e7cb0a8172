#include "zonal/report/gallery_probe.h"

#include <gtest/gtest.h>

#include <cmath>

#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

TEST(GalleryProbe, TheLampIsTheBrightestAndEverythingIsLit) {
  const Environment probe = gallery_probe();
  const ImageSize size = {probe.radiance.width(), probe.radiance.height()};
  ASSERT_EQ(size, (ImageSize{512, 256}));
  const Mapping mapping(probe.projection, size);
  Vec3 brightest;
  float most = 0;
  int compared = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float light = luminance(probe.radiance(x, y));
      EXPECT_GT(light, 0) << x << ' ' << y;
      EXPECT_LT(light, 100) << x << ' ' << y;
      if (light > most) most = light, brightest = *mapping.texel_direction(x, y);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 512 * 256);
  EXPECT_NEAR(degrees(std::asin(brightest.z)), 42, 1);  // a texel is 0.7 degrees
  EXPECT_NEAR(degrees(std::atan2(brightest.y, brightest.x)), -50, 1);
}

}  // namespace
}  // namespace zonal
