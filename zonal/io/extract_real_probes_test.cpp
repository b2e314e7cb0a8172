// Lights out of real environments. Here, because the floor of the lights cannot read files.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "zonal/io/environment_file.h"
#include "zonal/light/extract.h"
#include "zonal/light/project.h"
#include "zonal/light/survey.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

const std::filesystem::path kEquirect = ZONAL_SOURCE_DIR "/../shared/data/equirect";
constexpr std::array<const char*, 2> kProbes = {"venice_sunset_1k.hdr", "pmndrs_studio.exr"};

TEST(ExtractRealProbes, LightsReplaceTheProbe) {
  if (!std::filesystem::exists(kEquirect)) GTEST_SKIP() << "no real environments here";
  int compared = 0;
  for (const char* name : kProbes) {
    const Environment environment = load_environment(kEquirect / name).environment;
    for (const int bands : {3, 6}) {
      const Sh<RgbD> probe = project(environment, bands);
      for (const ExtractMetric metric : {ExtractMetric::kRadiance, ExtractMetric::kIrradiance}) {
        double before = 1;
        for (int lights = 1; lights <= 4; ++lights, ++compared) {
          const double plain = extract_lights(probe, {.lights = lights, .metric = metric}).residual;
          const ExtractedLights refined = extract_lights(probe, {.lights = lights, .metric = metric, .refine = true});
          EXPECT_LE(refined.residual, plain) << name;
          EXPECT_LT(refined.residual, before) << name;  // there is always something left to explain
          EXPECT_EQ(refined.lights.size(), static_cast<std::size_t>(lights));
          before = refined.residual;

          const RgbD kept = project(refined, bands)[0], whole = probe[0];
          EXPECT_NEAR(luminance(kept) / luminance(whole), 1, 1e-12) << "energy";
          double least = std::min({refined.ambient.r, refined.ambient.g, refined.ambient.b});
          for (const auto& [direction, e, half_angle] : refined.lights) least = std::min({least, e.r, e.g, e.b});
          EXPECT_GE(least, -1e-14 * luminance(whole));
        }
      }
      // Four lights and the ambient shade a matte ball like the probe: within a tenth of its directional light.
      const ExtractedLights four = extract_lights(probe, {.lights = 4, .refine = true});
      const Sh<RgbD> shading = irradiance_over_pi(probe), like = irradiance_over_pi(project(four, bands));
      double left = 0, size = 0;
      for (const auto& [n, weight] : sphere_rule(bands + 1)) {
        const RgbD difference = evaluate(like, n) - evaluate(shading, n);
        const RgbD directional = evaluate(shading, n) - evaluate(with_bands(shading, 1), n);
        left += weight * luminance(difference * difference);
        size += weight * luminance(directional * directional);
      }
      EXPECT_LT(std::sqrt(left / size), 0.1) << name;
      EXPECT_NEAR(std::sqrt(left / size), four.residual, 1e-9) << name;
    }
  }
  EXPECT_EQ(compared, 2 * 2 * 2 * 4);
}

TEST(ExtractRealProbes, TheBrightestLightIsTheSunOfTheSunset) {
  if (!std::filesystem::exists(kEquirect)) GTEST_SKIP() << "no real environments here";
  const Environment environment = load_environment(kEquirect / kProbes[0]).environment;
  const Survey surveyed = survey(environment);
  ASSERT_TRUE(surveyed.sun.has_value());
  for (const bool refine : {false, true}) {
    const ExtractedLights extracted =
        extract_lights(project(environment, 10), {.metric = ExtractMetric::kRadiance, .refine = refine});
    ASSERT_EQ(extracted.lights.size(), 1u);
    const ExtractedLight& light = extracted.lights[0];
    // Ten bands see 20 degrees as one lobe, and the glow around the sun lies above the horizon only.
    EXPECT_LT(degrees(angle_between(light.direction, surveyed.sun->toward_sun)), 10) << refine;
    EXPECT_GT(light.irradiance.r, light.irradiance.b) << "a setting sun is red";
  }
}

}  // namespace
}  // namespace zonal
