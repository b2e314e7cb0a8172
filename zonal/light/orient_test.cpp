#include "zonal/light/orient.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zonal {
namespace {

TEST(Orient, SignsOfYawPitchAndRoll) {
  EXPECT_EQ(turned(90) * (Vec3{1, 0, 0}), (Vec3{0, 1, 0}));        // yaw: to the left
  EXPECT_EQ(turned(0, 90) * (Vec3{1, 0, 0}), (Vec3{0, 0, 1}));     // pitch: up
  EXPECT_EQ(turned(0, 0, 90) * (Vec3{0, 1, 0}), (Vec3{0, 0, 1}));  // roll: +Y to +Z
  EXPECT_EQ(turned(90, 90) * (Vec3{1, 0, 0}), (Vec3{0, 0, 1}));    // pitch comes before yaw
  EXPECT_EQ(turned(-270, 360, 720), turned(90));
}

TEST(Orient, QuarterTurnsHaveNoRounding) {
  int compared = 0;
  for (const double yaw : {-90.0, 0.0, 90.0, 180.0}) {
    for (const double pitch : {-90.0, 0.0, 90.0}) {
      const Rotation r = turned(yaw, pitch, 90);
      for (const Vec3& row : r.rows) {
        for (const double v : {row.x, row.y, row.z}) {
          EXPECT_TRUE(v == 0 || v == 1 || v == -1);
          ++compared;
        }
      }
      EXPECT_EQ(determinant(r), 1);
    }
  }
  EXPECT_EQ(compared, 108);
  const Rotation near = Rotation::about_z(radians(30)), ours = turned(30);
  for (int i = 0; i < 3; ++i) EXPECT_LT(length(near.rows[i] - ours.rows[i]), 1e-15);
}

TEST(Orient, TheAnglesOfARotationMakeItAgain) {
  int compared = 0;
  for (const double yaw : {-179.0, -90.0, -30.0, 0.0, 77.0, 180.0}) {
    for (const double pitch : {-90.0, -89.9, -41.0, 0.0, 12.0, 90.0}) {
      for (const double roll : {-180.0, -100.0, 0.0, 3.0, 90.0}) {
        const Rotation rotation = turned(yaw, pitch, roll);
        const Turn turn = turn_of(rotation);
        const Rotation again = turned(turn);
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_LT(length(again.rows[i] - rotation.rows[i]), 1e-13) << yaw << " " << pitch << " " << roll;
        }
        EXPECT_LE(std::abs(turn.pitch_deg), 90);
        EXPECT_LE(std::abs(turn.yaw_deg), 180);
        EXPECT_LE(std::abs(turn.roll_deg), 180);
        if (std::abs(pitch) < 89) {
          EXPECT_NEAR(std::remainder(turn.yaw_deg - yaw, 360), 0, 1e-12);
          EXPECT_NEAR(turn.pitch_deg, pitch, 1e-12);
          EXPECT_NEAR(std::remainder(turn.roll_deg - roll, 360), 0, 1e-12);
        }
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 180);
  EXPECT_EQ(turn_of(turned(0)), Turn());
}

}  // namespace
}  // namespace zonal
