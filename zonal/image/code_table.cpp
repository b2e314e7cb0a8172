#include "zonal/image/code_table.h"

#include <algorithm>
#include <cmath>

namespace zonal {
namespace {

/// Codes to either side over which a slope is taken: an estimated curve has noise from code to code.
constexpr int kSlopeReach = 6;

}  // namespace

CodeTable::CodeTable(const Response& response, CodeWeight kind, const TrustedRanges& trusted, int levels)
    : response_(response), kind_(kind), trusted_(trusted), largest_(static_cast<float>(std::max(0, levels - 1))) {
  for (int c = 0; c < 3; ++c) {
    table_[c].reserve(static_cast<std::size_t>(levels));
    for (int i = 0; i < levels; ++i) table_[c].push_back(compute(c, static_cast<float>(i) / largest_));
  }
}

CodeValue CodeTable::compute(int channel, float encoded) const {
  if (std::isnan(encoded)) return {};
  const double exposure = std::max(0.0, response_(channel, encoded));
  // Where the curve stands at 0 there is no light to speak of, and no logarithm.
  const auto weight = static_cast<float>(exposure > 0 ? code_weight(kind_, trusted_[channel], encoded) : 0);
  const bool bright = 255 * static_cast<double>(encoded) >= trusted_[channel].highest;
  return {static_cast<float>(exposure), exposure > 0 ? static_cast<float>(std::log(exposure)) : 0.0f,
          slope_at(channel, encoded), weight,
          weight > 0 ? CodeState::kTrusted
          : bright   ? CodeState::kSaturated
                     : CodeState::kBlack};
}

float CodeTable::slope_at(int channel, float encoded) const {
  const ResponseCurve& curve = response_.exposure[channel];
  const int code = static_cast<int>(255 * std::clamp(encoded, 0.0f, 1.0f) + 0.5f);
  const int below = std::max(0, code - kSlopeReach), above = std::min(kCodes - 1, code + kSlopeReach);
  if (curve[code] <= 0) return 1;
  // A levelled stretch of the curve has no slope, and its codes are no more certain for that.
  constexpr double kLeastSlope = 1e-3;
  return static_cast<float>(std::max(kLeastSlope, (curve[above] - curve[below]) / ((above - below) * curve[code])));
}

CodeTables::CodeTables(const Exposures& bracket, const Response& response, CodeWeight kind,
                       const TrustedRanges& trusted) {
  std::vector<int> levels;
  for (const Exposure& exposure : bracket) {
    const int wanted = exposure.picture.levels();
    const auto found = std::find(levels.begin(), levels.end(), wanted);
    of_.push_back(static_cast<std::size_t>(found - levels.begin()));
    if (found != levels.end()) continue;
    levels.push_back(wanted);
    tables_.emplace_back(response, kind, trusted, wanted);
  }
}

}  // namespace zonal
