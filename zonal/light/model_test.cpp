#include "zonal/light/model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "zonal/base/error.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/convention.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

const std::filesystem::path kVectors = ZONAL_SOURCE_DIR "/../shared/reference/vectors";

nlohmann::json read_json(const char* name) {
  std::ifstream file(kVectors / name);
  return nlohmann::json::parse(file);
}

constexpr RgbD kColor = {2, 3, 0.5};
constexpr Vec3 kToward = {3, -1, 2};

void expect_color(RgbD actual, RgbD expected, double tolerance) {
  EXPECT_NEAR(actual.r, expected.r, tolerance);
  EXPECT_NEAR(actual.g, expected.g, tolerance);
  EXPECT_NEAR(actual.b, expected.b, tolerance);
}

/// Irradiance by a cone, from its coefficients in many bands.
double irradiance_by_bands(double half_angle, double from_normal, int bands) {
  std::vector<double> zonal = cone_zonal(half_angle, bands);
  const std::vector<double> factors = cosine_factors(bands);
  for (int l = 0; l < bands; ++l) zonal[l] *= kPi * factors[l];
  return evaluate_zonal(zonal, std::cos(from_normal));
}

TEST(LightModel, DirectionalLightHasItsIrradiance) {
  const Sh<RgbD> lit = irradiance(directional_sh(kToward, kColor, 600));
  // The clamped cosine with only 600 bands: even l add (2l+1) A_l/4 with alternating signs on the axis, l^-3/2 = 7e-5
  // times the colour, and less off it.
  expect_color(evaluate(lit, normalize(kToward)), kColor, 2e-4);
  expect_color(evaluate(lit, normalize({-1, 0, -1})), {}, 2e-4);
  // The length of the direction does not matter, nor how large it is.
  EXPECT_NEAR(directional_sh(1e200 * kToward, kColor, 4)(3, 2).r, directional_sh(kToward, kColor, 4)(3, 2).r, 1e-15);
}

