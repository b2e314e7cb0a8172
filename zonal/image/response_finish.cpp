#include "zonal/image/response_finish.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/base/check.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

/// Fewer texels say nothing about a curve of 256 codes.
constexpr int kFewestTexels = 24;

using Weights = std::array<double, kCodes>;

/// How many texels each code was seen in, with weight.
Weights seen_codes(const CodeSamples& samples, int channel, const Weights& weights) {
  Weights seen = {};
  for (const std::uint8_t code : samples.codes[channel]) seen[code] += weights[code] > 0;
  return seen;
}

/// Weighted mean square of ln(exposure / (radiance seconds)), radiance being the weighted mean of its logarithms.
double rms_log2(const CodeSamples& samples, int channel, const ResponseCurve& curve, const Weights& weights) {
  double sum = 0, weight = 0;
  for (int i = 0; i < samples.pixels(); ++i) {
    const auto codes = samples.of(channel, i);
    double total = 0, mean = 0, squares = 0;
    int used = 0;
    for (std::size_t k = 0; k < codes.size(); ++k) {
      const double w = weights[codes[k]];
      if (w <= 0 || curve[codes[k]] <= 0) continue;
      const double value = std::log2(curve[codes[k]] / samples.seconds[k]);
      total += w;
      mean += w * value;
      squares += w * value * value;
      ++used;
    }
    if (used < 2) continue;
    sum += std::max(0.0, squares - mean * mean / total);
    weight += total;
  }
  return weight > 0 ? std::sqrt(sum / weight) : 0;
}

/// Factor by which a curve reaches the middle exposure at the middle code.
double scale_of(const ResponseCurve& curve) {
  check(curve[kMiddleCode] > 0, "an estimated curve must be positive in its middle");
  return middle_exposure() / curve[kMiddleCode];
}

}  // namespace

void check_samples(const CodeSamples& samples, const TrustedRanges& trusted) {
  constexpr std::array<const char*, 3> kNames = {"red", "green", "blue"};
  for (int c = 0; c < 3; ++c) {
    int useful = 0;
    for (int i = 0; i < samples.pixels(); ++i) {
      const auto codes = samples.of(c, i);
      useful += std::count_if(codes.begin(), codes.end(), [&](std::uint8_t code) {
                  return code > trusted[c].lowest && code < trusted[c].highest;
                }) >= 2;
    }
    if (useful >= kFewestTexels) continue;
    throw Error(ErrorKind::kInput,
                std::string("the response of the ") + kNames[c] + " channel cannot be estimated: only " +
                    std::to_string(useful) + " sampled texels are neither black nor saturated in two exposures",
                "give exposures that overlap more, or say what the curve is: --response srgb");
  }
}

void finish(const CodeSamples& samples, CodeWeight kind, const TrustedRanges& trusted, ResponseFit& fit) {
  fit.pixels = samples.pixels();
  for (int c = 0; c < 3; ++c) {
    Weights weights;
    for (int z = 0; z < kCodes; ++z) weights[z] = code_weight(kind, trusted[c], z / 255.0);
    ResponseCurve& curve = fit.response.exposure[c];
    const Weights seen = seen_codes(samples, c, weights);
    fit.codes_seen[c] = static_cast<int>(std::count_if(seen.begin(), seen.end(), [](double n) { return n > 0; }));
    fit.codes_flattened[c] = make_monotone(curve, seen);
    const double scale = scale_of(curve);
    for (double& exposure : curve) exposure *= scale;
    fit.rms_log2[c] = rms_log2(samples, c, curve, weights);
  }
}

}  // namespace zonal
