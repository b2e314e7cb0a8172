#include "zonal/report/bake_verify.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "zonal/light/synthetic.h"

namespace zonal {
namespace {

constexpr Projection kPanorama = {Layout::kEquirect};

TEST(BakeVerify, MeasuresWhatIsThere) {
  const Environment sky = checker(kPanorama, {64, 32});
  Convolved seen = convolve(sky, Lobe::ggx(0.3), kPanorama, {32, 16});
  const Verification good = verify(sky, Lobe::ggx(0.3), seen.map, seen.report, {.directions = 40});
  EXPECT_EQ(good.directions, 40);
  EXPECT_LE(good.rms, good.worst);
  EXPECT_LE(good.worst, 1e-2);  // ten times the aim of 1e-3 of the mean: some directions are darker than the mean

  // A tenth too bright everywhere is a tenth of relative error everywhere.
  for (Rgb& texel : seen.map.radiance.values()) texel = 1.1f * texel;
  const Verification bad = verify(sky, Lobe::ggx(0.3), seen.map, seen.report, {.directions = 40, .bounded = false});
  EXPECT_NEAR(bad.rms, 0.1, 0.01);
  EXPECT_NEAR(bad.worst, 0.1, 0.02);
}

TEST(BakeVerify, BeyondTheBoundIsALogicError) {
  const Environment sky = checker(kPanorama, {64, 32});
  Convolved seen = convolve(sky, Lobe::cosine(), kPanorama, {32, 16});
  EXPECT_NO_THROW(verify(sky, Lobe::cosine(), seen.map, seen.report, {}));
  for (Rgb& texel : seen.map.radiance.values()) texel = texel + Rgb{0.01f, 0, 0};
  EXPECT_THROW(verify(sky, Lobe::cosine(), seen.map, seen.report, {}), std::logic_error);
}

TEST(BakeVerify, TakesAFactor) {
  const Environment sky = gradient(kPanorama, {64, 32});
  Convolved seen = convolve(sky, Lobe::cosine(), kPanorama, {32, 16});
  for (Rgb& texel : seen.map.radiance.values()) texel = static_cast<float>(kPi) * texel;
  EXPECT_LE(verify(sky, Lobe::cosine(), seen.map, seen.report, {.factor = kPi}).rms, 1e-2);
  EXPECT_THROW(verify(sky, Lobe::cosine(), seen.map, seen.report, {}), std::logic_error);
}

}  // namespace
}  // namespace zonal