TEST(LightModel, AmbientAndHemisphereHaveTheirIrradiance) {
  const Vec3 up = normalize(kToward);
  const RgbD sky = {3, 4, 5}, ground = {1, 0.5, 0.25};
  const Sh<RgbD> ambient = irradiance(ambient_sh(sky, 5)), half = irradiance(hemisphere_sh(kToward, sky, ground, 5));
  int compared = 0;
  for (const Vec3 n : spiral_directions(30)) {
    expect_color(evaluate(ambient, n), kPi * sky, 1e-13);
    expect_color(evaluate(half, n), kPi * (ground + (1 + dot(n, up)) / 2 * (sky - ground)), 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 30);
}

TEST(LightModel, ConesAreTurnedAndColoured) {
  const Vec3 axis = normalize(kToward);
  const Sh<RgbD> cone = cone_sh(kToward, 0.7, kColor, 9), smooth = smooth_cone_sh(kToward, 0.7, kColor, 9);
  int compared = 0;
  for (const Vec3 d : spiral_directions(20)) {
    expect_color(evaluate(cone, d), evaluate_zonal(cone_zonal(0.7, 9), dot(d, axis)) * kColor, 1e-13);
    expect_color(evaluate(smooth, d), evaluate_zonal(smooth_cone_zonal(0.7, 9), dot(d, axis)) * kColor, 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 20);
}

TEST(LightModel, SpheresAreConesAndSurroundWhatIsInside) {
  EXPECT_EQ(sphere_sh({0, 0, 2}, 1, kColor, 4), cone_sh({0, 0, 2}, std::asin(0.5), kColor, 4));
  EXPECT_EQ(sphere_sh({0, 0, 0.5}, 1, kColor, 4), ambient_sh(kColor, 4));
  EXPECT_EQ(sphere_sh({0, 0, 0}, 1, kColor, 4), ambient_sh(kColor, 4));
}

TEST(LightModel, IrradianceOfAClippedSphereAgreesWithItsBands) {
  int compared = 0, clipped = 0;
  for (const double half : {0.05, 0.4, 1.0, 1.5, kPi / 2, 2.0, 3.0}) {
    for (int i = 0; i <= 36; ++i, ++compared) {
      const double w = kPi * i / 36;
      clipped += w + half > kPi / 2 && w < kPi / 2 + half;
      // The product of both tails falls like l^-3.
      EXPECT_NEAR(cone_irradiance(half, w), irradiance_by_bands(half, w, 1500), 1e-6) << half << " " << i;
    }
  }
  EXPECT_EQ(compared, 7 * 37);
  EXPECT_GT(clipped, 80);
}

TEST(LightModel, IrradianceIsContinuousWhereItBeginsToBeClipped) {
  constexpr double kStep = 1e-9;
  int compared = 0;
  for (const double half : {0.01, 0.3, 1.2}) {
    for (const double w : {kPi / 2 - half, kPi / 2, kPi / 2 + half}) {
      EXPECT_NEAR(cone_irradiance(half, w - kStep), cone_irradiance(half, w + kStep), 10 * kStep) << half << " " << w;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 9);
}

TEST(LightModel, RefusesWhatHasNoMeaning) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(directional_sh({0, 0, 0}, kColor, 3), Error);
  EXPECT_THROW(directional_sh({0, nan, 1}, kColor, 3), Error);
  EXPECT_THROW(directional_sh({0, inf, 1}, kColor, 3), Error);
  EXPECT_THROW(directional_sh(kToward, {1, nan, 1}, 3), Error);
  EXPECT_THROW(ambient_sh({inf, 1, 1}, 3), Error);
  EXPECT_THROW(hemisphere_sh({0, 0, 0}, kColor, kColor, 3), Error);
  EXPECT_THROW(cone_sh(kToward, 4, kColor, 3), Error);
  EXPECT_THROW(smooth_cone_sh(kToward, 0, kColor, 3), Error);
  EXPECT_THROW(sphere_sh(kToward, -1, kColor, 3), Error);
  EXPECT_THROW(sphere_sh({nan, 0, 0}, 1, kColor, 3), Error);
  EXPECT_THROW(cone_irradiance(-1, 0), Error);
  EXPECT_THROW(cone_irradiance(1, nan), Error);
  EXPECT_THROW(directional_sh(kToward, kColor, 0), std::logic_error);
}

TEST(LightModelReference, SpheresAgreeWithThePublishedCoefficients) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  int compared = 0;
  for (const nlohmann::json& entry : read_json("sphere_light.json")) {
    const auto point = [&](const char* name) { return Vec3{entry[name][0], entry[name][1], entry[name][2]}; };
    const Sh<RgbD> sh = to_condon_shortley(sphere_sh(point("C") - point("P"), entry["r"], {1, 1, 1}, 6));
    ASSERT_EQ(entry["sh"].size(), sh.size());
    for (std::size_t i = 0; i < sh.size(); ++i, ++compared) {
      EXPECT_NEAR(sh[i].g, entry["sh"][i].get<double>(), 1e-14) << i;  // the file is rounded to double
    }
  }
  EXPECT_GE(compared, 2 * 36);
}

TEST(LightModelReference, ClippedSpheresAgreeWithThePublishedIrradiance) {
  if (!std::filesystem::exists(kVectors)) GTEST_SKIP() << "no reference vectors here";
  const nlohmann::json reference = read_json("slides_a.json");
  int compared = 0;
  for (const nlohmann::json& entry : reference["sphere_light"]) {
    const double actual = cone_irradiance(radians(entry["sigma_deg"]), radians(entry["omega_deg"]));
    EXPECT_NEAR(actual, entry["E_closed"].get<double>(), 4e-15) << entry;
    EXPECT_NEAR(actual, entry["E_brute"].get<double>(), 4e-6) << entry;  // 1e-6 pi: the quadrature's own error
    ++compared;
  }
  EXPECT_EQ(compared, 32);
}

}  // namespace
}  // namespace zonal
