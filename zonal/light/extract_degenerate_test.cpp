// Probes that have no lights, too few maxima, or nothing that makes sense; every way of asking.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/light/extract.h"
#include "zonal/light/model.h"
#include "zonal/math/sphere_rule.h"

namespace zonal {
namespace {

template <class Look>
int for_every_option(Look&& look) {
  int options = 0;
  for (const ExtractMetric metric : {ExtractMetric::kRadiance, ExtractMetric::kIrradiance}) {
    for (int bits = 0; bits < 8; ++bits, ++options)
      look(ExtractOptions{3, metric, bits % 2 == 1, bits / 2 % 2 == 1, bits / 4 == 1});
  }
  return options;
}

bool all_finite(const ExtractedLights& extracted) {
  bool finite = std::isfinite(extracted.residual) && std::isfinite(luminance(extracted.ambient));
  for (const auto& [direction, e, half_angle] : extracted.lights) {
    finite = finite && std::isfinite(luminance(e)) && std::abs(length(direction) - 1) < 1e-12 && half_angle >= 0 &&
             half_angle <= kPi / 2 + 1e-12;
  }
  return finite;
}

TEST(ExtractDegenerate, BlackAndConstantProbesHaveNoLights) {
  int compared = 0;
  for (const double value : {0.0, 2.5, -1.0}) {
    Sh<RgbD> probe(4);
    if (value != 0) probe = ambient_sh({value, 2 * value, 3 * value}, 4);
    const auto look = [&](const ExtractOptions& options) {
      const ExtractedLights extracted = extract_lights(probe, options);
      EXPECT_TRUE(extracted.lights.empty());
      EXPECT_TRUE(extracted.maxima.empty());
      EXPECT_EQ(extracted.residual, 0);
      EXPECT_NEAR(extracted.ambient.g, 2 * value, 1e-14);
      ++compared;
    };
    EXPECT_EQ(for_every_option(look), 16);
    probe(2, 1) = {5e-8 * value, 0, 0};  // the rounding of a picture of floats
    EXPECT_EQ(for_every_option(look), 16);
    const Vec3 directions[] = {{0, 0, 1}};
    const ExtractedLights fit = fit_lights(probe, directions);
    EXPECT_EQ(fit.residual, 0);
    EXPECT_EQ(luminance(fit.lights.at(0).irradiance), 0);
  }
  EXPECT_EQ(compared, 96);
}

TEST(ExtractDegenerate, NoNumbersNoBandsNoLights) {
  Sh<RgbD> probe = ambient_sh({1, 1, 1}, 3) + directional_sh({1, 0, 0}, {1, 1, 1}, 3);
  const auto kind_of = [](const auto& work) -> std::optional<ErrorKind> {
    try {
      work();
    } catch (const Error& error) {
      return error.kind();
    }
    return std::nullopt;
  };
  const Vec3 x[] = {{1, 0, 0}}, zero[] = {{0, 0, 0}};
  EXPECT_EQ(kind_of([&] { extract_lights(with_bands(probe, 1)); }), ErrorKind::kUsage);
  EXPECT_EQ(kind_of([&] { extract_lights(Sh<RgbD>(0)); }), ErrorKind::kUsage);
  EXPECT_EQ(kind_of([&] { extract_lights(probe, {.lights = -1}); }), ErrorKind::kUsage);
  EXPECT_EQ(kind_of([&] { fit_lights(probe, zero); }), ErrorKind::kUsage);
  EXPECT_EQ(kind_of([&] { fit_lights(with_bands(probe, 1), x); }), ErrorKind::kUsage);
  EXPECT_EQ(kind_of([&] { extract_lights(probe); }), std::nullopt);
  EXPECT_EQ(extract_lights(probe, {.lights = 0}).residual, 1);
  EXPECT_TRUE(extract_lights(probe, {.lights = 0}).lights.empty());
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const std::size_t i : {0u, 5u}) {
      Sh<RgbD> broken = probe;
      broken[i].b = bad;
      EXPECT_EQ(kind_of([&] { extract_lights(broken); }), ErrorKind::kInput);
      EXPECT_EQ(kind_of([&] { fit_lights(broken, x); }), ErrorKind::kInput);
    }
  }
}

