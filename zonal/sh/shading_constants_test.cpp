#include "zonal/sh/shading_constants.h"

#include <gtest/gtest.h>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

Sh<RgbD, 3> some_radiance() {
  Sh<RgbD, 3> sh;
  for (int i = 0; i < 9; ++i) sh[i] = {std::sin(1.0 + i), std::cos(2.0 * i), 0.3 * i - 1};
  return sh;
}

TEST(ShadingConstants, VectorsAndMatrixAreTheIrradiance) {
  const Sh<RgbD, 3> radiance = some_radiance(), e = irradiance(radiance), over_pi = irradiance_over_pi(radiance);
  const auto constants = irradiance_over_pi_constants(radiance);
  const auto matrix = irradiance_matrix(radiance);
  const auto constants_f = irradiance_over_pi_constants(cast<Rgb>(radiance));
  const auto matrix_f = irradiance_matrix(cast<Rgb>(radiance));
  int compared = 0;
  for (const Vec3 n : spiral_directions(50)) {
    // Double: a few roundings of nine terms of size 1. Float: the same in float.
    const RgbD a = irradiance_over_pi(constants, n), b = evaluate(over_pi, n);
    EXPECT_NEAR(a.r, b.r, 2e-15);
    EXPECT_NEAR(a.g, b.g, 2e-15);
    EXPECT_NEAR(a.b, b.b, 2e-15);
    const RgbD c = irradiance(matrix, n), d = evaluate(e, n);
    EXPECT_NEAR(c.r, d.r, 8e-15);
    EXPECT_NEAR(c.g, d.g, 8e-15);
    EXPECT_NEAR(c.b, d.b, 8e-15);
    EXPECT_NEAR(irradiance_over_pi(constants_f, n).g, b.g, 1e-6);
    EXPECT_NEAR(irradiance(matrix_f, n).g, d.g, 3e-6);
    ++compared;
  }
  EXPECT_EQ(compared, 50);
}

TEST(ShadingConstants, AConstantOfOneGivesOneAndPi) {
  Sh<Rgb, 3> radiance;
  const auto one = static_cast<float>(2 * std::sqrt(kPi));
  radiance(0, 0) = {one, one, one};
  EXPECT_FLOAT_EQ(irradiance_over_pi(irradiance_over_pi_constants(radiance), {0.6, 0, -0.8}).g, 1);
  EXPECT_FLOAT_EQ(irradiance(irradiance_matrix(radiance), {0.6, 0, -0.8}).g, static_cast<float>(kPi));
}

TEST(ShadingConstants, AMatrixIsSymmetricAndAnswersForOneChannel) {
  Sh<double, 3> radiance;
  for (int i = 0; i < 9; ++i) radiance[i] = std::sin(1.0 + i);
  const IrradianceMatrix<double> matrix = irradiance_matrix(radiance);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) EXPECT_EQ(matrix.rows[i][k], matrix.rows[k][i]);
    EXPECT_NE(matrix.rows[i][3], 0);
  }
  EXPECT_NEAR(irradiance(matrix, {0, 0.6, 0.8}), evaluate(irradiance(radiance), {0, 0.6, 0.8}), 8e-15);
}

}  // namespace
}  // namespace zonal
