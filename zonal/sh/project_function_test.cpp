#include "zonal/sh/project_function.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "zonal/sh/eval.h"

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

TEST(ProjectFunction, RecoversEveryBandLimitedFunction) {
  int compared = 0;
  for (const int function_bands : {1, 2, 3, 6, 17, 40}) {
    const Sh<double> truth = random_sh(function_bands, 7);
    for (const int bands : {1, 4, 40}) {
      const Sh<double> found = project_function([&](Vec3 d) { return evaluate(truth, d); }, bands, function_bands - 1);
      ASSERT_EQ(found.bands(), bands);
      for (int l = 0; l < bands; ++l) {
        for (int m = -l; m <= l; ++m, ++compared) {
          // A few roundings of values of the size bands (the norm of the function over sqrt(4 pi)) that average out.
          EXPECT_NEAR(found(l, m), l < function_bands ? truth(l, m) : 0, 20 * kEps * function_bands)
              << function_bands << ' ' << bands << ' ' << l << ' ' << m;
        }
      }
    }
  }
  EXPECT_EQ(compared, 6 * (1 + 16 + 1600));
}

// The degree is what it is said to be: one less, and a polynomial that the rule cannot see appears.
TEST(ProjectFunction, TheDegreeIsNeeded) {
  int compared = 0;
  for (const int degree : {2, 4, 8}) {
    const auto f = [&](Vec3 d) { return std::pow(d.z, degree); };
    const double mean = std::sqrt(4 * kPi) / (degree + 1);  // of z^degree, degree even, times 2 sqrt(pi)
    EXPECT_NEAR(project_function(f, 1, degree)(0, 0), mean, 8 * kEps);
    EXPECT_GT(std::abs(project_function(f, 1, degree - 2)(0, 0) - mean), 1e-4);
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

TEST(ProjectFunction, ConvergesForASmoothFunctionThatIsNoPolynomial) {
  // exp(z): z_0 = 2 sqrt(pi) sinh(1), z_1 = sqrt(12 pi)/e.
  const auto f = [](Vec3 d) { return std::exp(d.z); };
  double before = 1;
  for (const int degree : {1, 5, 9, 13}) {
    const Sh<double> found = project_function(f, 2, degree);
    const double error = std::abs(found(0, 0) - 2 * std::sqrt(kPi) * std::sinh(1.0)) +
                         std::abs(found(1, 0) - std::sqrt(12 * kPi) * std::exp(-1.0));
    EXPECT_LT(error, before);
    before = error / 100;
  }
  EXPECT_LT(before, 1e-14 / 100 + 8 * kEps);
}

TEST(ProjectFunction, TakesColoursAndFloatsAndConstants) {
  const Sh<RgbD> color = project_function([](Vec3 d) { return Rgb(1, static_cast<float>(d.x), 0); }, 2, 1);
  EXPECT_NEAR(color(0, 0).r, std::sqrt(4 * kPi), 8 * kEps);
  EXPECT_NEAR(color(1, 1).g, std::sqrt(4 * kPi / 3), 1e-7);  // x was rounded to float
  EXPECT_EQ(color(1, 1).b, 0);
  const Sh<double> one = project_function([](Vec3) { return 1; }, 3, 0);
  EXPECT_NEAR(one(0, 0), std::sqrt(4 * kPi), 8 * kEps);
  for (std::size_t i = 1; i < one.size(); ++i) EXPECT_NEAR(one[i], 0, 8 * kEps);
}

TEST(ProjectFunction, CallsTheFunctionAsOftenAsItSays) {
  int calls = 0;
  const auto f = [&](Vec3 d) {
    ++calls;
    EXPECT_NEAR(length(d), 1, 4 * kEps);
    return d.z;
  };
  EXPECT_EQ(project_function(f, 3, 4).bands(), 3);
  EXPECT_EQ(calls, 2 * 4 * 4);
}

TEST(ProjectFunction, SaysWhereAFunctionFails) {
  const auto message = [](auto&& f) -> std::string {
    try {
      (void)project_function(f, 2, 3);
    } catch (const Error& e) {
      return std::string(e.kind() == ErrorKind::kInput ? "input: " : "other: ") + e.what();
    }
    return "nothing";
  };
  EXPECT_EQ(message([](Vec3) { return std::nan(""); }).find("input: the function to be projected is not finite at ("),
            0u);
  EXPECT_EQ(message([](Vec3 d) { return RgbD(0, 1 / std::max(0.0, d.z), 0); }).find("input: "), 0u);
  const std::string thrown = message([](Vec3) -> double { throw std::runtime_error("no such star"); });
  EXPECT_NE(thrown.find("failed (no such star) at ("), thrown.npos) << thrown;
  EXPECT_EQ(message([](Vec3) -> double { throw 42; }).find("input: the function to be projected failed at ("), 0u);
  EXPECT_EQ(message([](Vec3) -> double { throw Error(ErrorKind::kCancelled, "stopped"); }), "other: stopped");
  EXPECT_THROW((void)project_function([](Vec3) { return 1.0; }, 0, 1), std::logic_error);
  EXPECT_THROW((void)project_function([](Vec3) { return 1.0; }, 1, -1), std::logic_error);
}

}  // namespace
}  // namespace zonal