TEST(ExtractDegenerate, OfTwoEqualDirectionsTheLaterGetsNothing) {
  const Sh<RgbD> probe =
      ambient_sh({1, 1, 1}, 3) + directional_sh({1, 0, 0}, {1, 2, 3}, 3) + directional_sh({0, 0, 1}, {2, 1, 1}, 3);
  const Vec3 twice[] = {{1, 0, 0}, {0, 0, 5}, {2, 0, 0}}, once[] = {{1, 0, 0}, {0, 0, 5}};
  for (const bool nonnegative : {true, false}) {
    const ExtractedLights a = fit_lights(probe, twice, ExtractMetric::kIrradiance, nonnegative);
    const ExtractedLights b = fit_lights(probe, once, ExtractMetric::kIrradiance, nonnegative);
    ASSERT_EQ(a.lights.size(), 3u);  // all of them, in the order asked
    EXPECT_EQ(luminance(a.lights[2].irradiance), 0);
    EXPECT_NEAR(a.lights[0].irradiance.b, 3, 1e-12);
    EXPECT_NEAR(b.lights[1].irradiance.r, 2, 1e-12);
    EXPECT_NEAR(a.residual, b.residual, 1e-12);
  }
}

TEST(ExtractDegenerate, RingsAndOppositeLights) {
  Sh<RgbD> ring = ambient_sh({2, 2, 2}, 3);
  ring(2, 0) = {-1, -1, -1};  // highest all along the equator
  const Sh<RgbD> opposite = directional_sh({0, 0, 1}, {1, 1, 1}, 4) + directional_sh({0, 0, -1}, {1, 1, 1}, 4);
  Sh<RgbD> colours_cancel = ambient_sh({1, 1, 1}, 3);
  colours_cancel(1, 0) = {0.7152, -0.2126, 0};  // no luminance, but not grey
  int looked = 0;
  for (const Sh<RgbD>& probe : {ring, opposite, colours_cancel}) {
    looked += for_every_option([&](const ExtractOptions& options) {
      const ExtractedLights extracted = extract_lights(probe, options);
      EXPECT_TRUE(all_finite(extracted));
      EXPECT_LE(extracted.residual, 1);
    });
  }
  EXPECT_EQ(looked, 48);
  const ExtractedLights pair = extract_lights(opposite, {.lights = 2});
  ASSERT_EQ(pair.lights.size(), 2u);
  EXPECT_NEAR(dot(pair.lights[0].direction, pair.lights[1].direction), -1, 1e-12);
  EXPECT_LT(pair.residual, 1e-10);
}

TEST(ExtractDegenerate, AChannelOfNegativeMeanHasNoLights) {
  Sh<RgbD> probe = ambient_sh({1, 1, -1}, 3) + directional_sh({1, 0, 0}, {1, 1, 1}, 3);
  const ExtractedLights extracted = extract_lights(probe);
  ASSERT_EQ(extracted.lights.size(), 1u);
  EXPECT_EQ(extracted.lights[0].irradiance.b, 0);
  EXPECT_NEAR(extracted.ambient.b, -1 + 1 / (4 * kPi), 1e-14);
  EXPECT_NEAR(extracted.lights[0].irradiance.r, 1, 1e-12);
}

TEST(ExtractDegenerate, HugeAndTinyProbesAreLikeOthers) {
  const Sh<RgbD> probe =
      ambient_sh({1, 1, 1}, 4) + directional_sh({1, 0, 0}, {1, 2, 3}, 4) + directional_sh({0, -1, 1}, {2, 1, 1}, 4);
  const ExtractedLights one = extract_lights(probe, {.lights = 2, .refine = true});
  ASSERT_EQ(one.lights.size(), 2u);
  int compared = 0;
  for (const double scale : {1e-250, 1e250}) {
    const ExtractedLights other = extract_lights(scale * probe, {.lights = 2, .refine = true});
    ASSERT_EQ(other.lights.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i, ++compared) {
      EXPECT_NEAR(length(other.lights[i].direction - one.lights[i].direction), 0, 1e-7);
      EXPECT_NEAR(other.lights[i].irradiance.g / scale, one.lights[i].irradiance.g, 1e-6);
    }
  }
  EXPECT_EQ(compared, 4);
}

}  // namespace
}  // namespace zonal
