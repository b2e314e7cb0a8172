#include "zonal/light/resample_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

TEST(ResampleKernel, PanoramaPositionsMatchTheMapping) {
  const Mapping mapping({}, {2048, 1024});
  const float per_radian = static_cast<float>(-2048 / (2 * kPi));
  const PanoramaScale scale = {1023.5f, per_radian, 511.5f, per_radian};
  std::mt19937 random(11);
  std::normal_distribution<float> normal;
  int compared = 0;
  for (const Isa isa : available_isas()) {
    for (int trial = 0; trial < 200; ++trial) {
      TexelFrames frames{};
      for (int i = 0; i < kKernelPoints; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
          frames.center[axis][i] = normal(random);
          frames.across[axis][i] = 0.01f * normal(random);
          frames.down[axis][i] = 0.01f * normal(random);
        }
      }
      float x[kKernelPoints], y[kKernelPoints];
      resample_kernels(isa).panorama_positions(frames, 0.3f, -0.2f, scale, kKernelPoints, x, y);
      for (int i = 0; i < kKernelPoints; ++i) {
        const auto along = [&](int axis) {
          return frames.center[axis][i] + 0.3 * frames.across[axis][i] - 0.2 * frames.down[axis][i];
        };
        const Vec3 d = {along(0), along(1), along(2)};
        const PixelPoint p = *mapping.position(normalize(d));
        // 1e-6 radians is 3e-4 texels; where the level part is short its own rounding turns the azimuth further.
        const double level = std::hypot(d.x, d.y) / length(d);
        ASSERT_NEAR(std::remainder(x[i] + 0.5 - p.x, 2048), 0, 5e-4 / level) << name_of(isa);
        ASSERT_NEAR(y[i] + 0.5, p.y, 5e-4);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, static_cast<int>(available_isas().size()) * 200 * kKernelPoints);
}

TEST(ResampleKernel, StraightUpIsFinite) {
  TexelFrames frames{};
  for (int i = 0; i < kKernelPoints; ++i) frames.center[2][i] = i % 2 ? 1.0f : -1.0f;
  for (const Isa isa : available_isas()) {
    float x[kKernelPoints], y[kKernelPoints];
    resample_kernels(isa).panorama_positions(frames, 0, 0, {15.5f, -5, 7.5f, -5}, kKernelPoints, x, y);
    EXPECT_FLOAT_EQ(x[0], 15.5f);
    EXPECT_NEAR(y[1], 7.5f - 5 * kPi / 2, 1e-5);
    EXPECT_NEAR(y[0], 7.5f + 5 * kPi / 2, 1e-5);
  }
}

TEST(ResampleKernel, InterpolationIsExactOnPlanesAndListsWhatIsOutside) {
  constexpr int kWidth = 40, kHeight = 30;
  std::vector<Rgb> texels(kWidth * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      texels[y * kWidth + x] = {10 + 0.5f * static_cast<float>(x), 50 - static_cast<float>(y), 7};
    }
  }
  const TexelArray array = {texels.data(), kWidth, kHeight};
  float x[kKernelPoints], y[kKernelPoints];
  int expected_misses = 0;
  for (int i = 0; i < kKernelPoints; ++i) {
    x[i] = -1 + 1.3f * static_cast<float>(i), y[i] = 27.9f - static_cast<float>(i);
    const int left = static_cast<int>(std::floor(x[i])), top = static_cast<int>(std::floor(y[i]));
    expected_misses += left < 1 || left + 2 >= kWidth || top < 1 || top + 3 >= kHeight;
  }
  ASSERT_GT(expected_misses, 3);
  for (const Isa isa : available_isas()) {
    for (const bool cubic : {false, true}) {
      const auto add = cubic ? resample_kernels(isa).add_cubic : resample_kernels(isa).add_linear;
      float sums[kKernelPoints * kSumLanes] = {};
      int missed[kKernelPoints];
      const int misses = add(array, kKernelPoints, x, y, sums, missed);
      EXPECT_EQ(misses, expected_misses);
      std::vector<bool> outside(kKernelPoints, false);
      for (int k = 0; k < misses; ++k) outside[missed[k]] = true;
      for (int i = 0; i < kKernelPoints; ++i) {
        const float* s = sums + kSumLanes * i;
        EXPECT_NEAR(s[0] + s[3], outside[i] ? 0 : 10 + 0.5f * x[i], 1e-4f) << name_of(isa);
        EXPECT_NEAR(s[1] + s[4], outside[i] ? 0 : 50 - y[i], 1e-4f);
        EXPECT_NEAR(s[2] + s[5], outside[i] ? 0 : 7, 1e-5f);
      }
    }
  }
}

TEST(ResampleKernel, SumAndMax) {
  std::vector<float> values(77);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 13) - 20;
  values[70] = 3;
  double expected = 0;
  for (const float v : values) expected += v;
  for (const Isa isa : available_isas()) {
    float sum = 0, max = 0;
    resample_kernels(isa).sum_and_max(values.data(), 77, &sum, &max);
    EXPECT_NEAR(sum, expected, 1e-3);
    EXPECT_EQ(max, 3);
  }
}

}  // namespace
}  // namespace zonal
