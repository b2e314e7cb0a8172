#include "apps/viewer/circle_drag.h"

#include <gtest/gtest.h>

#include <array>

namespace zonal {
namespace {

constexpr ImageSize kPicture = {640, 480};
constexpr PixelCircle kCircle = {300, 250, 200, 180};

void expect_circle(const PixelCircle& is, const PixelCircle& meant) {
  EXPECT_DOUBLE_EQ(is.center_x, meant.center_x);
  EXPECT_DOUBLE_EQ(is.center_y, meant.center_y);
  EXPECT_DOUBLE_EQ(is.radius_x, meant.radius_x);
  EXPECT_DOUBLE_EQ(is.radius_y, meant.radius_y);
}

TEST(CircleDrag, AHandleIsFoundWhereItIs) {
  constexpr std::array kHandles = {CircleHandle::kCenter, CircleHandle::kRight, CircleHandle::kLeft, CircleHandle::kTop,
                                   CircleHandle::kBottom};
  for (const CircleHandle handle : kHandles) {
    const PixelPoint place = place_of(kCircle, handle);
    EXPECT_EQ(handle_at(kCircle, place, 10), handle);
    EXPECT_EQ(handle_at(kCircle, {place.x + 6, place.y - 7}, 10), handle);
  }
  EXPECT_EQ(place_of(kCircle, CircleHandle::kTop).y, 70);
  EXPECT_EQ(place_of(kCircle, CircleHandle::kLeft).x, 100);
}

TEST(CircleDrag, InsideOfTheCircleIsTheCentreAndBesideItNothing) {
  EXPECT_EQ(handle_at(kCircle, {400, 300}, 10), CircleHandle::kCenter);
  EXPECT_EQ(handle_at(kCircle, {511, 250}, 10), CircleHandle::kNone);
  EXPECT_EQ(handle_at(kCircle, {450, 400}, 10), CircleHandle::kNone) << "in the corner of the square around it";
  EXPECT_EQ(handle_at(kCircle, {491, 250}, 10), CircleHandle::kRight);
  EXPECT_EQ(handle_at(kCircle, {489, 250}, 10), CircleHandle::kCenter);
}

TEST(CircleDrag, OfASmallCircleTheNearestHandleCounts) {
  constexpr PixelCircle kSmall = {100, 100, 8, 8};
  EXPECT_EQ(handle_at(kSmall, {106, 100}, 20), CircleHandle::kRight);
  EXPECT_EQ(handle_at(kSmall, {103, 100}, 20), CircleHandle::kCenter);
}

TEST(CircleDrag, TheCentreMovesAndTheRadiiStay) {
  expect_circle(dragged_circle(kCircle, CircleHandle::kCenter, 15, -20, false, kPicture), {315, 230, 200, 180});
  expect_circle(dragged_circle(kCircle, CircleHandle::kCenter, 900, -900, false, kPicture), {639.5, 0.5, 200, 180});
}

TEST(CircleDrag, ARadiusGrowsAwayFromTheCentre) {
  expect_circle(dragged_circle(kCircle, CircleHandle::kRight, 12, 99, false, kPicture), {300, 250, 212, 180});
  expect_circle(dragged_circle(kCircle, CircleHandle::kLeft, 12, 99, false, kPicture), {300, 250, 188, 180});
  expect_circle(dragged_circle(kCircle, CircleHandle::kTop, 99, -5, false, kPicture), {300, 250, 200, 185});
  expect_circle(dragged_circle(kCircle, CircleHandle::kBottom, 99, -5, false, kPicture), {300, 250, 200, 175});
}

TEST(CircleDrag, ARoundCircleStaysRound) {
  expect_circle(dragged_circle(kCircle, CircleHandle::kRight, 10, 0, true, kPicture), {300, 250, 210, 210});
  expect_circle(dragged_circle(kCircle, CircleHandle::kBottom, 0, 10, true, kPicture), {300, 250, 190, 190});
}

TEST(CircleDrag, HasLimits) {
  expect_circle(dragged_circle(kCircle, CircleHandle::kRight, -500, 0, false, kPicture), {300, 250, 1, 180});
  expect_circle(dragged_circle(kCircle, CircleHandle::kBottom, 0, 5000, true, kPicture), {300, 250, 640, 640});
  expect_circle(dragged_circle(kCircle, CircleHandle::kNone, 30, 30, true, kPicture), kCircle);
  expect_circle(limited_circle({-3, 700, 0, 1e9}, kPicture), {0.5, 479.5, 1, 640});
}

}  // namespace
}  // namespace zonal
