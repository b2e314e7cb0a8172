#include "zonal/sht/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "zonal/base/error.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

Run on(Isa isa, int threads = 1) {
  zonal::Run run;
  run.isa = isa;
  run.threads = threads;
  return run;
}

Vec3 direction(RingGrid grid, int x, int y) {
  const double phi = kPi - 2 * kPi * (x + 0.5) / grid.width, theta = grid.theta(y);
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Sh<RgbD> random_coefficients(int bands, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Sh<RgbD> sh(bands);
  for (RgbD& c : sh.values()) c = {normal(random), normal(random), normal(random)};
  return sh;
}

Grid<Rgb> random_map(RingGrid grid, unsigned seed = 2) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> uniform(0, 2);
  Grid<Rgb> map(grid.width, grid.height);
  for (Rgb& texel : map.values()) texel = {uniform(random), uniform(random), uniform(random)};
  return map;
}

double largest(const Sh<RgbD>& sh) {
  double most = 0;
  for (const RgbD& c : sh.values()) most = std::max({most, std::abs(c.r), std::abs(c.g), std::abs(c.b)});
  return most;
}

/// The coefficients by their definition: texel by texel.
template <class T>
Sh<RgbD> by_definition(const Grid<T>& map, int bands, RingWeights kind) {
  const RingGrid grid{map.width(), map.height()};
  const std::vector<double> weights = grid.weights(kind);
  Sh<RgbD> sum(bands);
  std::vector<double> values(sum.size());
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      basis(bands, direction(grid, x, y), std::span<double>(values));
      for (std::size_t i = 0; i < values.size(); ++i) sum[i] += weights[y] * values[i] * static_cast<RgbD>(map(x, y));
    }
  }
  return sum;
}

TEST(RingWeights, SumToTheSphere) {
  for (const int height : {1, 2, 3, 17, 64, 513}) {
    for (const RingWeights kind : {RingWeights::kTexelArea, RingWeights::kFejer}) {
      double sum = 0;
      for (const double w : RingGrid{2 * height, height}.weights(kind)) sum += 2 * height * w;
      EXPECT_NEAR(sum, 4 * kPi, 1e-13 * 4 * kPi) << height;
    }
  }
}

TEST(Analyze, IsTheSumOverTexels) {
  // Few and many bands, also beyond what the grid resolves in either direction; odd, prime and tiny sizes.
  int grids = 0;
  for (const RingGrid grid : {RingGrid{64, 32}, {52, 33}, {38, 19}, {134, 9}, {7, 5}, {4, 1}, {1, 1}, {16, 40}}) {
    const Grid<Rgb> map = random_map(grid);
    for (const int bands : {1, 2, 3, 5, 6, 7, 24, 70}) {
      for (const RingWeights kind : {RingWeights::kTexelArea, RingWeights::kFejer}) {
        const Sh<RgbD> expected = by_definition(map, bands, kind);
        for (const Isa isa : available_isas()) {
          const Sh<RgbD> got = analyze(map, bands, kind, on(isa));
          // At most six bands may go through float products: see RingMoments.
          const double tolerance = bands <= 6 ? 1e-6 : 1e-12;
          EXPECT_LT(largest(got - expected), tolerance * largest(expected))
              << grid.width << "x" << grid.height << ", " << bands << " bands, " << name_of(isa);
        }
      }
    }
    ++grids;
  }
  EXPECT_EQ(grids, 8);
}

TEST(Synthesize, IsTheSumOverBands) {
  for (const RingGrid grid : {RingGrid{64, 32}, {52, 33}, {15, 8}, {3, 2}}) {
    const Sh<RgbD> sh = random_coefficients(20);
    for (const Isa isa : available_isas()) {
      const Grid<RgbD> map = synthesize_double(sh, grid, on(isa));
      const Grid<Rgb> floats = synthesize(sh, grid, on(isa));
      for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
          const RgbD expected = evaluate(sh, direction(grid, x, y));
          EXPECT_NEAR(map(x, y).g, expected.g, 1e-12);
          EXPECT_EQ(floats(x, y), static_cast<Rgb>(map(x, y)));
        }
      }
    }
  }
}

