#include "zonal/light/survey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "zonal/light/survey_kernel.h"
#include "zonal/light/synthetic.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr Layout kSome[] = {Layout::kEquirect,   Layout::kCubeCross, Layout::kOctahedral,
                            Layout::kMirrorBall, Layout::kAngular,   Layout::kDualParaboloid};
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(Survey, Furnace) {
  for (const Layout layout : kSome) {
    const Survey s = survey(furnace({layout}, image_size(layout, 64), {0.5f, 1, 2}));
    EXPECT_NEAR(s.shown, 4 * kPi, 1e-6) << name_of(layout);
    EXPECT_NEAR(s.mean.r, 0.5, 1e-6);
    EXPECT_NEAR(s.mean.b, 2, 1e-6);
    EXPECT_FLOAT_EQ(static_cast<float>(s.max_luminance), static_cast<float>(s.min_luminance));
    EXPECT_EQ(s.plateau_texels, s.texels);
    EXPECT_FALSE(s.clipped_sun);
    EXPECT_FALSE(s.sun.has_value());
    EXPECT_EQ(s.nan_texels + s.inf_texels + s.negative_texels, 0);
    // All of it in the bin of luminance 0.97: [1/2, 1).
    EXPECT_NEAR(s.histogram[-1 - kFirstBinLog2], 4 * kPi, 1e-6);
    EXPECT_NEAR(std::accumulate(s.histogram.begin(), s.histogram.end(), 0.0), s.shown, 1e-9);
  }
}

TEST(Survey, CountsDoubtfulTexels) {
  for (const Layout layout : {Layout::kEquirect, Layout::kOctahedral}) {
    Environment e = furnace({layout}, image_size(layout, 32));
    e.radiance(3, 10).g = kNan;
    e.radiance(20, 10).r = kInf;
    e.radiance(9, 21).b = -kInf;
    e.radiance(5, 5) = {-1, 1, 1};
    e.radiance(6, 25) = {0.5f, -0.25f, 1};
    const Survey s = survey(e);
    EXPECT_EQ(s.nan_texels, 1);
    EXPECT_EQ(s.inf_texels, 2);
    EXPECT_EQ(s.negative_texels, 2);
    const Mapping mapping({layout}, image_size(layout, 32));
    const double minus = mapping.solid_angle(5, 5) + 0.25 * mapping.solid_angle(6, 25);
    EXPECT_NEAR(s.negative_energy_share, minus / (3 * 4 * kPi), 0.01 * minus);
    EXPECT_NEAR(s.mean.g, 1, 1e-2);
    EXPECT_EQ(s.max_luminance, survey(furnace({layout}, image_size(layout, 32))).max_luminance);
  }
}

TEST(Survey, NothingFinite) {
  const Survey s = survey(furnace({}, {8, 4}, {kNan, 1, 1}));
  EXPECT_EQ(s.nan_texels, 32);
  EXPECT_EQ(s.mean, RgbD{});
  EXPECT_FALSE(s.sun.has_value());
}

