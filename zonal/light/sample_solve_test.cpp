#include "zonal/light/sample_solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace zonal {
namespace {

Vec3 near_x(double y, double z) { return normalize({1, y, z}); }

TEST(SampleSolve, CorrectedWeightsReproduceLinearFunctions) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> offset(-0.02, 0.02), inner(-0.01, 0.01);
  int compared = 0;
  for (int trial = 0; trial < 50; ++trial) {
    std::array<Vec3, kPatch> texels;
    std::array<double, kPatch> start{}, ease;
    ease.fill(1);
    for (Vec3& t : texels) t = near_x(offset(random), offset(random));
    start[trial % kPatch] = 0.7, start[(trial + 5) % kPatch] = 0.3;
    const Vec3 toward = near_x(inner(random), inner(random));
    const auto correction = linear_correction(toward, texels, start, ease);
    double sum = 0;
    Vec3 mean;
    for (int k = 0; k < kPatch; ++k) {
      sum += start[k] + correction[k];
      mean += (start[k] + correction[k]) * texels[k];
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    // Along `toward` the constraint is of the square of the spacing: rounding is magnified by its inverse, 1e4.
    EXPECT_LT(length(mean - toward), 1e-11);
    ++compared;
  }
  EXPECT_EQ(compared, 50);
}

TEST(SampleSolve, NothingToCorrectAtATexel) {
  std::array<Vec3, kPatch> texels;
  std::array<double, kPatch> start{}, ease;
  ease.fill(1);
  for (int k = 0; k < kPatch; ++k) texels[k] = near_x(0.01 * (k % 4 - 1), 0.01 * (k / 4 - 1));
  start[5] = 1;  // texels[5] is at (0, 0)
  for (const double c : linear_correction({1, 0, 0}, texels, start, ease)) EXPECT_NEAR(c, 0, 1e-12);
}

TEST(SampleSolve, DegeneratePatchesStayFinite) {
  std::array<Vec3, kPatch> texels;
  std::array<double, kPatch> start{}, ease;
  ease.fill(1);
  start[0] = 1;
  texels.fill(near_x(0.1, 0));  // all in one place, which is not the one asked for
  double sum = 0;
  for (const double c : linear_correction({1, 0, 0}, texels, start, ease)) {
    EXPECT_TRUE(std::isfinite(c));
    sum += c;
  }
  EXPECT_NEAR(sum, 0, 1e-9);
  texels.fill({1, 0, 0});  // all in the place asked for
  for (const double c : linear_correction({1, 0, 0}, texels, start, ease)) EXPECT_EQ(c, 0);
}

}  // namespace
}  // namespace zonal
