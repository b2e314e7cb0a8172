#include "zonal/light/convolve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "zonal/base/error.h"
#include "zonal/light/reference.h"
#include "zonal/light/render.h"
#include "zonal/light/synthetic.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/zonal.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr Projection kPanorama{Layout::kEquirect};
constexpr Projection kCube{Layout::kCubeStack};

ImageSize cube(int face) { return image_size(Layout::kCubeStack, face); }

/// Clouds: every texel its own brightness, so that all frequencies of the grid are there.
Environment clouds(int height) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.5f, 1.5f);
  Environment sky{Image<Rgb>(2 * height, height), kPanorama};
  for (Rgb& texel : sky.radiance.values()) texel = {uniform(random), uniform(random), 0.1f * uniform(random)};
  return sky;
}

struct Comparison {
  int compared = 0;
  double rms = 0;             // relative to the value
  double worst_absolute = 0;  // in the map's unit
  float lowest = std::numeric_limits<float>::infinity();
};

/// A convolved picture against the brute-force sum over the texels of its source, at `count` of its texels spread over
/// it.
Comparison compare(const Environment& source, const Lobe& lobe, const Environment& convolved, int count) {
  const ImageSize size{convolved.radiance.width(), convolved.radiance.height()};
  const Mapping mapping(convolved.projection, size);
  std::mt19937 random(7);
  std::vector<Vec3> directions;
  std::vector<Rgb> got;
  while (static_cast<int>(directions.size()) < count) {
    const int x = static_cast<int>(random() % size.width), y = static_cast<int>(random() % size.height);
    const auto toward = mapping.direction({x + 0.5, y + 0.5});
    if (!toward) continue;
    directions.push_back(*toward);
    got.push_back(convolved.radiance(x, y));
  }
  const std::vector<RgbD> expected = convolve_at(source, lobe, directions);
  Comparison result;
  double squares = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double error = got[i].r - expected[i].r;
    squares += std::pow(error / expected[i].r, 2);
    result.worst_absolute = std::max(result.worst_absolute, std::abs(error));
    ++result.compared;
  }
  for (const Rgb& texel : convolved.radiance.values())
    result.lowest = std::min({result.lowest, texel.r, texel.g, texel.b});
  result.rms = std::sqrt(squares / result.compared);
  return result;
}

std::vector<Lobe> all_lobes() {
  return {Lobe::cosine(),  Lobe::ggx(0.05),       Lobe::ggx(0.3),     Lobe::ggx(1),
          Lobe::phong(40), Lobe::blinn_phong(60), Lobe::charlie(0.5), Lobe::gaussian(0.1)};
}

TEST(Convolve, AgreesWithTheBruteForceSumForEveryLobe) {
  const Environment sky = clouds(64);
  for (const Lobe& lobe : all_lobes()) {
    const Convolved result = convolve(sky, lobe, kCube, cube(16));
    const Comparison c = compare(sky, lobe, result.map, 40);
    EXPECT_EQ(c.compared, 40);
    EXPECT_LT(c.rms, 5e-5) << name_of(lobe.kind());
    // A unit in the last place of a float beside the bound.
    EXPECT_LE(c.worst_absolute, result.report.error_bound + 1e-6) << name_of(lobe.kind());
    EXPECT_LT(result.report.bound_to_mean, 1e-3) << name_of(lobe.kind());
  }
}

TEST(Convolve, AFurnaceStaysWhiteInEveryProjection) {
  int projections = 0;
  for (const Layout layout : all_layouts()) {
    if (layout == Layout::kFisheye) continue;  // shows half the sphere: the rest is dark
    const Environment source = furnace({layout}, image_size(layout, 32));
    for (const Lobe& lobe : {Lobe::cosine(), Lobe::ggx(0.2)}) {
      const Convolved result = convolve(source, lobe, kCube, cube(8));
      for (const Rgb& texel : result.map.radiance.values()) ASSERT_NEAR(texel.g, 1, 1e-6) << name_of(layout);
    }
    ++projections;
  }
  EXPECT_GE(projections, 12);
}

