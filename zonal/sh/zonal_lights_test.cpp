#include "zonal/sh/zonal_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "zonal/base/error.h"
#include "zonal/math/legendre.h"
#include "zonal/math/quadrature.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

/// z_l of a function of the angle that is zero beyond `rim`, by panels short enough for every band.
std::vector<double> by_quadrature(const std::function<double(double angle)>& f, double rim, int bands) {
  std::vector<double> edges, zonal(bands, 0.0), p(bands);
  const int panels = 4 + bands / 4;
  for (int i = 0; i <= panels; ++i) edges.push_back(rim * i / panels);
  const Quadrature rule = gauss_legendre_panels(24, edges);
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const double angle = rule.nodes[i], half_sine = std::sin(angle / 2);
    legendre_from_versine(2 * half_sine * half_sine, p);
    for (int l = 0; l < bands; ++l) zonal[l] += rule.weights[i] * f(angle) * p[l] * std::sin(angle);
  }
  for (int l = 0; l < bands; ++l) zonal[l] *= std::sqrt(kPi * (2 * l + 1));
  return zonal;
}

/// Both sides are sums of terms up to sqrt(2l+1) z_0.
int expect_near(const std::vector<double>& actual, const std::vector<double>& expected, double relative) {
  EXPECT_EQ(actual.size(), expected.size());
  int compared = 0;
  for (std::size_t l = 0; l < std::min(actual.size(), expected.size()); ++l, ++compared) {
    EXPECT_NEAR(actual[l], expected[l], relative * expected[0] * std::sqrt(2 * static_cast<double>(l) + 1)) << l;
  }
  return compared;
}

constexpr double kAngles[] = {1e-6, 1e-3, 0.01, 0.1, 0.2, 0.7, kPi / 2, 2, 3, kPi - 1e-3, kPi};

TEST(ZonalLights, ConesAtEveryAngleAgreeWithQuadrature) {
  int compared = 0;
  for (const double a : kAngles) {
    compared += expect_near(cone_zonal(a, 120), by_quadrature([](double) { return 1.0; }, a, 120), 2e-14);
  }
  EXPECT_EQ(compared, 11 * 120);
}

TEST(ZonalLights, SmoothConesAtEveryAngleAgreeWithQuadrature) {
  int compared = 0;
  for (const double a : kAngles) {
    const auto profile = [&](double angle) { return smooth_cone_profile(angle, a); };
    for (const int bands : {1, 6, 120}) {
      compared += expect_near(smooth_cone_zonal(a, bands), by_quadrature(profile, a, bands), 2e-14);
    }
  }
  EXPECT_EQ(compared, 11 * 127);
  EXPECT_EQ(smooth_cone_profile(0, 0.5), 1);
  EXPECT_EQ(smooth_cone_profile(0.25, 0.5), 0.5);
  EXPECT_EQ(smooth_cone_profile(0.6, 0.5), 0);
}

TEST(ZonalLights, TheRelationsBetweenThem) {
  constexpr int kBands = 90;
  const std::vector<double> half = upper_half_zonal(kBands), all = constant_zonal(kBands), delta = delta_zonal(kBands);
  EXPECT_EQ(expect_near(cone_zonal(kPi / 2, kBands), half, 4e-16), kBands);
  EXPECT_EQ(expect_near(cone_zonal(kPi, kBands), all, 4e-16), kBands);
  const auto cosine = [](double angle) { return std::cos(angle); };
  EXPECT_EQ(expect_near(clamped_cosine_zonal(kBands), by_quadrature(cosine, kPi / 2, kBands), 1e-14), kBands);
  // A tiny cone of unit integral is a delta, up to l(l+1) angle^2/8 of each band.
  constexpr double kTiny = 5e-8;  // 2.5e-12 at l = 89
  std::vector<double> cone = cone_zonal(kTiny, kBands);
  for (double& z : cone) z /= 4 * kPi * std::pow(std::sin(kTiny / 2), 2);
  EXPECT_EQ(expect_near(cone, delta, 1e-11), kBands);
  EXPECT_EQ(cone_zonal(0, 5), std::vector<double>(5, 0.0));
  EXPECT_TRUE(delta_zonal(0).empty());
}

TEST(ZonalLights, ThousandsOfBandsDrawTheSmoothCone) {
  const std::vector<double> zonal = smooth_cone_zonal(0.3, 2000);
  int compared = 0;
  for (const double angle : {0.0, 0.05, 0.15, 0.29, 0.31, 1.0, 3.0}) {
    // Its second derivative jumps at the rim and its third at the centre: the tail beyond l is about l^-2.
    EXPECT_NEAR(evaluate_zonal(zonal, std::cos(angle)), smooth_cone_profile(angle, 0.3), 2e-5) << angle;
    ++compared;
  }
  EXPECT_EQ(compared, 7);
}

TEST(ZonalLights, SpheresBySizeAndDistance) {
  EXPECT_NEAR(sphere_half_angle(1, 2), kPi / 6, 1e-15);
  EXPECT_EQ(sphere_half_angle(0, 2), 0);
  EXPECT_EQ(sphere_half_angle(1, 1), std::asin(1.0));
  EXPECT_EQ(sphere_half_angle(1, 0.9), kPi);
}

TEST(ZonalLights, RefuseWhatHasNoMeaning) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(cone_zonal(-0.1, 3), Error);
  EXPECT_THROW(cone_zonal(3.2, 3), Error);
  EXPECT_THROW(cone_zonal(nan, 3), Error);
  EXPECT_THROW(smooth_cone_zonal(0, 3), Error);
  EXPECT_THROW(smooth_cone_zonal(nan, 3), Error);
  EXPECT_THROW(sphere_half_angle(-1, 2), Error);
  EXPECT_THROW(sphere_half_angle(0, 0), Error);
  EXPECT_THROW(sphere_half_angle(1, nan), Error);
  EXPECT_THROW(cone_zonal(1, -1), std::logic_error);
}

TEST(ZonalLightsReference, ConesAgreeWithFortyDigits) {
  const std::filesystem::path path = ZONAL_SOURCE_DIR "/../shared/reference/vectors/zh_lights.json";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference vectors here";
  std::ifstream file(path);
  const nlohmann::json reference = nlohmann::json::parse(file);
  int compared = 0;
  const auto compare = [&](const char* name, auto zonal_of) {
    for (const nlohmann::json& entry : reference[name]) {
      const std::vector<double> expected = entry["z"], actual = zonal_of(entry["a"].get<double>(), 11);
      ASSERT_EQ(expected.size(), 11u);
      for (int l = 0; l < 11; ++l, ++compared) {
        // The file is rounded to double, and so is its angle.
        EXPECT_NEAR(actual[l], expected[l], 1e-14 * expected[0]) << name << " " << entry["a_deg"] << " " << l;
      }
    }
  };
  compare("cone_A3", cone_zonal);
  compare("smooth_cone_A4", smooth_cone_zonal);
  EXPECT_EQ(compared, (9 + 11) * 11);
}

}  // namespace
}  // namespace zonal
