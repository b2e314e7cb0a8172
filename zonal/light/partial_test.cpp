#include "zonal/light/partial.h"

#include <gtest/gtest.h>

#include "zonal/light/convolve.h"
#include "zonal/light/resample.h"
#include "zonal/light/synthetic.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

TEST(Partial, HalfAWhiteSkyStaysWhiteWhereAnythingOfItIsSeen) {
  const Environment sky = furnace({Layout::kFisheye}, {64, 64}, {1, 1, 1});
  const ResampleOptions left_out = {.uncovered = Uncovered::kBlack};
  const Projection panorama = {Layout::kEquirect};
  const Environment light = resample(sky, panorama, 64, left_out),
                    mask = resample(mask_of(sky), panorama, 64, left_out);
  Convolved convolved = convolve(light, Lobe::cosine(), panorama, {32, 16});
  const double bound_before = convolved.report.error_bound;
  renormalise(convolved, convolve(mask, Lobe::cosine(), panorama, {32, 16}));
  int white = 0, black = 0;
  for (const Rgb& texel : convolved.map.radiance.values()) {
    if (texel.r > 0) {
      EXPECT_NEAR(texel.r, 1, 1e-5);  // light and mask are the same sums
      ++white;
    } else {
      ++black;
    }
  }
  // Only surfaces that face nearly straight down see less than a hundredth of the sky.
  EXPECT_GE(white, 14 * 32);
  EXPECT_EQ(white + black, 16 * 32);
  EXPECT_GT(convolved.report.error_bound, bound_before);
}

TEST(Partial, TheMaskIsTheDisc) {
  const Environment sky = furnace({Layout::kFisheye}, {64, 64}, {0, 2, 0});
  const Environment mask = mask_of(sky);
  int shown = 0;
  for (const Rgb& texel : mask.radiance.values()) shown += texel.g == 1;
  // Texels cut by the rim are in.
  EXPECT_GT(shown, static_cast<int>(kPi * 32 * 32));
  EXPECT_LT(shown, static_cast<int>(kPi * 33 * 33) + 4);
  EXPECT_EQ(mask.radiance(0, 0), Rgb{});
}

TEST(Partial, NothingIsMadeUpWhereNothingIsSeen) {
  Convolved light{furnace({Layout::kEquirect}, {4, 2}, {3, 3, 3}), {.error_bound = 0.25, .bound_to_mean = 0.5}};
  Convolved mask{furnace({Layout::kEquirect}, {4, 2}, {0.5f, 0.5f, 0.5f}), {.error_bound = 0.125}};
  mask.map.radiance(2, 1) = {};
  renormalise(light, mask);
  EXPECT_EQ(light.map.radiance(0, 0), (Rgb{6, 6, 6}));
  EXPECT_EQ(light.map.radiance(2, 1), Rgb{});
  EXPECT_EQ(light.report.error_bound, (0.25 + 6 * 0.125) / 0.5);
  EXPECT_EQ(light.report.bound_to_mean, 4.0);  // grown as much, eightfold
}

}  // namespace
}  // namespace zonal