TEST(Convolve, ALinearSkyIsScaledByTheFirstFactor) {
  // 1 + x + y/2 has bands 0 and 1 only: the cosine leaves 1 + 2/3 (x + y/2). Texel areas sum it with an error of the
  // square of the texel.
  const int height = 256;
  const Environment sky = gradient(kPanorama, {2 * height, height});
  const Convolved result = convolve(sky, Lobe::cosine(), kCube, cube(16));
  const Mapping mapping(kCube, cube(16));
  int compared = 0;
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 16; ++x) {
      const Vec3 d = *mapping.direction({x + 0.5, y + 0.5});
      EXPECT_NEAR(result.map.radiance(x, y).r, 1 + (d.x + d.y / 2) * 2 / 3, std::pow(kPi / height, 2) / 8);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 1536);
}

TEST(SlowConvolve, EveryProjectionGivesTheSameMap) {
  // A function of eight bands, drawn in each projection, has a known convolution. What is left is the step to a ring
  // grid: linear or cubic between texels, so the square of a texel.
  Sh<RgbD> sh(8);
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (RgbD& c : sh.values()) c = {normal(random), normal(random), normal(random)};
  const int size = 96;
  int projections = 0;
  for (const Layout layout : all_layouts()) {
    if (layout == Layout::kFisheye) continue;
    const Environment source = render(sh, {layout}, image_size(layout, size));
    for (const Lobe& lobe : {Lobe::ggx(0.1), Lobe::cosine()}) {
      const Sh<RgbD> expected = convolve(sh, band_factors(lobe, 8));
      const Convolved result = convolve(source, lobe, kCube, cube(8));
      const Mapping mapping(kCube, cube(8));
      double squares = 0, worst = 0;
      for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 8; ++x) {
          const double error =
              result.map.radiance(x, y).g - evaluate(expected, *mapping.direction({x + 0.5, y + 0.5})).g;
          squares += error * error / (6 * 64);
          worst = std::max(worst, std::abs(error));
        }
      }
      // The function's own size is about 3. A ball of 96 pixels does not see a cap of 0.4 radians behind it; there it
      // is a guess.
      const bool ball = layout == Layout::kMirrorBall || layout == Layout::kSphereMap;
      EXPECT_LT(std::sqrt(squares), ball ? 0.06 : 2e-3) << name_of(layout);
      EXPECT_LT(worst, ball ? 0.6 : 2e-2) << name_of(layout);
      RecordProperty(std::string(name_of(layout)) + "_rms", std::to_string(std::sqrt(squares)));
    }
    ++projections;
  }
  EXPECT_EQ(projections, static_cast<int>(all_layouts().size()) - 1);
}

/// A sun a million times brighter than its sky, over a grid too small for it: no ring, nothing negative, right
/// everywhere.
void expect_clean_sun(int height, double alpha, double contrast) {
  const Environment sky = sun(kPanorama, {2 * height, height}, {.diameter_deg = 0.5, .contrast = contrast});
  const Convolved result = convolve(sky, Lobe::ggx(alpha), kCube, cube(16));
  const Comparison c = compare(sky, Lobe::ggx(alpha), result.map, 60);
  EXPECT_EQ(c.compared, 60);
  EXPECT_LT(c.rms, 1e-5) << "alpha " << alpha << ", height " << height;
  EXPECT_LE(c.worst_absolute, result.report.error_bound + 1e-6 * contrast);
  EXPECT_GE(c.lowest, 0.999f) << "darker than the sky, which is 1";
  EXPECT_EQ(result.report.zeroed_texels, 0);
  EXPECT_GT(result.report.points, 0);
}

TEST(Convolve, ASunDoesNotRingAtAnyRoughness) {
  for (const double roughness : {0.125, 0.25, 0.5, 0.75, 1.0}) expect_clean_sun(128, roughness * roughness, 1e6);
}

TEST(SlowConvolve, ASunOfManyTexelsDoesNotRing) {
  for (const double alpha : {0.03, 0.25, 1.0}) expect_clean_sun(1024, alpha, 1e6);
}

TEST(Convolve, ASunInABlackSkyIsNeverNegative) {
  const Environment sky = sun(kPanorama, {256, 128}, {.sky = {1e-6f, 1e-6f, 1e-6f}, .contrast = 1e12});
  for (const Lobe& lobe : all_lobes()) {
    const Convolved result = convolve(sky, lobe, kCube, cube(16));
    int texels = 0;
    for (const Rgb& texel : result.map.radiance.values()) {
      EXPECT_GE(texel.r, 0);
      ++texels;
    }
    EXPECT_EQ(texels, 1536);
    EXPECT_LE(result.report.zeroed_depth, result.report.error_bound);
  }
}

