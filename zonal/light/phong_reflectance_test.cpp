#include "zonal/light/phong_reflectance.h"

#include <gtest/gtest.h>

#include "zonal/base/error.h"
#include "zonal/light/ambient_reflectance.h"

namespace zonal {
namespace {

TEST(PhongReflectance, IsTheIntegralOfTheBrdf) {
  int compared = 0;
  for (const double exponent : {0.0, 1.0, 3.5, 20.0, 512.0, 1e4}) {
    for (const double n_dot_v : {1e-3, 0.02, 0.1, 0.4, 0.75, 0.97, 1.0}) {
      const Reflectance phong = ambient_reflectance(phong_brdf(exponent), n_dot_v, 1e-7);
      const Reflectance blinn = ambient_reflectance(blinn_phong_brdf(exponent), n_dot_v, 1e-7);
      EXPECT_NEAR(phong_reflectance(n_dot_v, exponent), phong.value.g, phong.error + 1e-6)
          << n_dot_v << " " << exponent;
      EXPECT_NEAR(blinn_phong_reflectance(n_dot_v, exponent), blinn.value.g, blinn.error + 1e-6)
          << n_dot_v << " " << exponent;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 42);
}

TEST(PhongReflectance, IsAllAtNormalIncidence) {
  for (const double exponent : {0.0, 7.0, 100.0, 3000.0}) {
    EXPECT_NEAR(phong_reflectance(1, exponent), 1, 1e-9) << exponent;
    EXPECT_NEAR(blinn_phong_reflectance(1, exponent), 1, 1e-9) << exponent;
    EXPECT_LT(phong_reflectance(0.01, exponent), 0.75) << exponent;
  }
}

TEST(PhongReflectance, RefusesWhatIsOutsideItsDomain) {
  EXPECT_THROW((void)phong_reflectance(0, 1), Error);
  EXPECT_THROW((void)phong_reflectance(1.01, 1), Error);
  EXPECT_THROW((void)phong_reflectance(0.5, -1), Error);
  EXPECT_THROW((void)blinn_phong_reflectance(0.5, 2e4), Error);
}

}  // namespace
}  // namespace zonal