TEST(Survey, FindsTheSun) {
  int compared = 0;
  for (const Layout layout : kSome) {
    for (const Vec3 toward : {normalize({0.6, 0.2, 0.7}), normalize({-0.2, -0.9, 0.05}), normalize({0.02, 0.01, 1})}) {
      const SunOptions options = {.toward_sun = toward, .diameter_deg = 4, .sky = {1, 2, 3}, .contrast = 1e4};
      const Survey s = survey(sun({layout}, image_size(layout, 256), options));
      ASSERT_TRUE(s.sun.has_value()) << name_of(layout);
      EXPECT_LT(degrees(angle_between(s.sun->toward_sun, toward)), 0.1) << name_of(layout);
      EXPECT_NEAR(s.sun->diameter_deg, 4, 0.02);
      const double half = std::sin(radians(1)), disc = 4 * kPi * half * half;
      // Facing the disc: π sin² of its radius, a little under its solid angle; texel centres stand for their texels.
      const double expected = (1e4 - 1) * kPi * std::pow(std::sin(radians(2)), 2);
      EXPECT_NEAR(s.sun->irradiance.g / (2 * expected), 1, 2e-4);
      const double total = 4 * kPi + (1e4 - 1) * disc;
      EXPECT_NEAR(s.sun->energy_share, (1e4 - 1) * disc / total, 1e-4);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 18);
}

TEST(Survey, ATinySunIsATexelWide) {
  const Survey s = survey(sun({}, {64, 32}, {.toward_sun = normalize({1, 0.03, 0.05}), .diameter_deg = 0.5}));
  ASSERT_TRUE(s.sun.has_value());
  EXPECT_GT(s.sun->diameter_deg, 3);  // texels of 5.6 degrees
  EXPECT_LT(s.sun->diameter_deg, 9);
}

TEST(Survey, SuspectsAClippedSun) {
  Environment e = sun({}, {512, 256}, {.diameter_deg = 5, .contrast = 1e4});
  EXPECT_FALSE(survey(e).clipped_sun);
  for (Rgb& c : e.radiance.values()) c = {std::min(c.r, 20.f), std::min(c.g, 20.f), std::min(c.b, 20.f)};
  const Survey s = survey(e);
  EXPECT_TRUE(s.clipped_sun);
  EXPECT_GT(s.plateau_texels, 20);
}

TEST(Survey, SameBitsForAnyNumberOfThreads) {
  Environment e = daylight_sky({}, {300, 150});
  e.radiance(17, 40).r = kNan;
  const auto with = [&](int threads) {
    zonal::Run run;
    run.threads = threads;
    return survey(e, run);
  };
  const Survey one = with(1);
  for (const int threads : {2, 7}) {
    const Survey s = with(threads);
    EXPECT_EQ(s.mean, one.mean);
    EXPECT_EQ(s.histogram, one.histogram);
    EXPECT_EQ(s.shown, one.shown);
    EXPECT_EQ(s.negative_energy_share, one.negative_energy_share);
    EXPECT_EQ(s.sun, one.sun);
  }
}

TEST(SurveyKernel, EveryInstructionSetCountsAsAPlainLoopDoes) {
  std::mt19937 random(9);
  std::normal_distribution<float> normal(1, 2);
  int compared = 0;
  for (const int width : {1, 3, 63, 64, 65, 500}) {
    std::vector<Rgb> row(width);
    for (Rgb& c : row) c = {normal(random), std::exp(3 * normal(random)), normal(random)};
    RgbD sum;
    double negative_sum = 0;
    int negative = 0, dark = 0;
    float most = -kInf;
    for (const Rgb& c : row) {
      sum += RgbD(c);
      negative_sum += std::min(c.r, 0.f) + std::min(c.g, 0.f) + std::min(c.b, 0.f);
      negative += c.r < 0 || c.g < 0 || c.b < 0;
      dark += luminance(c) < 1;
      most = std::max(most, max_channel(c));
    }
    for (const Isa isa : available_isas()) {
      RowCount count;
      survey_kernels(isa).count_row(row.data(), width, &count);
      EXPECT_TRUE(count.finite);
      EXPECT_NEAR(count.sum[1], sum.g, 1e-5 * std::abs(sum.g));
      EXPECT_NEAR(count.negative_sum, negative_sum, 1e-5 * std::abs(negative_sum) + 1e-4);
      EXPECT_EQ(count.negative_texels, negative) << width << name_of(isa);
      EXPECT_EQ(count.max_channel, most);
      EXPECT_EQ(std::accumulate(count.bins, count.bins + kLuminanceBins, 0), width);
      EXPECT_EQ(std::accumulate(count.bins, count.bins - kFirstBinLog2, 0), dark);
      row[width / 2].r = kNan;
      survey_kernels(isa).count_row(row.data(), width, &count);
      EXPECT_FALSE(count.finite);
      row[width / 2].r = kInf;
      survey_kernels(isa).count_row(row.data(), width, &count);
      EXPECT_FALSE(count.finite);
      row[width / 2].r = 1;
      survey_kernels(isa).count_row(row.data(), width, &count);
      sum = RgbD{count.sum[0], count.sum[1], count.sum[2]};
      negative = count.negative_texels, negative_sum = count.negative_sum;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6 * static_cast<int>(available_isas().size()));
}

TEST(Repair, ReplacesAndCounts) {
  Environment e = furnace({}, {16, 8}, {2, 2, 2});
  e.radiance(0, 3) = {kNan, 1, 1};
  e.radiance(15, 3) = {1, kInf, 1};  // its neighbour over the seam
  e.radiance(7, 7) = {-1, 5, -2};
  const Repairs r = repair(e);
  EXPECT_EQ(r, (Repairs{2, 1}));
  EXPECT_EQ(e.radiance(0, 3), (Rgb{2, 2, 2}));
  EXPECT_EQ(e.radiance(15, 3), (Rgb{2, 2, 2}));
  EXPECT_EQ(e.radiance(7, 7), (Rgb{0, 5, 0}));
  EXPECT_EQ(repair(e), (Repairs{0, 0}));
  Environment lost = furnace({}, {4, 2}, {kNan, kNan, kNan});
  EXPECT_EQ(repair(lost).non_finite, 8);
  EXPECT_EQ(lost.radiance(2, 1), Rgb{});
}

}  // namespace
}  // namespace zonal
