#include "zonal/light/extract_closed.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <span>

#include "zonal/base/error.h"
#include "zonal/light/normalise.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/convention.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

const std::filesystem::path kVectors = ZONAL_SOURCE_DIR "/../shared/reference/vectors";

Vec3 vec3(const nlohmann::json& v) { return {v.at(0), v.at(1), v.at(2)}; }

Sh<double> from_signed(const nlohmann::json& values, int bands) {
  Sh<double> sh(bands);
  EXPECT_EQ(values.size(), sh.size());
  for (std::size_t i = 0; i < sh.size(); ++i) sh[i] = values.at(i);
  return from_condon_shortley(sh);
}

Sh<double> random_function(int bands, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Sh<double> sh(bands);
  for (double& value : sh.values()) value = normal(random);
  return sh;
}

/// Of the published numbers: c is relative to a light that reflects one.
double unit_of_c(int bands) { return normalising_factor(delta_zonal(bands)); }

TEST(ExtractClosed, OneLightAsPublished) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  std::ifstream file(kVectors / "extraction.json");
  const nlohmann::json reference = nlohmann::json::parse(file);
  int compared = 0;
  for (const nlohmann::json& entry : reference["single"]) {
    const int bands = entry["order"];
    const Sh<double> radiance = from_signed(entry["L"], bands);
    for (const auto& fit : {fit_one_light(radiance, vec3(entry["direction"])),
                            fit_one_light_coupled(radiance, vec3(entry["direction"]))}) {
      EXPECT_NEAR(fit.irradiance[0] / unit_of_c(bands), entry["c"].get<double>(), 1e-12);
      EXPECT_NEAR(fit.ambient, entry["a_radiance"].get<double>(), 1e-12);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 40);
}

TEST(ExtractClosed, TwoAndThreeLightsAsPublished) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  std::ifstream file(kVectors / "extraction.json");
  const nlohmann::json reference = nlohmann::json::parse(file);
  int compared = 0;
  for (const nlohmann::json& entry : reference["multi"]) {
    const int bands = entry["order"];
    const bool convolved = entry["convolved"];
    const auto metric = convolved ? ExtractMetric::kIrradiance : ExtractMetric::kRadiance;
    Sh<double> radiance = from_signed(entry["L"], bands);
    if (convolved) {  // the file has irradiance over pi there; bands that the cosine removes play no part
      std::vector<double> back = cosine_factors(bands);
      for (double& factor : back) factor = factor == 0 ? 0 : 1 / factor;
      radiance = convolve(radiance, back);
    }
    const nlohmann::json& d = entry["directions"];
    const auto compare = [&](const auto& fit) {
      for (std::size_t k = 0; k < fit.irradiance.size(); ++k, ++compared) {
        EXPECT_NEAR(fit.irradiance[k] / unit_of_c(bands), entry["c"][k].get<double>(), 1e-12);
      }
      EXPECT_NEAR(fit.ambient, entry["a_radiance"].get<double>(), 1e-12);
    };
    if (d.size() == 2) {
      compare(fit_two_lights(radiance, {vec3(d[0]), vec3(d[1])}, metric));
    } else {
      compare(fit_three_lights(radiance, {vec3(d[0]), vec3(d[1]), vec3(d[2])}, metric));
    }
  }
  EXPECT_EQ(compared, 4 * 2 + 4 * 3);
}

TEST(ExtractClosed, HasTheConstantsOfTheFormulaSheet) {
  // c = 867/(316 pi) D.L for 3 and 4 bands, 2883/(1276 pi) for 5 and 6, 27/(16 pi) for 2; D the normalised light, both
  // convolved, without the mean. A light alone in the linear band shows the factor.
  const double expected[] = {27 / (16 * kPi), 867 / (316 * kPi), 867 / (316 * kPi), 2883 / (1276 * kPi),
                             2883 / (1276 * kPi)};
  for (int bands = 2; bands <= 6; ++bands) {
    Sh<double> linear(bands);
    linear(1, 0) = 1;
    const double c = fit_one_light(linear, {0, 0, 1}).irradiance[0] / unit_of_c(bands);
    const double light = unit_of_c(bands) * std::sqrt(3 / (4 * kPi)), cosine = 2.0 / 3;
    EXPECT_NEAR(c / (cosine * light * cosine), expected[bands - 2], 1e-15) << bands;
  }
}

