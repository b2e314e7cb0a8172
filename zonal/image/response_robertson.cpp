#include "zonal/image/response_robertson.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "zonal/base/parallel.h"
#include "zonal/image/response_finish.h"

namespace zonal {
namespace {

constexpr int kBlock = 4096;  // texels; large enough that the tables of a block do not count

/// For each code, the sum of seconds x radiance where it was seen, and how often.
struct Means {
  ResponseCurve sum = {}, count = {};
};

Means texels_at_codes(const CodeSamples& samples, int channel, const ResponseCurve& curve, const ResponseCurve& weights,
                      Block block) {
  Means means;
  for (int i = block.begin; i < block.end; ++i) {
    const auto codes = samples.of(channel, i);
    double top = 0, bottom = 0;
    for (std::size_t k = 0; k < codes.size(); ++k) {
      const double t = samples.seconds[k], w = weights[codes[k]];
      top += w * t * curve[codes[k]];
      bottom += w * t * t;
    }
    if (bottom <= 0) continue;
    for (std::size_t k = 0; k < codes.size(); ++k) {
      means.sum[codes[k]] += samples.seconds[k] * top / bottom;
      means.count[codes[k]] += 1;
    }
  }
  return means;
}

/// The means where the code was trusted and seen; straight lines between them, and on beyond them.
ResponseCurve joined(const Means& means, const ResponseCurve& weights) {
  ResponseCurve curve = {};
  std::optional<int> last, before;
  for (int z = 0; z < kCodes; ++z) {
    if (weights[z] <= 0 || means.count[z] == 0) continue;
    curve[z] = means.sum[z] / means.count[z];
    if (last) {
      for (int i = *last + 1; i < z; ++i) {
        curve[i] = curve[*last] + (curve[z] - curve[*last]) * (i - *last) / (z - *last);
      }
    } else {
      // Below the first one: down to nothing at code 0, where no light is.
      for (int i = 0; i < z; ++i) curve[i] = curve[z] * i / z;
    }
    before = last;
    last = z;
  }
  if (!last || !before) return curve;
  const double slope = (curve[*last] - curve[*before]) / (*last - *before);
  for (int i = *last + 1; i < kCodes; ++i) curve[i] = curve[*last] + std::max(0.0, slope) * (i - *last);
  return curve;
}

ResponseCurve gaussian_weights(TrustedCodes trusted) {
  ResponseCurve weights;
  for (int z = 0; z < kCodes; ++z) weights[z] = code_weight(CodeWeight::kGaussian, trusted, z / 255.0);
  return weights;
}

}  // namespace

bool even_steps(std::span<const double> seconds) {
  for (std::size_t k = 2; k < seconds.size(); ++k) {
    const double first = std::log(seconds[1] / seconds[0]), here = std::log(seconds[k] / seconds[k - 1]);
    if (std::abs(here - first) > 0.02 * std::abs(first)) return false;
  }
  return true;
}

ResponseFit estimate_response_robertson(const CodeSamples& samples, const RobertsonOptions& options, const Run& run) {
  check_samples(samples, options.trusted);
  ResponseFit fit;
  for (int c = 0; c < 3; ++c) {
    const ResponseCurve weights = gaussian_weights(options.trusted[c]);
    ResponseCurve curve;
    for (int z = 0; z < kCodes; ++z) curve[z] = static_cast<double>(z) / kMiddleCode;
    double moved = 1;
    int iteration = 0;
    for (; iteration < options.most_iterations && moved > options.tolerance; ++iteration) {
      const Means means = reduce_blocks(
          run, "", samples.pixels(), kBlock, Means{},
          [&](Block block) { return texels_at_codes(samples, c, curve, weights, block); },
          [](Means& all, const Means& part) {
            for (int z = 0; z < kCodes; ++z) {
              all.sum[z] += part.sum[z];
              all.count[z] += part.count[z];
            }
          });
      ResponseCurve next = joined(means, weights);
      const double middle = next[kMiddleCode];
      moved = 0;
      for (int z = 0; z < kCodes; ++z) {
        next[z] /= middle;
        moved = std::max(moved, std::abs(next[z] - curve[z]));
      }
      curve = next;
    }
    fit.response.exposure[c] = curve;
    fit.iterations = std::max(fit.iterations, iteration);
    fit.converged = fit.converged && moved <= options.tolerance;
  }
  finish(samples, CodeWeight::kGaussian, options.trusted, fit);
  return fit;
}

}  // namespace zonal
