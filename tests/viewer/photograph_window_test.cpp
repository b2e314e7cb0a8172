// A fisheye photograph in the window: what the panel's picture does under a real pointer.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "tests/viewer/window_fixture_test.h"

namespace zonal {
namespace {

constexpr ImageSize kSize = {200, 160};
constexpr PixelCircle kCircle = {90, 80, 60, 60};

/// A sky that is bright in one direction, in a circle off the middle; black around it.
Environment photograph() {
  Lens lens;
  lens.center_x_px = kCircle.center_x, lens.center_y_px = kCircle.center_y;
  lens.radius_x_px = kCircle.radius_x, lens.radius_y_px = kCircle.radius_y;
  return daylight_sky({Layout::kFisheye, lens}, kSize, {}, {});
}

bool same(const PixelCircle& a, const PixelCircle& b) {
  return a.center_x == b.center_x && a.center_y == b.center_y && a.radius_x == b.radius_x && a.radius_y == b.radius_y;
}

/// Moves and presses the pointer of the display; false where the machine cannot.
bool xdotool(const std::string& what) { return std::system(("xdotool " + what + " 2>/dev/null").c_str()) == 0; }

class PhotographWindowTest : public ViewerWindowTest {
 protected:
  PhotographWindowTest() {
    save_picture(photograph().radiance, folder_ / "garden.hdr");
    window().dropped({folder_ / "garden.hdr"});
    EXPECT_TRUE(frames_until([] { return viewer().photograph() && viewer().photograph()->name == "garden.hdr"; }));
  }
  ~PhotographWindowTest() override {
    viewer().open_light("sky", small_sky);
    EXPECT_TRUE(frames_until([] { return viewer().light_name() == "sky" && viewer().idle(); }));
  }

  static PhotographSettings said() { return viewer().photograph()->said; }
  /// Says that it is a fisheye photograph with this circle, and waits for its light.
  static void light_by(const PixelCircle& circle) {
    PhotographSettings settings = said();
    settings.is_fisheye = true;
    settings.circle = circle;
    viewer().set_photograph(settings);
    EXPECT_TRUE(frames_until([] { return viewer().idle() && viewer().photograph()->applied.is_fisheye; }));
  }
  /// The pointer to a place of the photograph in its panel.
  static bool point_at(PixelPoint p) {
    const FisheyePanel& panel = window().fisheye_panel();
    const auto [left, top] = window().window().position();
    const double x = left + p.x * panel.scale + panel.left, y = top + p.y * panel.scale + panel.top;
    return xdotool(fmt::format("mousemove {:.0f} {:.0f}", x, y));
  }
  static void some_frames() {
    for (int i = 0; i < 6; ++i) {
      window().window().wait(0.02);
      window().frame();
    }
  }
};

TEST_F(PhotographWindowTest, WhatNobodyCanGuessIsAsked) {
  EXPECT_TRUE(is_told("neither its shape nor its name")) << "a picture of 200 x 160 may be anything";
  EXPECT_FALSE(said().is_fisheye);
  EXPECT_NE(viewer().light_name(), "garden.hdr") << "the light stays until somebody says what it is";
  const Image<Rgb8> before = rest();
  keep_window("photograph_asked");
  light_by(kCircle);
  EXPECT_EQ(viewer().light_name(), "garden.hdr");
  EXPECT_GT(changed(before, rest()), 0.3);
  keep_window("photograph");

  PhotographSettings ground = said();
  ground.ground_is_rim = false;
  ground.ground = {0, 0, 0};
  const Image<Rgb8> above_rim = rest();
  viewer().set_photograph(ground);
  EXPECT_TRUE(frames_until([] { return viewer().idle() && !viewer().photograph()->applied.ground_is_rim; }));
  EXPECT_GT(changed(above_rim, rest()), 0.2) << "another ground is another light";
}

TEST_F(PhotographWindowTest, TheCircleFollowsThePointerAndTheLightItsRelease) {
  light_by(kCircle);
  some_frames();
  if (!point_at({kCircle.center_x, kCircle.center_y})) GTEST_SKIP() << "no xdotool";
  const Image<Rgb8> before = rest();
  some_frames();
  ASSERT_TRUE(xdotool("mousedown 1"));
  some_frames();
  EXPECT_EQ(window().fisheye_panel().held, CircleHandle::kCenter);
  ASSERT_TRUE(point_at({kCircle.center_x + 20, kCircle.center_y - 10}));
  some_frames();
  EXPECT_NEAR(window().fisheye_panel().edited.circle.center_x, kCircle.center_x + 20, 1.5);
  EXPECT_TRUE(same(said().circle, kCircle)) << "while it is held, the light waits";
  EXPECT_EQ(viewer().state().camera.yaw_deg, ViewState().camera.yaw_deg) << "the eye does not move with it";
  keep_window("circle_held");
  ASSERT_TRUE(xdotool("mouseup 1"));
  EXPECT_TRUE(frames_until([] { return viewer().idle() && !same(viewer().photograph()->applied.circle, kCircle); }));
  const PixelCircle moved = said().circle;
  EXPECT_NEAR(moved.center_x, kCircle.center_x + 20, 1.5);  // pixels of the window are 0.6 of the photograph's
  EXPECT_NEAR(moved.center_y, kCircle.center_y - 10, 1.5);
  EXPECT_EQ(moved.radius_x, kCircle.radius_x);
  EXPECT_GT(changed(before, rest()), 0.3);

  // A radius, both being one as the circle is round.
  ASSERT_TRUE(point_at(place_of(moved, CircleHandle::kRight)));
  some_frames();
  ASSERT_TRUE(xdotool("mousedown 1"));
  some_frames();
  EXPECT_EQ(window().fisheye_panel().held, CircleHandle::kRight);
  ASSERT_TRUE(point_at({moved.center_x + moved.radius_x - 15, moved.center_y}));
  some_frames();
  ASSERT_TRUE(xdotool("mouseup 1"));
  EXPECT_TRUE(frames_until([&] { return viewer().idle() && viewer().photograph()->applied.circle.radius_x < 50; }));
  EXPECT_NEAR(said().circle.radius_x, moved.radius_x - 15, 1.5);
  EXPECT_EQ(said().circle.radius_y, said().circle.radius_x);
  EXPECT_EQ(said().circle.center_x, moved.center_x);
}

TEST_F(PhotographWindowTest, WhatCannotBeIsAMessageAndTheLastCircleStays) {
  light_by(kCircle);
  PhotographSettings settings = said();
  settings.lens = LensModel::kOrthographic;
  settings.fov_deg = 220;
  viewer().set_photograph(settings);
  EXPECT_TRUE(frames_until([] { return is_told("light: garden.hdr"); }));
  EXPECT_EQ(said().lens, LensModel::kEquidistant);
  EXPECT_EQ(said().fov_deg, 180);

  settings = said();
  settings.circle.radius_x = 30;
  viewer().set_photograph(settings);
  viewer().cancel();
  EXPECT_TRUE(frames_until([] { return is_told("garden.hdr: cancelled"); }));
  EXPECT_EQ(said().circle.radius_x, kCircle.radius_x);
}

}  // namespace
}  // namespace zonal
