#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "zonal/base/error.h"
#include "zonal/image/dark_floor.h"
#include "zonal/image/response_debevec.h"
#include "zonal/image/response_robertson.h"
#include "zonal/image/synthetic_bracket_test.h"

namespace zonal {
namespace {

using Encode = double (*)(double);

/// The exposure that a camera gives a code for, by bisection.
double exposure_for(Encode encode, double encoded) {
  double lo = 1e-9, hi = 1e6;
  for (int i = 0; i < 200; ++i) {
    const double middle = std::sqrt(lo * hi);
    (encode(middle) < encoded ? lo : hi) = middle;
  }
  return std::sqrt(lo * hi);
}

struct Deviation {
  double rms = 0, worst = 0;  ///< in stops
  int codes = 0;
};

/// How far an estimated curve is from the camera's, over the codes 16..239 of all channels, both through the same point
/// at the middle code.
Deviation deviation(const Response& response, Encode encode) {
  Deviation d;
  const double scale = middle_exposure() / exposure_for(encode, kMiddleCode / 255.0);
  for (int c = 0; c < 3; ++c) {
    for (int z = 16; z < 240; ++z, ++d.codes) {
      const double stops = std::log2(response.exposure[c][z] / (scale * exposure_for(encode, z / 255.0)));
      d.rms += stops * stops;
      d.worst = std::max(d.worst, std::abs(stops));
    }
  }
  d.rms = std::sqrt(d.rms / d.codes);
  return d;
}

struct Case {
  const char* name;
  Encode encode;
};
constexpr Case kCameras[] = {
    {"sRGB", sample::srgb_camera}, {"gamma", sample::gamma_camera}, {"film", sample::film_camera}};

Exposures noisy_bracket(Encode encode, const std::vector<double>& seconds) {
  return sample::bracket(sample::scene(240, 160), {encode, 1.0}, seconds);
}

TEST(SlowEstimateResponse, DebevecFindsKnownCurves) {
  int cameras = 0;
  for (const auto& [name, encode] : kCameras) {
    const ResponseFit fit =
        estimate_response_debevec(sample_flat_texels(noisy_bracket(encode, sample::nine_times()), 2000));
    const Deviation d = deviation(fit.response, encode);
    EXPECT_EQ(d.codes, 672);
    // One code of noise is 0.1 stops in a code of 20; thousands of texels average it to a fifth of that at worst.
    EXPECT_LT(d.rms, 0.025) << name;
    EXPECT_LT(d.worst, 0.1) << name;
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(fit.codes_seen[c], 240) << name;
      EXPECT_LT(fit.rms_log2[c], 0.25) << name;  // the noise itself: most where the curve is flat
    }
    ++cameras;
  }
  EXPECT_EQ(cameras, 3);
}

TEST(SlowEstimateResponse, RobertsonFindsKnownCurves) {
  int cameras = 0;
  for (const auto& [name, encode] : std::span(kCameras).first(2)) {  // not film: it has a shoulder
    const ResponseFit fit =
        estimate_response_robertson(sample_all_texels(noisy_bracket(encode, sample::uneven_times()), 0));
    EXPECT_TRUE(fit.converged) << name;
    EXPECT_GT(fit.iterations, 1) << name;
    const Deviation d = deviation(fit.response, encode);
    // Nothing smooths the noise of single codes.
    EXPECT_LT(d.rms, 0.03) << name;
    EXPECT_LT(d.worst, 0.15) << name;
    ++cameras;
  }
  EXPECT_EQ(cameras, 2);
}

TEST(EvenSteps, AreThoseOfOneRatio) {
  EXPECT_TRUE(even_steps(sample::nine_times()));
  EXPECT_TRUE(even_steps(std::vector<double>{0.01, 1}));
  EXPECT_TRUE(even_steps(std::vector<double>{1.0 / 1000, 1.0 / 250, 1.0 / 62.5}));
  EXPECT_FALSE(even_steps(sample::uneven_times()));
  EXPECT_FALSE(even_steps(std::vector<double>{1, 2, 5}));
}

TEST(SlowEstimateResponse, CurvesNeverFallAndPassTheMiddle) {
  const Exposures bracket = sample::bracket(sample::scene(96, 64), {sample::film_camera, 4.0}, sample::five_times());
  const CodeSamples samples = sample_all_texels(bracket, 0);
  int compared = 0;
  for (const ResponseFit& fit :
       {estimate_response_debevec(samples, {.smoothness = 1}), estimate_response_robertson(samples)}) {
    for (const ResponseCurve& curve : fit.response.exposure) {
      EXPECT_NEAR(curve[kMiddleCode], middle_exposure(), 1e-12);
      for (int z = 1; z < kCodes; ++z, ++compared) EXPECT_GE(curve[z], curve[z - 1]) << z;
    }
  }
  EXPECT_EQ(compared, 2 * 3 * 255);
}

TEST(SlowEstimateResponse, RobertsonRepeatsItsBitsOnAnyThreads) {
  const CodeSamples samples =
      sample_all_texels(sample::bracket(sample::scene(128, 96), {sample::srgb_camera, 1.0}, sample::uneven_times()), 0);
  zonal::Run one, seven;
  one.threads = 1, seven.threads = 7;
  EXPECT_EQ(estimate_response_robertson(samples, {}, one).response.exposure,
            estimate_response_robertson(samples, {}, seven).response.exposure);
}

TEST(SlowEstimateResponse, RefusesWhatDoesNotOverlap) {
  // 14 stops apart: what is grey in one is black or white in the other.
  const Exposures bracket =
      sample::bracket(sample::scene(96, 64), {sample::srgb_camera}, {std::exp2(-14), std::exp2(14)});
  const CodeSamples samples = sample_all_texels(bracket, 0);
  int refused = 0;
  for (const bool debevec : {true, false}) {
    try {
      debevec ? estimate_response_debevec(samples) : estimate_response_robertson(samples);
      ADD_FAILURE() << "estimated from nothing";
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::kInput);
      EXPECT_NE(e.hint().find("--response"), std::string::npos);
      ++refused;
    }
  }
  EXPECT_EQ(refused, 2);
}

