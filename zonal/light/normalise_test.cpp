#include "zonal/light/normalise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "zonal/base/error.h"
#include "zonal/light/model.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

Sh<double> green(const Sh<RgbD>& sh) {
  Sh<double> channel(sh.bands());
  for (std::size_t i = 0; i < sh.size(); ++i) channel[i] = sh[i].g;
  return channel;
}

TEST(Normalise, DirectionalLightHasTheFractionsOfThePaper) {
  EXPECT_NEAR(normalising_factor(delta_zonal(1)), 4 * kPi, 1e-14);
  EXPECT_NEAR(normalising_factor(delta_zonal(2)), 4 * kPi / 3, 1e-14);
  EXPECT_NEAR(normalising_factor(delta_zonal(3)), 16 * kPi / 17, 1e-14);
  EXPECT_NEAR(normalising_factor(delta_zonal(4)), 16 * kPi / 17, 1e-14);
  EXPECT_NEAR(normalising_factor(delta_zonal(5)), 32 * kPi / 31, 1e-14);
  EXPECT_NEAR(normalising_factor(delta_zonal(6)), 32 * kPi / 31, 1e-14);
  EXPECT_NEAR(normalising_factor(constant_zonal(7)), 1, 1e-15);
  EXPECT_EQ(directional_normalising_factor(), kPi);
}

TEST(Normalise, ClosedFormsOfTheConeInThreeAndFiveBands) {
  int compared = 0;
  for (const double a : {0.01, 0.3, 1.0, 1.5, 2.5}) {
    const double c = std::cos(a), versine = 2 * std::pow(std::sin(a / 2), 2);
    const double three = versine * (5 * c * c + 13 * c + 16) / 16;
    const double five = versine * (128 + 113 * c + 49 * c * c - 21 * c * c * c - 21 * c * c * c * c) / 128;
    EXPECT_NEAR(normalising_factor(cone_zonal(a, 3)) * three, 1, 1e-14) << a;
    EXPECT_NEAR(normalising_factor(cone_zonal(a, 5)) * five, 1, 1e-14) << a;
    ++compared;
  }
  EXPECT_EQ(compared, 5);
}

TEST(Normalise, MakesAnyLightReflectOne) {
  const Vec3 toward = normalize({1, 2, -0.5}), aside = normalize({1, 1, 0.5});
  constexpr RgbD kOne = {1, 1, 1};
  int compared = 0;
  for (const Sh<RgbD>& light : {directional_sh(toward, kOne, 4), cone_sh(toward, 0.4, kOne, 5), ambient_sh(kOne, 3),
                                smooth_cone_sh(toward, 2, kOne, 7), hemisphere_sh(toward, kOne, {}, 6)}) {
    for (const Vec3 facing : {toward, aside}) {
      const double c = normalising_factor(green(light), facing);
      EXPECT_NEAR(evaluate(irradiance_over_pi(c * green(light)), facing), 1, 1e-14);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 10);
  EXPECT_NEAR(normalising_factor(green(cone_sh(toward, 0.4, kOne, 5)), toward), normalising_factor(cone_zonal(0.4, 5)),
              1e-13);
}

TEST(Normalise, ManyBandsApproachTheExactFactors) {
  int compared = 0;
  for (const double a : {0.2, 1.0, kPi / 2, 2.2, kPi}) {
    // The tail falls like l^-3 for a cone, faster for a smooth one.
    EXPECT_NEAR(normalising_factor(cone_zonal(a, 1000)) / cone_normalising_factor(a), 1, 1e-6) << a;
    EXPECT_NEAR(normalising_factor(smooth_cone_zonal(a, 1000)) / smooth_cone_normalising_factor(a), 1, 1e-6) << a;
    ++compared;
  }
  EXPECT_EQ(compared, 5);
  EXPECT_EQ(cone_normalising_factor(2.2), 1);
}

TEST(Normalise, RefusesWhatReflectsNothing) {
  EXPECT_THROW(normalising_factor(std::vector<double>{0, 0, 0}), Error);
  EXPECT_THROW(normalising_factor(std::vector<double>{}), Error);
  EXPECT_THROW(normalising_factor(std::vector<double>{-1}), Error);
  EXPECT_THROW(normalising_factor(std::vector<double>{std::numeric_limits<double>::quiet_NaN()}), Error);
  EXPECT_THROW(normalising_factor(green(directional_sh({0, 0, 1}, {1, 1, 1}, 2)), {0, 0, -1}), Error);
  EXPECT_THROW(normalising_factor(green(ambient_sh({1, 1, 1}, 2)), {0, 0, 0}), Error);
  EXPECT_THROW(cone_normalising_factor(0), Error);
  EXPECT_THROW(smooth_cone_normalising_factor(4), Error);
}

TEST(NormaliseReference, FactorsAgreeWithThePublishedOnes) {
  const std::filesystem::path path = ZONAL_SOURCE_DIR "/../shared/reference/vectors/normalisation.json";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference vectors here";
  std::ifstream file(path);
  const nlohmann::json reference = nlohmann::json::parse(file);
  int compared = 0;
  const auto expect = [&](double actual, double expected, const std::string& what) {
    EXPECT_NEAR(actual / expected, 1, 1e-12) << what;
    ++compared;
  };
  for (const auto& [bands, factor] : reference["directional_factor"].items()) {
    expect(normalising_factor(delta_zonal(std::stoi(bands))), factor, "directional " + bands);
  }
  expect(normalising_factor(std::vector<double>{1}), reference["ambient_factor_relative_to_e0"], "ambient");
  for (const nlohmann::json& entry : reference["cones"]) {
    const std::string degrees = entry["a_deg"].dump();
    const double a = radians(entry["a_deg"]);
    expect(cone_normalising_factor(a), entry["cone_exact"], "cone " + degrees);
    expect(normalising_factor(cone_zonal(a, 3)), entry["cone_c3"], "cone, 3 bands " + degrees);
    expect(normalising_factor(cone_zonal(a, 5)), entry["cone_c5"], "cone, 5 bands " + degrees);
    expect(smooth_cone_normalising_factor(a), entry["smooth_exact"], "smooth cone " + degrees);
    expect(normalising_factor(smooth_cone_zonal(a, 3)), entry["smooth_c3"], "smooth cone, 3 bands " + degrees);
    expect(normalising_factor(smooth_cone_zonal(a, 5)), entry["smooth_c5"], "smooth cone, 5 bands " + degrees);
  }
  EXPECT_EQ(compared, 10 + 1 + 7 * 6);
}

}  // namespace
}  // namespace zonal
