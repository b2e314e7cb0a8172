#include "zonal/view/light_turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/rotate.h"

namespace zonal {
namespace {

ViewState odd_turn() { return parse_state("light_yaw_deg=111&light_pitch_deg=37&light_roll_deg=-52"); }

/// Coefficients of which none is like another.
ViewUniform some_coefficients() {
  ViewUniform sh{"sh", 3, {}};
  for (int i = 0; i < 3 * 36; ++i) sh.values.push_back(static_cast<float>(std::sin(1.7 * i + 0.3)));
  return sh;
}

Sh<RgbD, 6> radiance_of(const std::vector<float>& values) {
  Sh<RgbD, 6> sh;
  for (std::size_t i = 0; i < 36; ++i) sh[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  return sh;
}

TEST(LightTurn, RollsThenTiltsThenTurns) {
  ViewState state;
  EXPECT_EQ(world_from_light(state), Rotation::identity());
  set_light_turn(state, {.yaw_deg = 90, .pitch_deg = 90, .roll_deg = 90});
  // What is at +Y rolls up to +Z, is tilted to -X, and is turned to -Y.
  EXPECT_EQ((world_from_light(state) * Vec3{0, 1, 0}), (Vec3{0, -1, 0}));
  EXPECT_EQ(light_turn(state), (Turn{90, 90, 90}));
  EXPECT_THROW(set_light_turn(state, {.pitch_deg = 91}), Error);
  EXPECT_TRUE(turns_light("light_roll_deg"));
  EXPECT_FALSE(turns_light("yaw"));
}

TEST(LightTurn, TheUniformIsTheInverseColumnsFirst) {
  const Rotation world = world_from_light(odd_turn());
  const auto columns = light_from_world(odd_turn());
  for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.6, 0, -0.8}}) {
    const Vec3 expected = transpose(world) * d;
    EXPECT_NEAR(columns[0] * d.x + columns[3] * d.y + columns[6] * d.z, expected.x, 1e-6);
    EXPECT_NEAR(columns[1] * d.x + columns[4] * d.y + columns[7] * d.z, expected.y, 1e-6);
    EXPECT_NEAR(columns[2] * d.x + columns[5] * d.y + columns[8] * d.z, expected.z, 1e-6);
  }
}

TEST(LightTurn, TurnedCoefficientsAreLookedUpByTheWorld) {
  const ViewUniform sh = some_coefficients();
  ViewState state = odd_turn();
  EXPECT_EQ(turned_coefficients(sh, state), sh.values) << "the normal is turned instead";
  state.set("turn_by", 1);
  const Rotation world = world_from_light(state);
  const Sh<RgbD, 6> light = radiance_of(sh.values), turned = radiance_of(turned_coefficients(sh, state));
  for (const Vec3 d : {Vec3{0, 0, 1}, normalize(Vec3{1, 2, -1}), normalize(Vec3{-3, 1, 2})}) {
    EXPECT_NEAR(evaluate(turned, d).g, evaluate(light, transpose(world) * d).g, 1e-5) << "floats of 36 terms";
  }
}

// What a page does, which has no other matrices: R = Z(yaw) Q' Z(-pitch) Q Z(-90) Q' Z(roll) Q Z(90).
TEST(LightTurn, QuarterTurnsAndTurnsAboutZMakeEveryRotation) {
  const std::vector<double> blocks = quarter_turn_blocks();
  ASSERT_EQ(blocks.size(), 286u);
  const auto by_blocks = [&](const Sh<RgbD, 6>& from, bool back) {
    Sh<RgbD, 6> to;
    for (int l = 0; l < 6; ++l) {
      for (int m = -l; m <= l; ++m) {
        for (int n = -l; n <= l; ++n) {
          const int entry = back ? (l + n) * (2 * l + 1) + l + m : (l + m) * (2 * l + 1) + l + n;
          to(l, m) += blocks[static_cast<std::size_t>(rotation_entries(l) + entry)] * from(l, n);
        }
      }
    }
    return to;
  };
  const auto about_z = [](const Sh<RgbD, 6>& from, double angle_deg) {
    return rotate_about_z(from, std::cos(radians(angle_deg)), std::sin(radians(angle_deg)));
  };
  const auto about_y = [&](const Sh<RgbD, 6>& from, double angle_deg) {
    return by_blocks(about_z(by_blocks(from, false), angle_deg), true);
  };
  const Turn turn = light_turn(odd_turn());
  const Sh<RgbD, 6> light = radiance_of(some_coefficients().values);
  const Sh<RgbD, 6> rolled = about_z(about_y(about_z(light, 90), turn.roll_deg), -90);
  const Sh<RgbD, 6> made = about_z(about_y(rolled, -turn.pitch_deg), turn.yaw_deg);
  const Sh<RgbD, 6> expected = rotate(light, turned(turn));
  for (std::size_t i = 0; i < 36; ++i) EXPECT_NEAR(made[i].r, expected[i].r, 1e-13) << i;
}

}  // namespace
}  // namespace zonal
