#include "zonal/light/lobe_lean.h"

#include <gtest/gtest.h>

#include <cmath>

#include "zonal/base/error.h"
#include "zonal/light/brdf.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

/// The mean direction of what ggx_brdf() reflects of a white sky, a texel at a time.
Vec3 mean_of_texels(double theta, double alpha) {
  constexpr int kRows = 256;
  const Mapping sky({Layout::kEquirect}, {2 * kRows, kRows});
  const Brdf brdf = ggx_brdf(alpha);
  Vec3 sum;
  for (int y = 0; y < kRows / 2; ++y) {  // above the surface
    for (int x = 0; x < 2 * kRows; ++x) {
      const Vec3 l = *sky.texel_direction(x, y);
      sum += l.z * sky.solid_angle(x, y) * brdf(l, {std::sin(theta), 0, std::cos(theta)}).g * l;
    }
  }
  return normalize(sum);
}

TEST(LobeLean, IsTheMeanDirectionOfTheBrdf) {
  int compared = 0;
  for (const double alpha : {0.09, 0.25, 0.49, 1.0}) {
    const LobeLean lean(alpha);
    for (const double theta_deg : {0.0, 10.0, 35.0, 60.0, 75.0, 85.0}) {
      const double theta = radians(theta_deg);
      const Vec3 view = {std::sin(theta), 0, std::cos(theta)};
      EXPECT_LT(angle_between(lean.mean(view, {0, 0, 1}), mean_of_texels(theta, alpha)), theta_deg > 80 ? 3e-3 : 2e-3)
          << alpha << " " << theta_deg;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 24);
}

TEST(LobeLean, OfASmoothSurfaceIsNothingAndOfARoughOneNearlyAll) {
  EXPECT_NEAR(LobeLean(1e-3).lean(1), 0, 1e-4);
  EXPECT_EQ(LobeLean(0.5).lean(0), 0);
  EXPECT_GT(LobeLean(1).lean(1.4), 1.2);
  EXPECT_GT(LobeLean(0.25).lean(1.2), LobeLean(0.25).lean(0.6));
}

TEST(LobeLean, FindsTheNormalOfAMeanDirection) {
  const LobeLean lean(0.3);
  int compared = 0;
  for (const Vec3 view : {Vec3{0, 0, 1}, normalize({0.4, -0.3, 0.6}), normalize({-0.2, 0.9, -0.5})}) {
    for (const Vec3 normal : {view, normalize(view + Vec3{0.3, 0.2, 0.1}), normalize(view + Vec3{-0.9, 0.7, 0.8})}) {
      EXPECT_LT(angle_between(lean.normal(view, lean.mean(view, normal)), normal), 1e-6);
      ++compared;
    }
    // Straight behind the surface no lobe points: the steepest.
    EXPECT_NEAR(angle_between(view, lean.normal(view, -view)), LobeLean::kSteepest, 1e-6);
  }
  EXPECT_EQ(compared, 9);
  EXPECT_THROW(LobeLean(0), Error);
  EXPECT_THROW(LobeLean(1.1), Error);
}

}  // namespace
}  // namespace zonal