/// Weighted least squares of the functions themselves, at the nodes of a rule that is exact for their squares.
Eigen::VectorXd brute_force(const Sh<double>& radiance, std::span<const Vec3> lights, ExtractMetric metric) {
  const int bands = radiance.bands();
  const auto seen = [&](const Sh<double>& sh) {
    return metric == ExtractMetric::kIrradiance ? irradiance_over_pi(sh) : sh;
  };
  std::vector<Sh<double>> models;
  for (const Vec3 light : lights) models.push_back(seen(zonal_toward(delta_zonal(bands), normalize(light))));
  const std::vector<WeightedDirection> rule = sphere_rule(bands + 1);
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rule.size()), static_cast<Eigen::Index>(models.size()) + 1);
  Eigen::VectorXd right(matrix.rows());
  const Sh<double> target = seen(radiance);
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    const auto& [direction, weight] = rule[static_cast<std::size_t>(row)];
    const double root = std::sqrt(weight);
    for (std::size_t k = 0; k < models.size(); ++k) {
      matrix(row, static_cast<Eigen::Index>(k)) = root * evaluate(models[k], direction);
    }
    matrix(row, matrix.cols() - 1) = root;
    right(row) = root * evaluate(target, direction);
  }
  return matrix.colPivHouseholderQr().solve(right);
}

TEST(ExtractClosed, IsTheLeastSquaresOverTheSphere) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int compared = 0;
  for (const ExtractMetric metric : {ExtractMetric::kRadiance, ExtractMetric::kIrradiance}) {
    for (int bands = 3; bands <= 7; ++bands) {
      const Sh<double> radiance = random_function(bands, random);
      // Not too near each other, or the comparison would measure the condition of the problem.
      const Rotation turn =
          Rotation::about(normalize({normal(random), normal(random), normal(random)}), normal(random));
      const std::array<Vec3, 3> d = {turn * Vec3{2, 0, 0.5}, turn * Vec3{0.3, 1, 0.4}, turn * Vec3{-0.6, -0.5, 0.8}};
      const auto compare = [&](const auto& fit) {
        const Eigen::VectorXd expected = brute_force(radiance, std::span(d).first(fit.irradiance.size()), metric);
        for (std::size_t k = 0; k < fit.irradiance.size(); ++k) {
          EXPECT_NEAR(fit.irradiance[k], expected(static_cast<Eigen::Index>(k)), 2e-13);
        }
        EXPECT_NEAR(fit.ambient, expected(expected.size() - 1), 1e-13);
        ++compared;
      };
      compare(fit_one_light(radiance, d[0], metric));
      compare(fit_one_light_coupled(radiance, d[0], metric));
      compare(fit_two_lights(radiance, {d[0], d[1]}, metric));
      compare(fit_three_lights(radiance, d, metric));

      // The general verb gives the same, sign left free.
      const ExtractedLights general = fit_lights(RgbD(1, 2, -3) * radiance, d, metric, false);
      const ClosedFit<3> closed = fit_three_lights(radiance, d, metric);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(general.lights[k].irradiance.g, 2 * closed.irradiance[k], 1e-12);
        EXPECT_NEAR(general.lights[k].irradiance.b, -3 * closed.irradiance[k], 1e-12);
      }
      EXPECT_NEAR(general.ambient.r, closed.ambient, 1e-12);
    }
  }
  EXPECT_EQ(compared, 2 * 5 * 4);
}

TEST(ExtractClosed, RefusesWhatHasNoAnswer) {
  std::mt19937 random(8);
  const Sh<double> radiance = random_function(3, random);
  const Vec3 x = {1, 0, 0}, y = {0, 2, 0}, z = {0, 0, 1};
  EXPECT_THROW(fit_two_lights(radiance, {x, 3 * x}), Error);
  EXPECT_THROW(fit_two_lights(radiance, {x, normalize({1, 1e-7, 0})}), Error);
  EXPECT_NO_THROW(fit_two_lights(radiance, {x, -x}));
  EXPECT_THROW(fit_two_lights(with_bands(radiance, 2), {x, -x}), Error);  // one is minus the other there
  EXPECT_THROW(fit_three_lights(radiance, {x, y, x}), Error);
  EXPECT_THROW(fit_three_lights(radiance, {x, y, y}), Error);
  EXPECT_THROW(fit_three_lights(radiance, {x, x, y}), Error);
  EXPECT_NO_THROW(fit_three_lights(radiance, {x, y, z}));
  EXPECT_THROW(fit_one_light(radiance, {0, 0, 0}), Error);
  EXPECT_THROW(fit_one_light(with_bands(radiance, 1), x), Error);
  Sh<double> broken = radiance;
  broken(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit_one_light(broken, x), Error);
}

}  // namespace
}  // namespace zonal
