#include "zonal/sh/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/project_function.h"

namespace zonal {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

Sh<double> random_sh(int bands, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> value;
  Sh<double> sh(bands);
  for (double& c : sh.values()) c = value(random);
  return sh;
}

std::vector<Vec3> random_directions(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> value;
  std::vector<Vec3> directions;
  while (static_cast<int>(directions.size()) < count) {
    directions.push_back({value(random), value(random), value(random)});  // of any length, as the contract allows
  }
  return directions;
}

TEST(FitSh, RecoversBandLimitedFunctionsFromAnyDirections) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> weight(0.1, 3);
  int compared = 0;
  for (int bands = 1; bands <= 8; ++bands) {
    const Sh<double> truth = random_sh(bands, 11);
    // From exactly as many as there are coefficients, to more than one block of rows.
    for (const int count : {bands * bands, 2 * bands * bands, 1500}) {
      std::vector<ShSample<double>> samples;
      for (const Vec3 d : random_directions(count, 5)) {
        samples.push_back({d, evaluate(truth, normalize(d)), weight(random)});
      }
      const LeastSquaresFit<double> found = fit_sh(samples, bands);
      // The basis has norm bands/sqrt(4 pi): so many roundings, times what the arrangement loses.
      const double allowed = 20 * kEps * bands * found.condition;
      for (std::size_t i = 0; i < truth.size(); ++i, ++compared) {
        EXPECT_NEAR(found.coefficients[i], truth[i], allowed) << bands << ' ' << count << ' ' << found.condition;
      }
      EXPECT_LT(found.residual, 20 * kEps * bands * bands);
      EXPECT_GE(found.condition, 1);
    }
  }
  EXPECT_EQ(compared, 3 * 204);
}

TEST(FitSh, IsTheQuadratureWhereTheSamplesAreARuleAndItsWeights) {
  int compared = 0;
  for (const int bands : {1, 3, 6}) {
    // Not band-limited at all: the projection of a step is the same weighted sum all the same.
    const auto f = [](Vec3 d) { return RgbD(d.x > 0.3 ? 2 : 0, std::exp(d.y), -1); };
    std::vector<ShSample<RgbD>> samples;
    Sh<RgbD> sums(bands);
    RgbD energy;
    for (const auto& [d, weight] : sphere_rule(bands)) {
      samples.push_back({3 * d, f(d), 7 * weight});  // ratios alone matter
      visit_basis(bands, d,
                  [&, at = d, w = weight](int i, double y) { sums[static_cast<std::size_t>(i)] += w * y * f(at); });
      energy += weight * f(d) * f(d);
    }
    const LeastSquaresFit<RgbD> found = fit_sh(samples, bands), ridged = fit_sh(samples, bands, 0.25);
    EXPECT_NEAR(found.condition, 1, 1e-13) << "the basis is orthonormal under the rule";
    for (std::size_t i = 0; i < sums.size(); ++i, ++compared) {
      EXPECT_NEAR(found.coefficients[i].r, sums[i].r, 1e-14);
      EXPECT_NEAR(found.coefficients[i].g, sums[i].g, 1e-14);
      EXPECT_NEAR(found.coefficients[i].b, sums[i].b, 1e-14);
      EXPECT_NEAR(ridged.coefficients[i].r, sums[i].r / 1.25, 1e-14) << "1/(1 + ridge) of each";
      energy = energy - sums[i] * sums[i];
    }
    // Parseval under the rule: what is not in the coefficients is in the residual. Squares, as the difference cancels.
    EXPECT_NEAR(std::pow(found.residual.r, 2), energy.r / (4 * kPi), 1e-14);
    EXPECT_NEAR(std::pow(found.residual.g, 2), energy.g / (4 * kPi), 1e-14);
    EXPECT_NEAR(found.residual.b, 0, 1e-14);
  }
  EXPECT_EQ(compared, 1 + 9 + 36);
}

