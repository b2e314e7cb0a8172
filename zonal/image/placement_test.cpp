#include "zonal/image/placement.h"

#include <gtest/gtest.h>

#include <cmath>

namespace zonal {
namespace {

constexpr PicturePoint kCenter{160, 120};

double distance(PicturePoint a, PicturePoint b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST(Placement, TurnsClockwiseAboutTheCentreAndMoves) {
  const Placing placing({3, -2, 90}, kCenter);
  EXPECT_LT(distance(placing(kCenter), {163, 118}), 1e-12);
  // What is right of the centre comes to lie below it.
  EXPECT_LT(distance(placing({170, 120}), {163, 128}), 1e-12);
}

TEST(Placement, ComposesAndInverts) {
  const Placement first{3.25, -7.5, 1.5}, second{-0.37, 12.6, -4};
  const Placing a(first, kCenter), b(second, kCenter), both(composed(second, first), kCenter),
      back(inverse(first), kCenter);
  int compared = 0;
  for (const PicturePoint p : {PicturePoint{0, 0}, PicturePoint{320, 0}, PicturePoint{17.5, 200.5}, kCenter}) {
    // A few roundings of coordinates below 1000.
    EXPECT_LT(distance(both(p), b(a(p))), 1e-11);
    EXPECT_LT(distance(back(a(p)), p), 1e-11);
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

TEST(Placement, SettlesOnWholeTexelsOnlyWhereAllAreNear) {
  EXPECT_EQ(settled({4.96, -2.02, 0}, 320, 240, 0.05), (Placement{5, -2, 0}));
  EXPECT_TRUE(is_whole(settled({4.96, -2.02, 0.002}, 320, 240, 0.055)));  // corners: 200 px, 0.007 px
  const Placement shifted{4.9, -2, 0}, turned{5, -2, 0.05};               // the corners of the second by 0.17 px
  EXPECT_EQ(settled(shifted, 320, 240, 0.05), shifted);
  EXPECT_EQ(settled(turned, 320, 240, 0.05), turned);
  EXPECT_FALSE(is_whole(turned));
}

}  // namespace
}  // namespace zonal
