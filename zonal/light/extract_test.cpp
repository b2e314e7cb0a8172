#include "zonal/light/extract.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "zonal/base/error.h"
#include "zonal/light/model.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/rotate.h"
#include "zonal/sh/vector_irradiance.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

struct Scene {
  Sh<RgbD> probe;
  RgbD ambient;
  std::vector<Vec3> directions;
  std::vector<RgbD> irradiances;
};

/// Lights at least `separation` radians apart.
Scene random_scene(int lights, int bands, double separation, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> bright(0.2, 1);
  const auto color = [&] { return RgbD(bright(random), bright(random), bright(random)); };
  Scene scene;
  scene.ambient = color();
  scene.probe = ambient_sh(scene.ambient, bands);
  while (static_cast<int>(scene.directions.size()) < lights) {
    const Vec3 d = normalize({normal(random), normal(random), normal(random)});
    bool apart = true;
    for (const Vec3 other : scene.directions) apart = apart && angle_between(d, other) > separation;
    if (!apart) continue;
    scene.directions.push_back(d);
    scene.irradiances.push_back(color());
    scene.probe += directional_sh(d, scene.irradiances.back(), bands);
  }
  return scene;
}

double distance(RgbD a, RgbD b) { return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b); }

/// Whether each light of the scene is there, with its colour, and the ambient too.
bool found(const Scene& scene, const ExtractedLights& extracted, double tolerance) {
  if (extracted.lights.size() != scene.directions.size()) return false;
  if (distance(extracted.ambient, scene.ambient) > tolerance) return false;
  for (std::size_t i = 0; i < scene.directions.size(); ++i) {
    bool there = false;
    for (const ExtractedLight& light : extracted.lights) {
      there = there || (angle_between(light.direction, scene.directions[i]) < tolerance &&
                        distance(light.irradiance, scene.irradiances[i]) < tolerance);
    }
    if (!there) return false;
  }
  return true;
}