TEST(FitSh, AgreesWithTheProjectionOfAFunctionOfItsBands) {
  const auto f = [](Vec3 d) { return 1 + d.x * d.y - 0.3 * d.z; };
  std::vector<ShSample<double>> samples;
  for (const Vec3 d : random_directions(40, 8)) samples.push_back({d, f(normalize(d))});
  const LeastSquaresFit<double> fitted = fit_sh(samples, 3);
  const Sh<double> projected = project_function(f, 3, 2);
  for (std::size_t i = 0; i < projected.size(); ++i) EXPECT_NEAR(fitted.coefficients[i], projected[i], 1e-13);
}

// Gauss & Markov: with noise of deviation s the error e = found - truth has the covariance s^2 (A^T A)^-1, so that
// |A e|^2/s^2 follows chi^2 with one degree for each coefficient and the squared residual has the mean s^2 (1 - p/n).
TEST(FitSh, SpreadsNoiseAsTheoryHasIt) {
  constexpr int kBands = 3, kCoefficients = 9, kSamples = 30, kTrials = 2000;
  constexpr double kNoise = 0.05;
  const Sh<double> truth = random_sh(kBands, 2);
  std::vector<ShSample<double>> samples;
  for (const Vec3 d : random_directions(kSamples, 6)) samples.push_back({normalize(d)});
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, kNoise);
  double chi2 = 0, residual2 = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    for (ShSample<double>& s : samples) s.value = evaluate(truth, s.direction) + noise(random);
    const LeastSquaresFit<double> found = fit_sh(samples, kBands);
    for (const ShSample<double>& s : samples) {
      chi2 += std::pow(evaluate(found.coefficients - truth, s.direction) / kNoise, 2);
    }
    residual2 += found.residual * found.residual;
  }
  // Four standard deviations of the means: chi^2 with k degrees has variance 2k.
  EXPECT_NEAR(chi2 / kTrials, kCoefficients, 4 * std::sqrt(2.0 * kCoefficients / kTrials));
  constexpr double kFree = kSamples - kCoefficients;
  EXPECT_NEAR(residual2 / kTrials * kSamples / (kNoise * kNoise), kFree, 4 * std::sqrt(2 * kFree / kTrials));
}

TEST(FitSh, WeightsSayWhatCounts) {
  // Two lies of weight zero, and a truth said twice that weighs as two.
  std::vector<ShSample<double>> plain, weighted;
  int at = 0;
  for (const Vec3 d : random_directions(20, 9)) {
    const double value = std::sin(3.0 * at);
    plain.push_back({d, value});
    if (at % 4 == 0) plain.push_back({d, value});
    weighted.push_back({d, value, at % 4 == 0 ? 2.0 : 1.0});
    ++at;
  }
  weighted.push_back({{1, 0, 0}, 1e6, 0});
  weighted.push_back({{0, 1, 0}, -1e6, 0});
  const LeastSquaresFit<double> a = fit_sh(plain, 3), b = fit_sh(weighted, 3);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(a.coefficients[i], b.coefficients[i], 1e-13);
  EXPECT_NEAR(a.residual, b.residual, 1e-14);
  EXPECT_GT(a.residual, 0.1);
  EXPECT_NEAR(a.condition, b.condition, 1e-12);
}

TEST(FitSh, ARidgeDecidesWhatSamplesLeaveOpen) {
  // One sample: of all functions that fit it to a share, the smallest is the zonal bump around it.
  const Vec3 d = normalize({1, 2, 2});
  const std::vector<ShSample<double>> one = {{d, 5.0}};
  constexpr double kRidge = 0.01;
  const LeastSquaresFit<double> found = fit_sh(one, 3, kRidge);
  std::vector<double> y(9);
  basis<double>(3, d, y);
  const double norm2 = 9 / (4 * kPi);  // addition theorem; one row of length sqrt(4 pi norm2) = 3
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(found.coefficients[i], 5 * 4 * kPi * y[i] / (4 * kPi * norm2 + kRidge), 1e-13);
  }
  EXPECT_NEAR(found.residual, 5 * kRidge / (4 * kPi * norm2 + kRidge), 1e-14);
  EXPECT_NEAR(found.condition, std::sqrt((9 + kRidge) / kRidge), 1e-12);
}

