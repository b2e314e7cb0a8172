#include "zonal/light/synthetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/light/sample.h"
#include "zonal/light/synthetic_stroke.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr Layout kSome[] = {Layout::kEquirect,   Layout::kCubeCross, Layout::kOctahedral,
                            Layout::kMirrorBall, Layout::kAngular,   Layout::kDualParaboloid};

RgbD energy(const Environment& e) {
  const Mapping mapping(e.projection, {e.radiance.width(), e.radiance.height()});
  RgbD sum;
  for (int y = 0; y < e.radiance.height(); ++y) {
    for (int x = 0; x < e.radiance.width(); ++x) sum += mapping.solid_angle(x, y) * RgbD(e.radiance(x, y));
  }
  return sum;
}

TEST(Synthetic, FurnaceAndGradient) {
  int compared = 0;
  for (const Layout layout : kSome) {
    const ImageSize size = image_size(layout, 24);
    const Environment white = furnace({layout}, size, {2, 3, 4}), sky = gradient({layout}, size);
    const Mapping mapping({layout}, size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto d = mapping.texel_direction(x, y);
        if (d) {
          ASSERT_EQ(white.radiance(x, y), (Rgb{2, 3, 4}));
          ASSERT_FLOAT_EQ(sky.radiance(x, y).g, static_cast<float>(1 + d->x + 0.5 * d->y));
          ++compared;
        } else {
          ASSERT_EQ(white.radiance(x, y), Rgb{});
        }
      }
    }
  }
  EXPECT_GT(compared, 5000);
}

TEST(SlowSynthetic, TheSunsEnergyIsExactAtAnySize) {
  int compared = 0;
  for (const Layout layout : kSome) {
    for (const int size : {8, 32, 200}) {
      for (const double diameter : {0.05, 0.53, 12.0, 170.0}) {
        const SunOptions options = {
            .toward_sun = normalize({0.3, -0.5, 0.4}), .diameter_deg = diameter, .contrast = 1e4};
        const Environment e = sun({layout}, image_size(layout, size), options);
        const double half = std::sin(radians(diameter) / 4), disc = 4 * kPi * half * half;
        // Each texel is a float.
        EXPECT_NEAR(energy(e).g, 4 * kPi + (1e4 - 1) * disc, 1e-6 * (4 * kPi + 1e4 * disc)) << name_of(layout) << size;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 6 * 3 * 4);
}

TEST(Synthetic, TheSunStandsWhereItShould) {
  const SunOptions options = {.toward_sun = normalize({0.3, -0.5, 0.4}), .diameter_deg = 5, .contrast = 1e4};
  const Environment e = sun({}, {256, 128}, options);
  const Mapping mapping({}, {256, 128});
  int inside = 0, outside = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 256; ++x) {
      const double angle = degrees(angle_between(*mapping.direction(center_of({x, y})), options.toward_sun));
      // A texel's diagonal is two degrees.
      if (angle < 1.4) {
        EXPECT_FLOAT_EQ(e.radiance(x, y).r, 1e4f);
        ++inside;
      }
      if (angle > 3.6) {
        EXPECT_EQ(e.radiance(x, y).r, 1);
        ++outside;
      }
    }
  }
  EXPECT_GE(inside, 2);
  EXPECT_GT(outside, 32000);
}

TEST(Synthetic, CheckerIsHalfWhite) {
  const Environment e = checker({}, {144, 72}, 15, {2, 2, 2});
  EXPECT_NEAR(energy(e).r / (4 * kPi), 1, 1e-3);
  EXPECT_EQ(e.radiance(72 - 3, 36 - 3), (Rgb{2, 2, 2}));  // azimuth and elevation in 0..15
  EXPECT_EQ(e.radiance(72 + 3, 36 - 3), (Rgb{0, 0, 0}));
}

TEST(Synthetic, DaylightIsPlausible) {
  int compared = 0;
  for (const double elevation : {2.0, 10.0, 35.0, 60.0, 90.0}) {
    for (const double turbidity : {2.0, 3.0, 6.0, 10.0}) {
      const DaylightOptions options = {.elevation_deg = elevation, .turbidity = turbidity, .sun = false};
      const Environment e = daylight_sky({}, {128, 64}, options);
      for (const Rgb& c : e.radiance.values()) {
        ASSERT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b));
        ASSERT_GE(std::min({c.r, c.g, c.b}), 0);
        // No cloudless sky exceeds this beside its sun, in kcd/m².
        ASSERT_LT(luminance(c), 300) << elevation << " " << turbidity;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 20 * 128 * 64);
}

