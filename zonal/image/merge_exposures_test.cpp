#include "zonal/image/merge_exposures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "zonal/image/response_debevec.h"
#include "zonal/image/synthetic_bracket_test.h"

namespace zonal {
namespace {

constexpr MergeRule kRules[] = {MergeRule::kLogMean, MergeRule::kLeastSquares};

/// Differences in stops between two pictures, over all channels, sorted.
std::vector<double> differences(const Image<Rgb>& a, const Image<Rgb>& b) {
  std::vector<double> stops;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Rgb p = a.values()[i], q = b.values()[i];
    for (const double ratio : {p.r / q.r, p.g / q.g, p.b / q.b}) stops.push_back(std::abs(std::log2(ratio)));
  }
  std::sort(stops.begin(), stops.end());
  return stops;
}

/// Codes written out: what each exposure shows in one texel, grey.
Exposures texel(const std::vector<std::pair<double, int>>& codes) {
  Exposures bracket;
  for (const auto& [seconds, code] : codes) {
    const float value = static_cast<float>(code) / 255;
    bracket.push_back({"", seconds, CodedPicture(Image<Rgb>(1, 1, {value, value, value}))});
  }
  return bracket;
}

TEST(MergeExposures, FindsKnownRadiance) {
  const Image<Rgb> truth = sample::scene(160, 120);
  // Without noise: what is left is rounding to 8 bits, at most half a code in the best exposure. The texels are
  // in 20..200 somewhere: half a code in 20 is 2.5 % of the code, 0.08 stops of an sRGB exposure; on average a tenth of
  // that.
  const Exposures bracket = sample::bracket(truth, {sample::srgb_camera}, sample::nine_times());
  int merged = 0;
  for (const MergeRule rule : kRules) {
    const Merge merge = merge_exposures(bracket, Response::srgb(), {.rule = rule});
    const std::vector<double> stops = differences(merge.radiance, truth);
    ASSERT_EQ(stops.size(), 3u * 160 * 120);
    EXPECT_LT(stops[stops.size() / 2], 0.006);
    EXPECT_LT(stops[stops.size() * 99 / 100], 0.03);
    EXPECT_EQ(merge.saturated + merge.black + merge.conflicting + merge.no_data, 0);
    ++merged;
  }
  EXPECT_EQ(merged, 2);
}

TEST(MergeExposures, FindsKnownRadianceThroughAnEstimatedCurveAndNoise) {
  const Image<Rgb> truth = sample::scene(160, 120);
  const Exposures bracket = sample::bracket(truth, {sample::film_camera, 1.0}, sample::nine_times());
  const ResponseFit fit = estimate_response_debevec(sample_flat_texels(bracket, 2000));
  // film_camera, inverted, and in the scale of an estimate.
  Response known;
  for (ResponseCurve& curve : known.exposure) {
    for (int z = 0; z < kCodes - 1; ++z) curve[z] = 0.25 * std::pow(z / (255.0 - z), 1 / 0.9);
    curve[kCodes - 1] = curve[kCodes - 2];
  }
  const double scale = known.exposure[0][kMiddleCode] / middle_exposure();
  Image<Rgb> estimated = merge_exposures(bracket, fit.response).radiance;
  for (Rgb& p : estimated.values()) p = scale * p;
  const std::vector<double> with_estimate = differences(estimated, truth),
                            with_known = differences(merge_exposures(bracket, known).radiance, truth);
  ASSERT_EQ(with_estimate.size(), 3u * 160 * 120);
  for (const std::size_t percent : {50, 90}) {
    const std::size_t at = with_known.size() * percent / 100;
    // The noise of one code, which also the known curve leaves, and hardly more.
    EXPECT_LT(with_known[at], 0.1);
    EXPECT_LT(with_estimate[at], 1.1 * with_known[at] + 0.003) << percent;
  }
}

TEST(MergeExposures, SixteenBitsAreKept) {
  const Image<Rgb> truth = sample::scene(64, 48);
  const auto linear = [](double exposure) { return exposure; };
  const Exposures bracket = sample::bracket(truth, {linear, 0, 16}, sample::nine_times());
  EXPECT_EQ(bracket[0].picture.levels(), 65536);
  int merged = 0;
  for (const MergeRule rule : kRules) {
    const std::vector<double> stops =
        differences(merge_exposures(bracket, Response::linear(), {.rule = rule}).radiance, truth);
    // With 8 bits the median would be 256 times larger.
    EXPECT_LT(stops[stops.size() / 2], 1e-4);
    ++merged;
  }
  EXPECT_EQ(merged, 2);
}

TEST(MergeExposures, AveragesAsPublished) {
  // Codes 64 and 128 of a linear camera at 1 and 2.5 s: radiances 64/255 and 51.2/255.
  const Exposures bracket = texel({{1, 64}, {2.5, 128}});
  const double a = 64.0 / 255, b = 51.2 / 255;
  const double hat_a = code_weight(CodeWeight::kHat, {}, 64 / 255.0),
               hat_b = code_weight(CodeWeight::kHat, {}, 128 / 255.0);
  const double debevec = std::exp((hat_a * std::log(a) + hat_b * std::log(b)) / (hat_a + hat_b));
  EXPECT_NEAR(merge_exposures(bracket, Response::linear()).radiance(0, 0).g / debevec, 1, 1e-6);
  const double wa = code_weight(CodeWeight::kGaussian, {}, 64 / 255.0),
               wb = code_weight(CodeWeight::kGaussian, {}, 128 / 255.0) * 2.5 * 2.5;
  const double robertson = (wa * a + wb * b) / (wa + wb);
  EXPECT_NEAR(
      merge_exposures(bracket, Response::linear(), {.rule = MergeRule::kLeastSquares}).radiance(0, 0).g / robertson, 1,
      1e-6);
}

TEST(MergeExposures, LeastSquaresTrustsASteepCurveLess) {
  // A curve with a shoulder: codes over 128 stand for four times the light that the codes below do.
  Response film;
  for (ResponseCurve& curve : film.exposure) {
    for (int z = 0; z < kCodes; ++z) curve[z] = z <= 128 ? z : 128 + 4 * (z - 128);
  }
  // 100 at 1 s; 180 at 4 s is 336, so 84: the two disagree. By code alone 4² and the Gaussian would decide for 84.
  const double radiance =
      merge_exposures(texel({{1, 100}, {4, 180}}), film, {.rule = MergeRule::kLeastSquares}).radiance(0, 0).g;
  const double wa = code_weight(CodeWeight::kGaussian, {}, 100 / 255.0),
               wb = code_weight(CodeWeight::kGaussian, {}, 180 / 255.0) * 16 / 16;  // t² over X'²
  EXPECT_NEAR(radiance, (wa * 100 + wb * 84) / (wa + wb), 1e-4);
  EXPECT_GT(radiance, 93);
}

TEST(MergeExposures, SaysWhereNothingIsKnown) {
  struct Case {
    std::vector<std::pair<double, int>> codes;
    double radiance;
    std::uint8_t source;
    std::array<std::int64_t, 4> counts;  ///< saturated, black, conflicting, no data
  };
  const Case cases[] = {
      {{{0.5, 255}, {4, 255}}, 2, kOnlySaturated, {1, 0, 0, 0}},  // 1 / 0.5 s, a lower bound
      {{{0.5, 0}, {4, 0}}, 0, kOnlyBlack, {0, 1, 0, 0}},          //
      {{{0.5, 0}, {4, 255}}, 0.25, kInConflict, {0, 0, 1, 0}},    // 1 / 4 s
      {{{0.5, 255}, {4, 0}}, 2, kInConflict, {0, 0, 1, 0}},       // moved
      {{{0.5, 51}, {4, 255}}, 0.4, 0, {0, 0, 0, 0}},              //
      {{{0.5, 0}, {4, 51}}, 0.05, 1, {0, 0, 0, 0}},               //
  };
  int checked = 0;
  for (const Case& c : cases) {
    for (const MergeRule rule : kRules) {
      const Merge merge = merge_exposures(texel(c.codes), Response::linear(), {.rule = rule});
      EXPECT_NEAR(merge.radiance(0, 0).r, c.radiance, 1e-6);
      EXPECT_EQ(merge.source(0, 0), c.source);
      EXPECT_EQ((std::array{merge.saturated, merge.black, merge.conflicting, merge.no_data}), c.counts);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 12);
  Exposures outside = texel({{1, 100}, {2, 100}});
  for (Exposure& e : outside) e.placement = {5, 0};
  const Merge merge = merge_exposures(outside, Response::linear());
  EXPECT_EQ(merge.no_data, 1);
  EXPECT_EQ(merge.source(0, 0), kNoData);
  EXPECT_EQ(merge.radiance(0, 0), Rgb(0, 0, 0));
}

TEST(MergeExposures, BoundsAreBounds) {
  const Image<Rgb> truth = sample::scene(160, 120);
  const Exposures bracket = sample::bracket(truth, {sample::srgb_camera}, {0.25, 1, 4});
  const Merge merge = merge_exposures(bracket, Response::srgb());
  std::int64_t saturated = 0, black = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Rgb t = truth.values()[i], m = merge.radiance.values()[i];
    if (merge.source.values()[i] == kOnlySaturated) {
      // Saturated from half a code below full on: 254.5.
      EXPECT_GE(max_channel(t) * 0.25f, 0.99f);
      EXPECT_LE(max_channel(m), 4.0001f);
      ++saturated;
    }
    if (merge.source.values()[i] == kOnlyBlack) {
      EXPECT_LT(max_channel(t) * 4, 0.5 / 255 / 12.92 * 1.0001);
      EXPECT_EQ(m, Rgb(0, 0, 0));
      ++black;
    }
  }
  EXPECT_EQ(saturated, merge.saturated);
  EXPECT_GT(saturated, 100);
  EXPECT_GE(merge.black, black);
}

TEST(MergeExposures, TrustedCodesAreTheOnlyOnesUsed) {
  const Exposures bracket = texel({{1, 20}, {4, 100}, {16, 251}});
  const TrustedCodes range{20, 250};
  const Merge merge = merge_exposures(bracket, Response::linear(), {.trusted = {range, range, range}});
  EXPECT_NEAR(merge.radiance(0, 0).b, 100.0 / 255 / 4, 1e-7);
  EXPECT_EQ(merge.source(0, 0), 1);
}

TEST(MergeExposures, FloatsAreLinearAndUnlimitedBelowOne) {
  Exposures bracket;
  for (const double seconds : {1.0, 4.0}) {
    const float value = static_cast<float>(1.2345e-5 * seconds);
    bracket.push_back({"", seconds, CodedPicture(Image<Rgb>(1, 1, {value, 0.1234f * static_cast<float>(seconds), 2}))});
  }
  ASSERT_EQ(bracket[0].picture.levels(), 0);
  const Merge merge = merge_exposures(bracket, Response::linear());
  EXPECT_NEAR(merge.radiance(0, 0).r / 1.2345e-5, 1, 1e-5);
  EXPECT_NEAR(merge.radiance(0, 0).g, 0.1234, 1e-6);
  EXPECT_EQ(merge.saturated, 1);
  EXPECT_EQ(merge.radiance(0, 0).b, 2);
}

TEST(MergeExposures, MasksLeaveOutButNeverTheOnlyExposure) {
  const Exposures bracket = texel({{1, 64}, {2.5, 128}});
  const std::vector<Image<std::uint8_t>> first = {Image<std::uint8_t>(1, 1, 255), Image<std::uint8_t>(1, 1, 0)};
  EXPECT_NEAR(merge_exposures(bracket, Response::linear(), {.masks = first}).radiance(0, 0).r, 64.0 / 255, 1e-4);
  const Exposures only = texel({{1, 0}, {2.5, 128}});
  EXPECT_NEAR(merge_exposures(only, Response::linear(), {.masks = first}).radiance(0, 0).r, 51.2 / 255, 1e-6);
}

TEST(MergeExposures, RepeatsItsBitsOnAnyThreads) {
  const Exposures bracket = sample::bracket(sample::scene(160, 121), {sample::srgb_camera, 1.0}, sample::five_times());
  zonal::Run one, seven;
  one.threads = 1, seven.threads = 7;
  const Merge a = merge_exposures(bracket, Response::srgb(), {}, one),
              b = merge_exposures(bracket, Response::srgb(), {}, seven);
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.black, b.black);
}

}  // namespace
}  // namespace zonal
