#include "zonal/sphere/disc.h"

#include <gtest/gtest.h>

#include "zonal/sphere/every_projection.h"

namespace zonal {
namespace {

/// The textbook forms of the four laws, up to scale.
double radius_by_the_book(LensModel model, double theta) {
  switch (model) {
    case LensModel::kEquidistant:
      return theta;
    case LensModel::kEquisolid:
      return std::sin(theta / 2);
    case LensModel::kStereographic:
      return std::tan(theta / 2);
    case LensModel::kOrthographic:
      return std::sin(theta);
  }
  return 0;
}

TEST(RadialLaw, FollowsTheBookBothWays) {
  int compared = 0;
  for (const LensModel model :
       {LensModel::kEquidistant, LensModel::kEquisolid, LensModel::kStereographic, LensModel::kOrthographic}) {
    const double limit = model == LensModel::kOrthographic ? kPi / 2 : 3.1;
    for (const double theta_max : {0.3, 1.2, limit}) {
      const RadialLaw law(model, theta_max);
      for (double theta = 0; theta <= theta_max; theta += theta_max / 64) {
        const double r = radius_by_the_book(model, theta) / radius_by_the_book(model, theta_max);
        EXPECT_NEAR(law.radius(std::cos(theta), std::sin(theta)), r, 1e-13);
        const auto [cosine, sine_over_radius] = law.polar(r);
        EXPECT_NEAR(cosine, std::cos(theta), 1e-7);  // the root of rounding at an orthographic rim
        EXPECT_NEAR(sine_over_radius * r, std::sin(theta), 1e-7);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 700);
}

TEST(RadialLaw, FansAddUpAndAgreeWithManySmallOnes) {
  Spread spread;
  int compared = 0;
  for (const LensModel model :
       {LensModel::kEquidistant, LensModel::kEquisolid, LensModel::kStereographic, LensModel::kOrthographic}) {
    const RadialLaw law(model, model == LensModel::kOrthographic    ? kPi / 2
                               : model == LensModel::kStereographic ? 2.9
                                                                    : kPi);
    for (int i = 0; i < 60; ++i) {
      const auto random_point = [&] {
        const double r = std::sqrt(spread.uniform(0, 1)), phi = spread.uniform(-kPi, kPi);
        return DiscPoint{r * std::cos(phi), r * std::sin(phi)};
      };
      const DiscPoint a = random_point(), b = random_point();
      const auto at = [&](double t) { return DiscPoint{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
      double pieces = 0, sectors = 0;
      const int count = 4000;
      for (int k = 0; k < count; ++k) {
        const DiscPoint p = at(k / double(count)), q = at((k + 1) / double(count)), m = at((k + 0.5) / count);
        if (k % 40 == 0) pieces += law.fan(p, at((k + 40) / double(count)));
        sectors += (1 - law.polar(std::hypot(m.x, m.y)).cosine) * std::atan2(cross(p, q), dot(p, q));
      }
      const double whole = law.fan(a, b);
      EXPECT_NEAR(pieces, whole, 1e-13);  // 100 sums of numbers up to 2π
      EXPECT_NEAR(sectors, whole, 1e-5);  // midpoint rule of 4000 steps
      EXPECT_NEAR(law.fan(b, a), -whole, 1e-14);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 240);
}

TEST(Disc, ClippedRectanglesTileTheCap) {
  // Grids laid over the circle in every position: corners on the rim, tangents, single cells around everything.
  Spread spread;
  int grids = 0;
  for (const LensModel model :
       {LensModel::kEquidistant, LensModel::kEquisolid, LensModel::kStereographic, LensModel::kOrthographic}) {
    const RadialLaw law(model, 1.5);
    const double cap = 2 * kPi * law.rim_fan();
    for (const double cell : {0.01 + 1.0 / 7, 0.25, 0.5, 0.6, 0.8, 1.0, 2.0, 3.0}) {
      for (int shift = 0; shift < 6; ++shift) {
        const double x0 = shift == 0 ? -3 : -3 - spread.uniform(0, cell),
                     y0 = shift < 2 ? -3 : -3 - spread.uniform(0, cell);
        double sum = 0;
        for (double y = y0; y < 3; y += cell) {
          for (double x = x0; x < 3; x += cell) sum += clipped_solid_angle(law, {x, y}, {x + cell, y + cell});
        }
        EXPECT_NEAR(sum, cap, 1e-12 * cap) << name_of(model) << " " << cell << " " << shift;
        ++grids;
      }
    }
  }
  EXPECT_EQ(grids, 4 * 8 * 6);
}

TEST(Disc, SliversAtTangentsAreHarmless) {
  // Cell borders that miss, touch or barely cut the rim.
  const RadialLaw law(LensModel::kEquisolid, kPi);
  int checked = 0;
  for (const double cut : {-1e-3, -1e-8, -1e-11, -1e-13, -1e-15, 0.0, 1e-15, 1e-13, 1e-11, 1e-8, 1e-3}) {
    const double border = 1 + cut;
    const double inside = clipped_solid_angle(law, {-2, -2}, {border, 2});
    const double outside = clipped_solid_angle(law, {border, -2}, {2, 2});
    EXPECT_NEAR(inside + outside, 4 * kPi, 1e-13 * 4 * kPi) << cut;
    EXPECT_LE(outside, cut < 0 ? 4 * 2 * std::pow(-2 * cut, 1.5) : 1e-14)
        << cut;  // 4 x a segment's area, 2/3 of its box
    ++checked;
  }
  EXPECT_EQ(checked, 11);
}

TEST(Disc, LensDefaultsFillThePicture) {
  // 100 x 60: the largest centred circle has a radius of 30.
  const Mapping picture({Layout::kFisheye}, {100, 60});
  EXPECT_LT(angle_between(*picture.direction({50, 30}), {0, 0, 1}), 1e-15);
  EXPECT_LT(angle_between(*picture.direction({50, 0}), {1, 0, 0}), 1e-15);
  EXPECT_LT(angle_between(*picture.direction({80, 30}), {0, 1, 0}), 1e-15);
  EXPECT_FALSE(picture.direction({85, 30}));
  EXPECT_FALSE(picture.position({0, 0.6, -0.8}));
  EXPECT_FALSE(picture.covers_sphere());

  // An ellipse that leaves the picture: what is cut off is not shown.
  const Mapping cropped({Layout::kFisheye, {LensModel::kEquidistant, 180, 50, 30, 60, 40}}, {100, 60});
  EXPECT_TRUE(cropped.direction({0.5, 30}));
  EXPECT_FALSE(cropped.position({1, 0, 0}));
  const auto quarter = cropped.position(normalize({1, 0, 1}));
  ASSERT_TRUE(quarter);
  EXPECT_NEAR(quarter->y, 30 - 20, 1e-12);
}

TEST(Disc, DualFisheyeCirclesLieAtTheSamePlaceOfTheirHalves) {
  const Mapping picture({Layout::kDualFisheye, {LensModel::kEquidistant, 190, 470, 480, 440}}, {1920, 1080});
  EXPECT_LT(angle_between(*picture.direction({470, 480}), {1, 0, 0}), 1e-15);
  EXPECT_LT(angle_between(*picture.direction({960 + 470, 480}), {-1, 0, 0}), 1e-15);
  EXPECT_TRUE(picture.covers_sphere());
  // The left circle's right and the right circle's left show the same side.
  const double edge = 440 * 90 / 95.0;
  EXPECT_LT(angle_between(*picture.direction({470 + edge, 480}), {0, -1, 0}), 1e-14);
  EXPECT_LT(angle_between(*picture.direction({960 + 470 - edge, 480}), {0, -1, 0}), 1e-14);
}

TEST(Disc, RimTexelsWithoutTheirCentreShowTheRim) {
  const int n = 32;
  const Mapping picture({Layout::kFisheye}, {n, n});
  int checked = 0;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (picture.direction({x + 0.5, y + 0.5}) || picture.solid_angle(x, y) == 0) continue;
      const auto d = picture.texel_direction(x, y);
      ASSERT_TRUE(d);
      EXPECT_NEAR(d->z, 0, 1e-15);  // 180 degrees: the rim is the horizon
      EXPECT_NEAR(std::atan2(d->y, d->x), std::atan2(x + 0.5 - n / 2, n / 2 - y - 0.5), 1e-14);
      ++checked;
    }
  }
  EXPECT_GT(checked, 30);
}

}  // namespace
}  // namespace zonal