TEST(FitSh, TheConditionKnowsHalfASphere) {
  std::vector<ShSample<double>> whole, half;
  for (const Vec3 d : spiral_directions(400)) {
    whole.push_back({d, 1.0});
    half.push_back({{d.x, d.y, std::abs(d.z)}, 1.0});
  }
  EXPECT_LT(fit_sh(whole, 4).condition, 1.1);
  EXPECT_GT(fit_sh(half, 4).condition, 20);
  EXPECT_LT(fit_sh(half, 4, 0.01).condition, 20);
}

TEST(FitSh, RefusesWhatCannotBeFitted) {
  std::vector<ShSample<double>> good;
  for (const Vec3 d : spiral_directions(30)) good.push_back({d, 1.0});
  const auto message = [](const std::vector<ShSample<double>>& samples, int bands = 3, double ridge = 0) {
    try {
      (void)fit_sh(samples, bands, ridge);
    } catch (const Error& e) {
      return (e.kind() == ErrorKind::kInput ? "input: " : "usage: ") + std::string(e.what()) + " | " + e.hint();
    }
    return std::string("fine");
  };
  const auto with = [&](ShSample<double> bad) {
    auto samples = good;
    samples[17] = bad;
    return message(samples);
  };
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(good), "fine");
  EXPECT_EQ(with({{0, 0, 0}, 1}).find("input: sample 17 has the zero vector"), 0u);
  EXPECT_EQ(with({{0, nan, 1}, 1}).find("input: sample 17 has a direction"), 0u);
  EXPECT_EQ(with({{0, 0, 1}, nan}).find("input: sample 17 has a value"), 0u);
  EXPECT_EQ(with({{0, 0, 1}, infinity}).find("input: sample 17 has a value"), 0u);
  EXPECT_EQ(with({{0, 0, 1}, 1, -1}).find("input: sample 17 has a weight"), 0u);
  EXPECT_EQ(with({{0, 0, 1}, 1, nan}).find("input: sample 17 has a weight"), 0u);
  EXPECT_EQ(with({{0, 0, 1}, 1, infinity}).find("input: sample 17 has an infinite weight"), 0u);
  EXPECT_EQ(message({}).find("input: there are no samples"), 0u);
  EXPECT_EQ(message({{{0, 0, 1}, 1, 0}}).find("input: all samples have the weight 0"), 0u);

  const std::string few = message({good.begin(), good.begin() + 8});
  EXPECT_EQ(few.find("input: 3 bands have 9 coefficients, more than the 8 samples can tell"), 0u) << few;
  EXPECT_NE(few.find("| give more samples, fewer bands, or a ridge"), few.npos);
  EXPECT_EQ(message({good.begin(), good.begin() + 8}, 3, 0.01), "fine");
  // 30 samples of which the horizon alone is known: everything odd in z is open.
  auto flat = good;
  for (ShSample<double>& s : flat) s.direction.z = 0;
  EXPECT_EQ(message(flat).find("input: the samples leave"), 0u);
  EXPECT_EQ(message(flat, 3, 1e-3), "fine");

  EXPECT_EQ(message(good, 0).find("usage: "), 0u);
  EXPECT_EQ(message(good, 33).find("usage: "), 0u);
  EXPECT_EQ(message(good, 3, -1).find("usage: "), 0u);
  EXPECT_EQ(message(good, 3, nan).find("usage: "), 0u);
}

TEST(FitSh, SurvivesWeightsOfAnySize) {
  std::vector<ShSample<double>> samples;
  for (const Vec3 d : spiral_directions(30)) samples.push_back({d, d.x, 1e308});
  const LeastSquaresFit<double> found = fit_sh(samples, 2);
  EXPECT_NEAR(found.coefficients(1, 1), std::sqrt(4 * kPi / 3), 1e-14);
}

}  // namespace
}  // namespace zonal
