#include "zonal/image/response.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/image/color.h"

namespace zonal {
namespace {

Response same_for_all(const ResponseCurve& curve) { return {{curve, curve, curve}}; }

}  // namespace

Response Response::linear() {
  ResponseCurve curve;
  for (int i = 0; i < kCodes; ++i) curve[i] = i / 255.0;
  return same_for_all(curve);
}

Response Response::srgb() {
  ResponseCurve curve;
  for (int i = 0; i < kCodes; ++i) curve[i] = srgb_decode(static_cast<float>(i / 255.0));
  return same_for_all(curve);
}

double Response::operator()(int channel, double encoded) const {
  const ResponseCurve& curve = exposure[channel];
  const double at = encoded * (kCodes - 1);
  const int below = std::clamp(static_cast<int>(std::floor(at)), 0, kCodes - 2);
  return curve[below] + (at - below) * (curve[below + 1] - curve[below]);
}

double middle_exposure() { return srgb_decode(static_cast<float>(kMiddleCode / 255.0)); }

int make_monotone(std::span<double> curve, std::span<const double> weights) {
  check(curve.size() == weights.size(), "every value of a curve needs its weight");
  struct Run {
    double mean, weight;
    std::size_t length;
  };
  std::vector<Run> runs;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    // Codes nobody saw must still count a little, or their mean would be 0 / 0.
    runs.push_back({curve[i], std::max(weights[i], 1e-9), 1});
    while (runs.size() > 1 && runs[runs.size() - 2].mean > runs.back().mean) {
      const Run last = runs.back();
      runs.pop_back();
      Run& joined = runs.back();
      joined.mean = (joined.weight * joined.mean + last.weight * last.mean) / (joined.weight + last.weight);
      joined.weight += last.weight;
      joined.length += last.length;
    }
  }
  int changed = 0;
  std::size_t i = 0;
  for (const Run& run : runs) {
    for (std::size_t k = 0; k < run.length; ++k, ++i) {
      changed += run.length > 1 && curve[i] != run.mean;
      curve[i] = run.mean;
    }
  }
  return changed;
}

double code_weight(CodeWeight kind, TrustedCodes trusted, double encoded) {
  const double code = 255 * encoded;
  if (!(code > trusted.lowest && code < trusted.highest)) return 0;
  const double half = (trusted.highest - trusted.lowest) / 2, from_middle = (code - trusted.lowest) / half - 1;
  if (kind == CodeWeight::kHat) return 1 - std::abs(from_middle);
  const double end = std::exp(-4.0);
  return (std::exp(-4 * from_middle * from_middle) - end) / (1 - end);
}

}  // namespace zonal
