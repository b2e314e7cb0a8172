#include "zonal/light/fisheye_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "zonal/base/error.h"
#include "zonal/light/fisheye_means.h"
#include "zonal/light/fisheye_study.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

/// A sky without symmetry that is brightest on one side.
Environment photograph(int size, const Lens& lens = {}) {
  Environment e{Image<Rgb>(size, size), {Layout::kFisheye, lens}};
  const Mapping mapping(e.projection, {size, size});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const auto d = mapping.texel_direction(x, y);
      if (!d) continue;
      const float r = static_cast<float>(0.6 + 0.3 * d->y), g = static_cast<float>(0.4 + 0.3 * d->x * d->y);
      e.radiance(x, y) = {r, g, static_cast<float>(0.5 + 0.4 * d->z)};
    }
  }
  return e;
}

double difference(Rgb a, RgbD b) { return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}); }

TEST(FisheyeLight, ParaboloidsAreTheDirectSums) {
  const Environment e = photograph(128);
  const Rgb ground{0.2f, 0.1f, 0.3f};
  const std::vector<double> shininess = {1, 20};
  constexpr int kSize = 16;
  int compared = 0;
  for (const auto outside : {FisheyeOutside::kGround, FisheyeOutside::kExtended, FisheyeOutside::kTwo}) {
    const FisheyeLight light(e, ground, shininess, outside);
    const Mapping mapping(sky_paraboloid(kSize, true), {kSize, kSize});
    for (int i = 0; i < 2; ++i) {
      const Image<Rgb> map = light.paraboloid(i, kSize);
      ASSERT_EQ(map.width(), outside == FisheyeOutside::kTwo ? 2 * kSize : kSize);
      std::vector<Vec3> toward;
      for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < map.width(); ++x) {
          // The paraboloid's formula, of pixel centres.
          const double u = (x % kSize + 0.5) / kSize - 0.5, v = 0.5 - (y + 0.5) / kSize, m = u * u + v * v;
          const Vec3 d{v / (0.25 + m), u / (0.25 + m), (0.25 - m) / (0.25 + m)};
          EXPECT_LT(length(d - *mapping.direction({x % kSize + 0.5, y + 0.5})), 1e-12);
          toward.push_back(x < kSize ? d : Vec3{d.x, d.y, -d.z});
        }
      }
      const auto exact = fisheye_means(e, {.shininess = shininess[i], .ground = ground}, toward);
      for (std::size_t k = 0; k < toward.size(); ++k, ++compared) {
        const bool hidden = outside == FisheyeOutside::kGround && toward[k].z < -1e-9;
        // Texels of a degree and a half at a horizon that is a jump of half the sky.
        EXPECT_LT(difference(map.values()[k], hidden ? RgbD(ground) : exact[k]), 0.006) << i << " " << k;
      }
    }
  }
  EXPECT_EQ(compared, 2 * kSize * kSize * 4);
}

TEST(FisheyeLight, TakesOtherLenses) {
  const Lens lens{LensModel::kEquisolid, 150};
  const Environment e = photograph(96, lens);
  const FisheyeLight light(e, {0.2f, 0.2f, 0.2f}, {1}, FisheyeOutside::kExtended);
  const Image<Rgb> map = light.paraboloid(0, 9);
  const Vec3 up{0, 0, 1};
  const RgbD exact = fisheye_means(e, {.shininess = 1, .ground = {0.2f, 0.2f, 0.2f}}, {&up, 1})[0];
  EXPECT_LT(difference(map(4, 4), exact), 0.004);
  EXPECT_THROW(fisheye_study(e, {1}, {}), Error);
}

TEST(FisheyeStudy, SaysWhatEachErrorContributes) {
  // A constant sky over black ground: all weights agree on the sky, so that the ground is all that is wrong.
  Environment e = photograph(64);
  for (Rgb& texel : e.radiance.values()) texel = {1, 1, 1};
  const std::vector<FisheyeStudy> studies = fisheye_study(e, {1, 10}, {.ground = {0, 0, 0}, .size_px = 16});
  ASSERT_EQ(studies.size(), 2u);
  for (const FisheyeStudy& study : studies) {
    EXPECT_LT(study.weights_alone.most, 1e-5);
    EXPECT_GT(study.total.most, 0.2);
    EXPECT_GT(study.ground_alone.rms, study.total.rms);  // to correct the weights only makes it worse
    EXPECT_LT(study.library.most, 0.005);
    EXPECT_EQ(study.published.cube.radiance.height(), 6 * 8);
    EXPECT_EQ(study.corrected.equirect.radiance.width(), 32);
  }
  // Ground as bright as the sky: nothing is wrong.
  const FisheyeStudy same = fisheye_study(e, {1}, {.ground = {1, 1, 1}, .size_px = 16})[0];
  EXPECT_LT(std::max({same.total.most, same.weights_alone.most, same.ground_alone.most, same.library.most}), 1e-4);
}

TEST(FisheyeStudy, ASmallerPhotographShowsTheSame) {
  const Environment e = photograph(101), small = smaller_photograph(e, 3);
  EXPECT_EQ(small.radiance.width(), 34);
  const std::vector<Vec3> toward = {{0, 0, 1}, {0.6, 0, 0.8}, {0, 0.8, 0.6}};
  const auto expected = fisheye_means(e, {.shininess = 2}, toward),
             got = fisheye_means(small, {.shininess = 2}, toward);
  ASSERT_EQ(got.size(), 3u);
  // Blocks of black at the rim.
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(difference(Rgb(got[i]), expected[i]), 0.02) << i;
}

TEST(FisheyeStudy, CodesAreNotLight) {
  Environment e = photograph(64);
  for (Rgb& texel : e.radiance.values()) texel = {0.5f, 0.5f, 0.5f};
  EXPECT_LT(error_of_averaging_codes(e, {0.5f, 0.5f, 0.5f}, 1).most, 1e-5);
  // Half black, half white: codes average to 0.5, a fifth of the light.
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) e.radiance(x, y) = x < 32 ? Rgb{0, 0, 0} : Rgb{1, 1, 1};
  }
  EXPECT_GT(error_of_averaging_codes(e, {0, 0, 0}, 1).most, 0.25);
}

}  // namespace
}  // namespace zonal
