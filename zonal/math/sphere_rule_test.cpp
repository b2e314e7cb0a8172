#include "zonal/math/sphere_rule.h"

#include <gtest/gtest.h>

namespace zonal {
namespace {

TEST(SphereRule, IntegratesPolynomials) {
  double area = 0, x2 = 0, x4y2 = 0, xyz = 0;
  for (const auto& [d, weight] : sphere_rule(4)) {
    EXPECT_NEAR(length(d), 1, 1e-15);
    area += weight;
    x2 += weight * d.x * d.x;
    x4y2 += weight * d.x * d.x * d.x * d.x * d.y * d.y;
    xyz += weight * d.x * d.y * d.z;
  }
  EXPECT_NEAR(area, 4 * kPi, 4e-14);  // Newton leaves the weights a few eps
  EXPECT_NEAR(x2, 4 * kPi / 3, 1e-14);
  EXPECT_NEAR(x4y2, 4 * kPi / 35, 1e-14);
  EXPECT_NEAR(xyz, 0, 1e-15);
}

TEST(SpiralDirections, AreUnitAndBalanced) {
  Vec3 sum;
  const std::vector<Vec3> directions = spiral_directions(1000);
  ASSERT_EQ(directions.size(), 1000u);
  for (const Vec3 d : directions) {
    EXPECT_NEAR(length(d), 1, 1e-15);
    sum += d;
  }
  EXPECT_LT(length(sum), 1);  // a thousandth of them
}

}  // namespace
}  // namespace zonal