TEST(SampleFlatTexels, AvoidsEdgesAndWhatMoved) {
  const Image<Rgb> scene = sample::scene(160, 120);
  Exposures bracket = sample::bracket(scene, {sample::srgb_camera}, sample::five_times());
  const CodeSamples samples = sample_flat_texels(bracket, 200);
  EXPECT_GE(samples.pixels(), 200);
  EXPECT_LE(samples.pixels(), 264);  // the last round over the 64 steps of brightness is finished
  int pairs = 0;
  for (int i = 0; i < samples.pixels(); ++i) {
    const auto codes = samples.of(1, i);
    for (std::size_t k = 1; k < codes.size(); ++k, ++pairs) EXPECT_GE(codes[k] + 8, codes[k - 1]);
  }
  EXPECT_EQ(pairs, 4 * samples.pixels());
}

TEST(SampleAllTexels, LeavesOutWhatHasNoData) {
  Exposures bracket = sample::bracket(sample::scene(20, 10), {sample::srgb_camera}, sample::five_times());
  EXPECT_EQ(sample_all_texels(bracket, 0).pixels(), 200);
  bracket[2].placement = {3, -2};
  EXPECT_EQ(sample_all_texels(bracket, 0).pixels(), 17 * 8);
  EXPECT_EQ(sample_all_texels(bracket, 60).pixels(), 9 * 4);  // every 2nd texel of every 2nd row
}

TEST(DarkFloor, FindsCodesThatDoNotAnswer) {
  // A veil of 12 codes with a code of noise, as of film and scanner.
  const auto veiled = [](double exposure) {
    return 12.0 / 255 + 243.0 / 255 * std::min(1.0, sample::gamma_camera(exposure));
  };
  const Exposures bracket = sample::bracket(sample::scene(240, 160), {veiled, 1.0}, sample::nine_times());
  const TrustedRanges trusted = find_trusted_codes(sample_flat_texels(bracket, 2000));
  for (const TrustedCodes& range : trusted) {
    EXPECT_GE(range.lowest, 12);
    EXPECT_LE(range.lowest, 24);
    EXPECT_EQ(range.highest, 255);
  }
}

TEST(DarkFloor, CleanCamerasAreTrustedDownToNoise) {
  int cameras = 0;
  for (const auto& [name, encode] : kCameras) {
    for (const TrustedCodes& range :
         find_trusted_codes(sample_flat_texels(noisy_bracket(encode, sample::nine_times()), 2000)))
      EXPECT_LE(range.lowest, 6) << name;
    ++cameras;
  }
  EXPECT_EQ(cameras, 3);
}

}  // namespace
}  // namespace zonal
