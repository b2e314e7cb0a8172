#include "zonal/light/extract_fit.h"

#include <gtest/gtest.h>

#include <random>

#include "zonal/base/error.h"
#include "zonal/light/extract_refine.h"
#include "zonal/light/lobe.h"
#include "zonal/light/model.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

Sh<RgbD> random_probe(int bands, double mean, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Sh<RgbD> sh(bands);
  for (RgbD& value : sh.values()) value = {normal(random), normal(random), normal(random)};
  sh[0] += RgbD(mean, mean, mean);
  return sh;
}

TEST(ExtractFit, DiscsAreTheConeLobe) {
  int compared = 0;
  for (const double half_angle : {1e-6, 1e-3, 0.1, 0.7, 1.5, kPi / 2}) {
    const double versine = 2 * std::pow(std::sin(half_angle / 2), 2);
    const std::vector<double> factors = disc_factors(versine, 20).factors;
    const std::vector<double> expected = band_factors(Lobe::cone(half_angle), 20);
    for (std::size_t l = 0; l < 20; ++l, ++compared) EXPECT_NEAR(factors[l], expected[l], 1e-13);
  }
  EXPECT_EQ(compared, 120);
  for (const double factor : disc_factors(0, 20).factors) EXPECT_NEAR(factor, 1, 1e-14);
}

TEST(ExtractFit, DiscSlopesAreFiniteDifferences) {
  int compared = 0;
  const double step = 1e-5;
  for (const double versine : {0.001, 0.1, 0.5, 0.9}) {
    const std::vector<double> slopes = disc_factors(versine, 12).slopes;
    const auto above = disc_factors(versine + step, 12).factors, below = disc_factors(versine - step, 12).factors;
    for (std::size_t l = 0; l < 12; ++l, ++compared) {
      // The third derivative at the pole, of the order l^6/48, times step^2/6: a few 1e-7 at most.
      EXPECT_NEAR(slopes[l], (above[l] - below[l]) / (2 * step), 1e-6) << versine << ' ' << l;
    }
  }
  EXPECT_EQ(compared, 48);
}

TEST(ExtractFit, ResidualIsTheSizeOfWhatIsLeftOverTheSphere) {
  std::mt19937 random(1);
  int compared = 0;
  for (const ExtractMetric metric : {ExtractMetric::kRadiance, ExtractMetric::kIrradiance}) {
    for (const bool nonnegative : {false, true}) {
      const Sh<RgbD> probe = random_probe(5, 4, random);
      const Vec3 directions[] = {{1, 2, 3}, {-1, 0.5, 0.3}};
      const ExtractedLights fit = fit_lights(probe, directions, metric, nonnegative);
      const auto seen = [&](const Sh<RgbD>& sh) {
        return metric == ExtractMetric::kIrradiance ? irradiance_over_pi(sh) : sh;
      };
      const Sh<RgbD> left = seen(probe - project(fit, 5)), whole = seen(probe);
      const RgbD mean = evaluate(with_bands(whole, 1), {0, 0, 1});
      double left_square = 0, whole_square = 0;
      for (const auto& [d, weight] : sphere_rule(6)) {
        const RgbD a = evaluate(left, d), b = evaluate(whole, d) - mean;
        left_square += weight * luminance(a * a);
        whole_square += weight * luminance(b * b);
      }
      EXPECT_NEAR(fit.residual, std::sqrt(left_square / whole_square), 1e-13);
      EXPECT_GT(fit.residual, 0.1);  // or nothing would have been compared
      ++compared;
    }
  }
  EXPECT_EQ(compared, 4);
}

/// The gradient against central differences, in the inside of the constraints and on them.
TEST(ExtractFit, GradientIsThatOfFiniteDifferences) {
  std::mt19937 random(2);
  int compared = 0, bound = 0;
  for (const ExtractMetric metric : {ExtractMetric::kRadiance, ExtractMetric::kIrradiance}) {
    for (const FreeShapes free : {FreeShapes{true, false}, FreeShapes{false, true}, FreeShapes{true, true}}) {
      for (int trial = 0; trial < 20; ++trial) {
        const LightFitter fitter(random_probe(4, trial % 2 ? 1 : 6, random), metric, trial % 3 != 0);
        std::normal_distribution<double> normal;
        std::vector<LightShape> shapes;
        for (int k = 0; k < 3; ++k) {
          const Vec3 d = normalize({normal(random), normal(random), normal(random)});
          shapes.push_back({d, std::uniform_real_distribution<double>(0.1, 0.9)(random)});
        }
        bound += (fitter.fit(shapes).flux.array() == 0).any();
        const ShapeObjective objective(fitter, free, shapes);
        std::vector<double> parameters = objective.start(), slopes(parameters.size()), unused(parameters.size());
        for (double& parameter : parameters) parameter *= 1.1;  // no unit vectors
        objective(parameters, slopes);
        for (std::size_t i = 0; i < parameters.size(); ++i, ++compared) {
          const double here = parameters[i], step = 1e-4;
          parameters[i] = here + step;
          const double above = objective(parameters, unused);
          parameters[i] = here - step;
          const double below = objective(parameters, unused);
          parameters[i] = here;
          // Parameters are about 16 per radian: the difference errs by step^2/6 third derivatives, or, where a bound
          // begins to hold within the step, by a step times a jump of the second one.
          EXPECT_NEAR(slopes[i], (above - below) / (2 * step), 2e-7);
        }
      }
    }
  }
  EXPECT_EQ(compared, 2 * 20 * (9 + 3 + 12));
  EXPECT_GT(bound, 20);
}

TEST(ExtractFit, RefiningFindsADisc) {
  const Vec3 toward = normalize({1, -1, 2});
  const double half_angle = radians(35.0);
  Sh<RgbD> probe = cone_sh(toward, half_angle, {2, 3, 4}, 6) + ambient_sh({1, 1, 1}, 6);
  const LightFitter fitter(probe, ExtractMetric::kRadiance, true);
  const std::vector<LightShape> start = {{normalize({1, -0.8, 2.2}), 0.05}};
  const LightFit fit = refine_lights(fitter, start, {true, true});
  EXPECT_LT(fit.residual, 1e-9);
  const ExtractedLights result = fitter.result(fit);
  EXPECT_NEAR(angle_between(result.lights[0].direction, toward), 0, 1e-8);
  EXPECT_NEAR(result.lights[0].half_angle, half_angle, 1e-7);
  EXPECT_NEAR(result.lights[0].irradiance.g, 3 * kPi * std::pow(std::sin(half_angle), 2), 1e-6);
  EXPECT_NEAR(result.ambient.r, 1, 1e-7);
}

TEST(ExtractFit, RefiningNeverMakesItWorse) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int better = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const LightFitter fitter(random_probe(3 + trial % 4, 3, random), ExtractMetric(trial % 2), trial % 3 != 0);
    std::vector<LightShape> shapes;
    for (int k = 0; k < 1 + trial % 3; ++k) {
      shapes.push_back({normalize({normal(random), normal(random), normal(random)}), 0});
    }
    const double before = fitter.fit(shapes).residual;
    const double after = refine_lights(fitter, shapes, {true, trial % 5 == 0}).residual;
    EXPECT_LE(after, before);
    better += after < before - 1e-3;
  }
  EXPECT_GT(better, 50);
}

}  // namespace
}  // namespace zonal