TEST(Transform, FejerAnalysisInvertsSynthesis) {
  for (const int bands : {1, 8, 33, 100}) {
    const Sh<RgbD> sh = random_coefficients(bands);
    const RingGrid grid{2 * bands, 2 * bands - 1};  // the least grid for products of two such functions
    const Grid<RgbD> map = synthesize_double(sh, grid);
    EXPECT_LT(largest(analyze(map, bands, RingWeights::kFejer) - sh), 1e-13 * bands) << bands;
  }
}

TEST(SlowTransform, StaysExactAtThousandsOfBands) {
  // Twice as many rows as bands near the poles: columns that underflow without scaling.
  const int bands = 2100;
  Sh<RgbD> sh(bands);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int l = 0; l < bands; l += 7) {
    for (RgbD& c : sh.band(l)) c = {normal(random), normal(random), normal(random)};
  }
  const Grid<RgbD> map = synthesize_double(sh, {2 * bands, 2 * bands});
  const Sh<RgbD> back = analyze(map, bands, RingWeights::kFejer);
  EXPECT_LT(largest(back - sh), 1e-11 * largest(sh));
}

TEST(Transform, SynthesisIsTheAdjointOfAnalysis) {
  const RingGrid grid{50, 31};
  const int bands = 40;
  const Grid<Rgb> map = random_map(grid);
  const Sh<RgbD> sh = random_coefficients(bands);
  const Sh<RgbD> analysed = analyze(map, bands, RingWeights::kTexelArea);
  const Grid<RgbD> synthesised = synthesize_double(sh, grid);
  const std::vector<double> weights = grid.weights(RingWeights::kTexelArea);
  double left = 0, right = 0;
  for (std::size_t i = 0; i < sh.size(); ++i) left += analysed[i].b * sh[i].b;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) right += weights[y] * map(x, y).b * synthesised(x, y).b;
  }
  EXPECT_NEAR(left, right, 1e-12 * std::abs(left));
}

TEST(Transform, HasTheSameBitsForAnyNumberOfThreads) {
  const RingGrid grid{96, 47};
  const Grid<Rgb> map = random_map(grid);
  for (const int bands : {5, 61}) {
    const Sh<RgbD> one = analyze(map, bands, RingWeights::kTexelArea, on(best_isa(), 1));
    for (const int threads : {2, 7}) {
      EXPECT_EQ(analyze(map, bands, RingWeights::kTexelArea, on(best_isa(), threads)), one);
      EXPECT_EQ(synthesize(one, grid, on(best_isa(), threads)), synthesize(one, grid, on(best_isa(), 1)));
    }
  }
}

TEST(Analyze, AConstantIsExactAtAnySize) {
  int sizes = 0;
  for (const int height : {1, 2, 5, 32, 100, 512, 2048}) {
    for (const int bands : {3, 6, 16}) {
      const Sh<RgbD> sh = analyze(Grid<Rgb>(2 * height, height, {0.1f, 1, 7}), bands, RingWeights::kTexelArea);
      EXPECT_NEAR(sh[0].r, 0.1f * std::sqrt(4 * kPi), 1e-6 * 0.1 * std::sqrt(4 * kPi)) << height;
      EXPECT_NEAR(sh[0].b, 7 * std::sqrt(4 * kPi), 1e-6 * 7 * std::sqrt(4 * kPi)) << height;
    }
    ++sizes;
  }
  EXPECT_EQ(sizes, 7);
}

TEST(Analyze, LeavesOutTexels) {
  const RingGrid grid{24, 13};
  Grid<Rgb> map = random_map(grid);
  const std::vector<GridTexel> left_out = {{0, 0}, {5, 6}, {23, 12}, {6, 6}};
  for (const int bands : {4, 9}) {
    const Sh<RgbD> got = analyze(map, bands, RingWeights::kTexelArea, {}, left_out);
    Grid<Rgb> without = map;
    for (const GridTexel& t : left_out) without(t.x, t.y) = {};
    EXPECT_EQ(got, analyze(without, bands, RingWeights::kTexelArea));
    EXPECT_NE(got, analyze(map, bands, RingWeights::kTexelArea));
  }
}

TEST(Transform, CanBeCancelled) {
  std::stop_source source;
  source.request_stop();
  zonal::Run run;
  run.stop = source.get_token();
  EXPECT_THROW(analyze(random_map({64, 32}), 8, RingWeights::kTexelArea, run), Error);
}

}  // namespace
}  // namespace zonal