TEST(Convolve, NegativeRadianceKeepsItsEnergyAndIsNotCutOff) {
  Environment sky = furnace(kPanorama, {64, 32});
  for (int x = 0; x < 20; ++x) sky.radiance(x, 16) = {-50, 1, 1};
  const Convolved result = convolve(sky, Lobe::ggx(0.1), kPanorama, {64, 32});
  float lowest = 0;
  double mean = 0, source_mean = 0;
  const Mapping mapping(kPanorama, {64, 32});
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      lowest = std::min(lowest, result.map.radiance(x, y).r);
      mean += mapping.solid_angle(x, y) * result.map.radiance(x, y).r;
      source_mean += mapping.solid_angle(x, y) * sky.radiance(x, y).r;
    }
  }
  EXPECT_LT(lowest, 0);
  EXPECT_EQ(result.report.zeroed_texels, 0);
  // Texel areas see the convolved map's first band 24 (H/π)² times as well as it is smooth: a thousandth here.
  EXPECT_NEAR(mean, source_mean, 2e-3 * 4 * kPi);
}

TEST(SlowConvolve, ALobeSharperThanTheBandsIsWidenedAndSaysSo) {
  const Environment sky = sun(kPanorama, {512, 256}, {.diameter_deg = 2, .contrast = 1e5});
  ConvolveOptions options;
  options.max_bands = 512;
  const Convolved sharp = convolve(sky, Lobe::ggx(0.001), kCube, cube(64), options);
  EXPECT_NEAR(sharp.report.widened_deg, 6.4378 / 512 * 180 / kPi, 1e-3);
  EXPECT_EQ(sharp.report.points, 0);
  float lowest = 1e9f, highest = 0;
  for (const Rgb& texel : sharp.map.radiance.values()) {
    lowest = std::min(lowest, texel.r);
    highest = std::max(highest, texel.r);
  }
  EXPECT_GT(lowest, 0.999f) << "no rings around the sun";
  EXPECT_LT(highest, 1e5f);
  EXPECT_GT(highest, 3e4f) << "a sun wider than the lobe keeps most of its brightness";
}

TEST(Convolve, HasTheSameBitsForAnyNumberOfThreads) {
  const Environment sky = sun(kPanorama, {128, 64});
  zonal::Run run;
  run.threads = 1;
  const Convolved one = convolve(sky, Lobe::ggx(0.2), kCube, cube(16), {}, run);
  for (const int threads : {2, 7}) {
    run.threads = threads;
    EXPECT_EQ(convolve(sky, Lobe::ggx(0.2), kCube, cube(16), {}, run).map.radiance, one.map.radiance);
  }
}

TEST(Convolve, EveryInstructionSetAgrees) {
  const Environment sky = sun(kPanorama, {128, 64});
  zonal::Run run;
  run.isa = Isa::kBaseline;
  const Convolved baseline = convolve(sky, Lobe::ggx(0.2), kCube, cube(16), {}, run);
  int compared = 0;
  for (const Isa isa : available_isas()) {
    run.isa = isa;
    const Convolved result = convolve(sky, Lobe::ggx(0.2), kCube, cube(16), {}, run);
    for (std::size_t i = 0; i < baseline.map.radiance.size(); ++i) {
      const float expected = baseline.map.radiance.values()[i].r;
      ASSERT_NEAR(result.map.radiance.values()[i].r, expected, 1e-6 * expected) << name_of(isa);
      ++compared;
    }
  }
  EXPECT_GE(compared, 1536);
}

TEST(Convolve, RefusesWhatIsNotFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (const int x : {0, 31, 63}) {
      Environment sky = furnace(kPanorama, {64, 32});
      sky.radiance(x, 5).g = bad;
      try {
        convolve(sky, Lobe::cosine(), kCube, cube(4));
        FAIL() << "accepted " << bad;
      } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::kInput);
        EXPECT_NE(e.hint().find("--fix"), std::string::npos);
      }
    }
  }
}

TEST(Convolve, AcceptsAllBlackAndASingleTexel) {
  const Convolved black = convolve(furnace(kPanorama, {16, 8}, {}), Lobe::cosine(), kCube, cube(4));
  for (const Rgb& texel : black.map.radiance.values()) EXPECT_EQ(texel, Rgb{});
  EXPECT_EQ(black.report.bound_to_mean, 0);
  const Convolved one = convolve(furnace(kPanorama, {2, 1}), Lobe::cosine(), kCube, cube(4));
  EXPECT_EQ(one.map.radiance.size(), 96U);
}

}  // namespace
}  // namespace zonal