TEST(Synthetic, DaylightHasTheZenithOfThePaper) {
  // Preetham et al. 1999, A.2: zenith luminance at turbidity 3, sun 35 degrees up, by hand:
  // chi = (4/9 - 3/120)(pi - 2 * 55 deg in radians) = 0.51245, Yz = 7.1649 tan chi - 0.6465 + 2.4192 = 5.8029 kcd/m².
  const Environment e = daylight_sky({}, {512, 256}, {.elevation_deg = 35, .turbidity = 3, .sun = false});
  EXPECT_NEAR(luminance(Sampler(e)({0, 0, 1})), 5.803, 0.01);
}

TEST(Synthetic, DaylightIsBlueAwayFromTheSunAndTheSunIsBright) {
  const Environment e = daylight_sky({}, {1024, 512}, {.elevation_deg = 35});
  const Sampler sample(e);
  const Rgb zenith = sample({0, 0, 1}), away = sample(normalize({-1, 0, 1}));
  EXPECT_GT(zenith.b, zenith.r);
  EXPECT_GT(away.b, 1.3f * away.r);
  float brightest = 0;
  for (const Rgb& c : e.radiance.values()) brightest = std::max(brightest, luminance(c));
  EXPECT_GT(brightest, 2e5f);
  EXPECT_LT(brightest, 3e6f);
  // Near sea level a clear sky's sun and sky give some 60..120 klx on a surface that faces the sun.
  const Vec3 toward_sun = {std::cos(radians(35)), 0, std::sin(radians(35))};
  const Mapping mapping({}, {1024, 512});
  double illuminance = 0;
  for (int y = 0; y < 512; ++y) {
    for (int x = 0; x < 1024; ++x) {
      const double cosine = dot(*mapping.direction(center_of({x, y})), toward_sun);
      if (cosine > 0) illuminance += cosine * mapping.solid_angle(x, y) * luminance(e.radiance(x, y));
    }
  }
  EXPECT_GT(illuminance, 60);
  EXPECT_LT(illuminance, 130);
}

TEST(Synthetic, DaylightRefusesNight) {
  EXPECT_THROW(daylight_sky({}, {16, 8}, {.elevation_deg = -1}), Error);
  EXPECT_THROW(daylight_sky({}, {16, 8}, {.turbidity = 1}), Error);
  EXPECT_THROW(sun({}, {16, 8}, {.diameter_deg = 0}), Error);
}

TEST(TestCard, SidesHaveTheirColoursInEveryProjection) {
  int compared = 0;
  for (const Layout layout : kSome) {
    const Environment e = testcard({layout}, image_size(layout, 128));
    const Sampler sample(e);
    const auto at = [&](double x, double y, double z) {
      ++compared;
      return sample(normalize({x, y, z}));
    };
    // Away from grid lines and letters.
    Rgb c = at(1, 0.6, 0.72);
    EXPECT_GT(c.r, 3 * std::max(c.g, c.b)) << name_of(layout);
    c = at(0.6, 1, 0.72);
    EXPECT_GT(c.g, 3 * std::max(c.r, c.b)) << name_of(layout);
    c = at(0.6, 0.72, 1);
    EXPECT_GT(c.b, 2 * std::max(c.r, c.g)) << name_of(layout);
    c = at(-1, -0.6, -0.72);
    EXPECT_GT(std::min(c.g, c.b), 3 * c.r) << name_of(layout);
    for (const Rgb& texel : e.radiance.values()) {
      ASSERT_GE(std::min({texel.r, texel.g, texel.b}), 0);
      ASSERT_LE(std::max({texel.r, texel.g, texel.b}), 1);
    }
  }
  EXPECT_EQ(compared, 24);
}

TEST(TestCard, LettersReadUprightAndUnmirroredFromInside) {
  // "+Y" at the +Y axis: seen from the origin, right is -X x ... the plus stands left, toward -X's other side.
  const SphereText text("+Y", {0, 1, 0}, {0, 0, 1}, 0.5);
  const auto at = [&](double right, double up) { return text.covers(normalize({right, 1, up})); };  // right of +Y is +X
  EXPECT_TRUE(at(-0.1875, 0));           // the middle of the plus
  EXPECT_TRUE(at(0.1875, -0.2));         // the foot of the Y
  EXPECT_FALSE(at(0.1875, 0.2));         // between its arms
  EXPECT_TRUE(at(0.1875 + 0.12, 0.24));  // its right arm
  EXPECT_FALSE(at(-0.1875 + 0.1, 0.2));
  EXPECT_FALSE(text.covers({0, -1, 0}));
  EXPECT_THROW(SphereText("Q", {0, 1, 0}, {0, 0, 1}, 0.5), std::logic_error);
}

}  // namespace
}  // namespace zonal
