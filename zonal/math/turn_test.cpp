#include "zonal/math/turn.h"

#include <gtest/gtest.h>

#include <limits>

#include "zonal/math/sphere_rule.h"

namespace zonal {
namespace {

TEST(Turn, TakesUpToAnyDirection) {
  std::vector<Vec3> directions = spiral_directions(100);
  directions.insert(directions.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, normalize({1e-9, -1e-12, -1})});
  int compared = 0;
  for (const Vec3 d : directions) {
    const Rotation r = turn_z_to(d);
    EXPECT_LT(length(r * Vec3{0, 0, 1} - d), 1e-15);
    EXPECT_NEAR(determinant(r), 1, 1e-15 * 8);
    const Rotation one = r * transpose(r);
    for (int i = 0; i < 3; ++i) EXPECT_LT(length(one.rows[i] - Rotation().rows[i]), 1e-15 * 8);  // a few roundings
    ++compared;
  }
  EXPECT_EQ(compared, 105);
  EXPECT_EQ(turn_z_to({0, 0, 1}), Rotation::identity());
}

TEST(Turn, RefusesWhatIsNoDirection) {
  EXPECT_THROW(turn_z_to({0, 0, 0}), std::logic_error);
  EXPECT_THROW(turn_z_to({0, 0, 2}), std::logic_error);
  EXPECT_THROW(turn_z_to({0, std::numeric_limits<double>::quiet_NaN(), 1}), std::logic_error);
}

}  // namespace
}  // namespace zonal
