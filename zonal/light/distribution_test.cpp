#include "zonal/light/distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "zonal/light/truncation.h"
#include "zonal/sht/ring_grid.h"

namespace zonal {
namespace {

TEST(Distribution, CoversTheSphereAndFindsPeaks) {
  for (const int width : {40, 37, 3}) {
    const RingGrid grid{width, 20};
    const std::vector<double> weights = grid.weights(RingWeights::kTexelArea);
    Grid<Rgb> map(width, 20, {0.5f, 1, 0.25f});
    map(1, 10) = {1e6f, 1, 1};
    map(2, 10) = {1, 1, -2e6f};
    for (const Isa isa : available_isas()) {
      zonal::Run run;
      run.isa = isa;
      const Distribution d(map, weights, 0.01, 10, run);
      ASSERT_EQ(d.peaks().size(), 2U);
      EXPECT_EQ(d.peaks()[0].texel, (GridTexel{2, 10}));
      EXPECT_EQ(d.peaks()[1].texel, (GridTexel{1, 10}));
      EXPECT_EQ(d.maximum(), 2e6f);
      EXPECT_TRUE(d.any_negative());
      double covered = 0;
      for (const Distribution::Bin& bin : d.rest()) {
        covered += bin.solid_angle;
        EXPECT_LT(bin.upper, 2.1f) << "the peaks are not left in";
      }
      EXPECT_NEAR(covered, 4 * kPi, 1e-12);
    }
  }
}

TEST(Distribution, TakesTheLargestWhenThereAreTooMany) {
  const RingGrid grid{16, 8};
  Grid<Rgb> map(16, 8, {1, 1, 1});
  for (int x = 0; x < 16; ++x) map(x, 4).r = 1000.0f + static_cast<float>(x);
  const Distribution d(map, grid.weights(RingWeights::kTexelArea), 1e-3, 3, {});
  ASSERT_EQ(d.peaks().size(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(d.peaks()[i].texel, (GridTexel{15 - i, 4}));
}

TEST(RearrangementBound, HoldsForRandomArrangementsAndIsReachedByTheWorst) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  const int n = 64;
  std::vector<Distribution::Bin> bins;
  std::vector<double> errors, areas;
  for (int i = 0; i < n; ++i) {
    bins.push_back({uniform(random), 4 * kPi / n});
    errors.push_back(uniform(random));
    areas.push_back(4 * kPi / n);
  }
  std::sort(bins.begin(), bins.end(), [](const auto& a, const auto& b) { return a.upper > b.upper; });
  const double bound = rearrangement_bound(bins, errors, areas);
  std::vector<double> order = errors;
  for (int trial = 0; trial < 100; ++trial) {
    std::shuffle(order.begin(), order.end(), random);
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += bins[i].upper * order[i] * areas[i];
    EXPECT_LE(sum, bound * (1 + 1e-12));
  }
  std::sort(order.rbegin(), order.rend());
  double worst = 0;
  for (int i = 0; i < n; ++i) worst += bins[i].upper * order[i] * areas[i];
  EXPECT_NEAR(worst, bound, 1e-12 * bound);
}

double largest(const Truncation& truncation) {
  const std::vector<double> errors = truncation.errors();
  return *std::max_element(errors.begin(), errors.end());
}

TEST(Truncation, LeavesNothingOfASmoothLobeAndTheKinkOfARoughOne) {
  Truncation smooth(Lobe::gaussian(0.3), 64);
  smooth.extend(64);
  EXPECT_LT(largest(smooth), 1e-10);

  Truncation rough(Lobe::cosine(), 128);
  rough.extend(16);
  const double at_16 = largest(rough);
  rough.extend(128);
  const std::vector<double> errors = rough.errors();
  const auto worst = std::max_element(errors.begin(), errors.end());
  // The remainder of the kink falls about like 1/bands and stays at the horizon.
  EXPECT_GT(at_16 / *worst, 7);
  EXPECT_LT(at_16 / *worst, 13);
  EXPECT_NEAR(static_cast<double>(worst - errors.begin()) / static_cast<double>(errors.size()), 0.5, 0.02);
  double sphere = 0;
  for (const double area : rough.solid_angles()) sphere += area;
  EXPECT_NEAR(sphere, 4 * kPi, 1e-12);
}

}  // namespace
}  // namespace zonal