TEST(Extract, FindsOneLightExactlyEvenUnrefined) {
  std::mt19937 random(1);
  int compared = 0;
  for (const ExtractMetric metric : {ExtractMetric::kRadiance, ExtractMetric::kIrradiance}) {
    for (const int bands : {2, 3, 4, 6, 10}) {
      const Scene scene = random_scene(1, bands, 0, random);
      const ExtractedLights extracted = extract_lights(scene.probe, {.metric = metric});
      EXPECT_TRUE(found(scene, extracted, 1e-10)) << bands;
      EXPECT_LT(extracted.residual, 1e-10);
      EXPECT_EQ(extracted.lights[0].half_angle, 0);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 10);
}

// Four bands tell up to four lights apart that lie 200 degrees / bands from each other. To 1e-6 radians and 1e-6 of
// irradiance: residual^2 is minimised to the rounding of its gradient, and that is conditioned by the distances.
TEST(Extract, FindsUpToFourLightsByRefining) {
  std::mt19937 random(2);
  int scenes = 0;
  for (const int bands : {4, 5, 6, 8}) {
    for (int lights = 1; lights <= 4; ++lights) {
      for (int trial = 0; trial < 5; ++trial, ++scenes) {
        const Scene scene = random_scene(lights, bands, radians(200.0 / bands), random);
        const ExtractedLights extracted =
            extract_lights(scene.probe, {.lights = lights, .metric = ExtractMetric::kRadiance, .refine = true});
        EXPECT_TRUE(found(scene, extracted, 1e-6)) << bands << " bands, " << lights << " lights, trial " << trial;
        EXPECT_LT(extracted.residual, 1e-7);
      }
    }
  }
  EXPECT_EQ(scenes, 80);
}

// In the irradiance, where bands from the fourth on hardly count, a local search goes astray now and then.
TEST(Extract, FindsNearlyAllLightsInTheIrradianceToo) {
  std::mt19937 random(3);
  int scenes = 0, complete = 0;
  for (const int bands : {3, 4, 6}) {
    for (int lights = 1; lights <= 3; ++lights) {
      for (int trial = 0; trial < 12; ++trial, ++scenes) {
        const Scene scene = random_scene(lights, bands, radians(200.0 / bands), random);
        complete += found(scene, extract_lights(scene.probe, {.lights = lights, .refine = true}), 1e-6);
      }
    }
  }
  EXPECT_EQ(scenes, 108);
  EXPECT_GE(complete, 102);
}

TEST(Extract, NeverReturnsLightsThatExplainNothing) {
  std::mt19937 random(4);
  const Scene scene = random_scene(2, 6, radians(60.0), random);
  const ExtractedLights extracted =
      extract_lights(scene.probe, {.lights = 9, .metric = ExtractMetric::kRadiance, .refine = true});
  EXPECT_EQ(extracted.lights.size(), 2u);
  EXPECT_TRUE(found(scene, extracted, 1e-6));
  // A delta's own side lobes are maxima, and not taken.
  const ExtractedLights plain = extract_lights(directional_sh({1, 2, 3}, {1, 1, 1}, 6), {.lights = 5});
  EXPECT_EQ(plain.lights.size(), 1u);
  EXPECT_GT(plain.maxima.size(), 1u);
}

TEST(Extract, ReportsTheMaxima) {
  std::mt19937 random(5);
  const Scene scene = random_scene(2, 6, radians(90.0), random);
  const ExtractedLights extracted = extract_lights(scene.probe, {.lights = 2});
  ASSERT_GE(extracted.maxima.size(), 2u);
  int taken = 0;
  for (std::size_t i = 0; i < extracted.maxima.size(); ++i) {
    const ExtractMaximum& maximum = extracted.maxima[i];
    EXPECT_NEAR(maximum.luminance, luminance(evaluate(scene.probe, maximum.direction)), 1e-12);
    EXPECT_LE(maximum.luminance, extracted.maxima[i > 0 ? i - 1 : 0].luminance);
    taken += maximum.taken;
    if (maximum.taken) {
      int lights_there = 0;
      for (const ExtractedLight& light : extracted.lights) lights_there += light.direction == maximum.direction;
      EXPECT_EQ(lights_there, 1);
    }
  }
  EXPECT_EQ(taken, 2);
  EXPECT_GE(luminance(extracted.lights[0].irradiance), luminance(extracted.lights[1].irradiance));

  // Two bands have one maximum, so there is one light at most.
  const ExtractedLights few = extract_lights(with_bands(scene.probe, 2), {.lights = 3});
  EXPECT_EQ(few.maxima.size(), 1u);
  EXPECT_EQ(few.lights.size(), 1u);
  EXPECT_NEAR(angle_between(few.lights[0].direction, *optimal_linear_direction(scene.probe)), 0, 1e-9);
}

Sh<RgbD> random_probe(int bands, double mean, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Sh<RgbD> sh(bands);
  for (RgbD& value : sh.values()) value = {normal(random), normal(random), normal(random)};
  sh[0] = RgbD(mean, 1.2 * mean, 0.8 * mean);
  return sh;
}

TEST(Extract, ResidualNeverGrows) {
  std::mt19937 random(6);
  int compared = 0;
  for (const double mean : {0.5, 5.0}) {
    for (const int bands : {2, 3, 5}) {
      for (const ExtractMetric metric : {ExtractMetric::kRadiance, ExtractMetric::kIrradiance}) {
        for (const bool nonnegative : {true, false}) {
          const Sh<RgbD> probe = random_probe(bands, mean, random);
          std::array<double, 4> before = {1, 1, 1, 1};
          for (int lights = 0; lights <= 3; ++lights) {
            std::array<double, 4> now;
            for (std::size_t k = 0; k < 4; ++k) {
              now[k] = extract_lights(probe, {lights, metric, k % 2 == 1, k / 2 == 1, nonnegative}).residual;
              EXPECT_LE(now[k], before[k]);  // by asking for more lights
              ++compared;
            }
            // Ways of search that differ may end 1e-12 apart: nearer residuals count as equal.
            EXPECT_LE(now[1], now[0] + 2e-12);  // refine
            EXPECT_LE(now[2], now[0] + 2e-12);  // cones
            EXPECT_LE(now[3], now[1] + 2e-12);  // both
            EXPECT_EQ(now[0] == 1, lights == 0);
            before = now;
          }
        }
      }
    }
  }
  EXPECT_EQ(compared, 2 * 3 * 2 * 2 * 4 * 4);
}

TEST(Extract, KeepsTheEnergyAndTheSigns) {
  std::mt19937 random(7);
  int compared = 0, negative = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const int bands = 3 + trial % 4;
    const Sh<RgbD> probe = random_probe(bands, 1 + trial % 3, random);
    for (const bool nonnegative : {true, false}) {
      const ExtractedLights extracted = extract_lights(
          probe,
          {.lights = 3, .metric = ExtractMetric(trial % 2), .cones = trial % 3 == 0, .nonnegative = nonnegative});
      EXPECT_NEAR(distance(project(extracted, bands)[0], probe[0]), 0, 1e-12);
      double least = std::min({extracted.ambient.r, extracted.ambient.g, extracted.ambient.b});
      for (const auto& [direction, e, half_angle] : extracted.lights) least = std::min({least, e.r, e.g, e.b});
      if (nonnegative) {
        EXPECT_GE(least, -1e-14);  // the ambient is a difference
      }
      negative += !nonnegative && least < -0.01;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 80);
  EXPECT_GT(negative, 10);
}

TEST(Extract, NegativeColourIsBoundOrFree) {
  const Sh<RgbD> probe = ambient_sh({1, 1, 1}, 5) + directional_sh({0, 1, 0}, {2, 2, -0.5}, 5);
  const ExtractedLights bound = extract_lights(probe), free = extract_lights(probe, {.nonnegative = false});
  EXPECT_NEAR(distance(free.lights[0].irradiance, {2, 2, -0.5}), 0, 1e-12);
  EXPECT_LT(free.residual, 1e-12);
  EXPECT_NEAR(distance(bound.lights[0].irradiance, {2, 2, 0}), 0, 1e-12);
  EXPECT_NEAR(bound.ambient.b, 1 - 0.5 / (4 * kPi), 1e-12);  // it carries the whole mean then
  EXPECT_NEAR(bound.residual, std::sqrt(0.0722 * 0.25 / ((0.2126 + 0.7152) * 4 + 0.0722 * 0.25)), 1e-12);
}

TEST(Extract, TurnsWithTheProbe) {
  std::mt19937 random(8);
  const Scene scene = random_scene(3, 6, radians(50.0), random);
  const Rotation turn = Rotation::about(normalize({1, 2, -1}), 1.1);
  const ExtractOptions options = {.lights = 3, .refine = true};
  const ExtractedLights one = extract_lights(scene.probe, options),
                        other = extract_lights(rotate(scene.probe, turn), options);
  ASSERT_EQ(one.lights.size(), 3u);
  ASSERT_EQ(other.lights.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(angle_between(turn * one.lights[i].direction, other.lights[i].direction), 0, 1e-6);
  }
}

TEST(Extract, FindsDiscs) {
  const Vec3 a = normalize({1, 0.2, 0.5}), b = normalize({-1, 1, 0.2});
  const double angle_a = radians(25.0), angle_b = radians(50.0);
  const Sh<RgbD> probe =
      ambient_sh({0.2, 0.3, 0.4}, 6) + cone_sh(a, angle_a, {5, 4, 3}, 6) + cone_sh(b, angle_b, {1, 1, 2}, 6);
  for (const ExtractMetric metric : {ExtractMetric::kRadiance, ExtractMetric::kIrradiance}) {
    const ExtractedLights extracted =
        extract_lights(probe, {.lights = 2, .metric = metric, .refine = true, .cones = true});
    ASSERT_EQ(extracted.lights.size(), 2u);
    EXPECT_LT(extracted.residual, 1e-7);
    EXPECT_NEAR(angle_between(extracted.lights[0].direction, a), 0, 1e-5);
    EXPECT_NEAR(angle_between(extracted.lights[1].direction, b), 0, 1e-5);
    EXPECT_NEAR(extracted.lights[0].half_angle, angle_a, 1e-5);
    EXPECT_NEAR(extracted.lights[1].half_angle, angle_b, 1e-5);
    EXPECT_NEAR(extracted.lights[0].irradiance.r, 5 * kPi * std::pow(std::sin(angle_a), 2), 1e-5);
    EXPECT_NEAR(distance(project(extracted, 6)(2, 1), probe(2, 1)), 0, 1e-6);
  }
}

TEST(Extract, ProjectIsTheLightModels) {
  ExtractedLights lights;
  lights.ambient = {1, 2, 3};
  lights.lights = {{{0, 0.6, 0.8}, {3, 2, 1}, 0}, {{1, 0, 0}, {1, 1, 4}, radians(30.0)}};
  const double facing = kPi * 0.25;  // pi sin^2 30 degrees
  const Sh<RgbD> expected = ambient_sh({1, 2, 3}, 7) + directional_sh({0, 0.6, 0.8}, {3, 2, 1}, 7) +
                            cone_sh({1, 0, 0}, radians(30.0), 1 / facing * RgbD(1, 1, 4), 7);
  const Sh<RgbD> sh = project(lights, 7);
  int compared = 0;
  for (std::size_t i = 0; i < sh.size(); ++i, ++compared) EXPECT_NEAR(distance(sh[i], expected[i]), 0, 2e-14);
  EXPECT_EQ(compared, 49);
  EXPECT_THROW(project(lights, 0), std::logic_error);
  lights.lights[1].half_angle = 2;
  EXPECT_THROW(project(lights, 3), Error);
  lights.lights[1] = {{0, 0, 0}, {1, 1, 1}, 0};
  EXPECT_THROW(project(lights, 3), Error);
}

}  // namespace
}  // namespace zonal
