#include "zonal/image/merge_exposures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/base/parallel.h"
#include "zonal/image/light_row.h"

namespace zonal {
namespace {

constexpr float kLeastMask = 1e-4f;

/// The sums of one channel of one texel over the exposures.
struct ChannelSums {
  float top = 0, bottom = 0;
  // For texels without a trusted code: what the shortest saturated and the longest black exposure say.
  int bright = 0, dark = 0;
  float least = 0, most = 0;
};

struct TexelSums {
  std::array<ChannelSums, 3> channel;
  float largest_weight = 0;
  std::uint8_t source = kNoData;
};

/// What one exposure adds to a row.
class RowAdder {
 public:
  RowAdder(MergeRule rule, double seconds)
      : rule_(rule), seconds_(static_cast<float>(seconds)), log_seconds_(static_cast<float>(std::log(seconds))) {}

  void add(const LightTexel& light, float mask, std::uint8_t place, TexelSums& texel) const {
    float total = 0;
    for (int c = 0; c < 3; ++c) total += add(light[c], mask, texel.channel[c]);
    if (total <= texel.largest_weight) return;
    texel.largest_weight = total;
    texel.source = place;
  }

 private:
  /// Returns the weight with which the code counts in the result.
  float add(const CodeValue& value, float mask, ChannelSums& sums) const {
    if (value.state != CodeState::kTrusted) {
      note_unusable(value, sums);
      return 0;
    }
    const bool squares = rule_ == MergeRule::kLeastSquares;
    const float deviation = value.exposure * value.slope / seconds_;  // of the radiance, for one code of noise
    const float w = mask * value.weight / (squares ? deviation * deviation : 1);
    sums.top += w * (squares ? value.exposure / seconds_ : value.log_exposure - log_seconds_);
    sums.bottom += w;
    return w;
  }

  /// Exposures come in rising order: the first saturated one is the shortest, the last black one the longest.
  void note_unusable(const CodeValue& value, ChannelSums& sums) const {
    const float radiance = value.exposure / seconds_;
    if (value.state == CodeState::kSaturated && sums.bright++ == 0) sums.least = radiance;
    if (value.state == CodeState::kBlack) ++sums.dark, sums.most = radiance;
  }

  MergeRule rule_;
  float seconds_, log_seconds_;
};

/// How many texels have no trusted code in a channel.
struct Counts {
  std::int64_t saturated = 0, black = 0, conflicting = 0, no_data = 0;
};

float radiance_of(const ChannelSums& sums, MergeRule rule) {
  if (sums.bottom > 0) return rule == MergeRule::kLogMean ? std::exp(sums.top / sums.bottom) : sums.top / sums.bottom;
  return sums.bright > 0 ? sums.least : sums.most;
}

void finish_texel(TexelSums& texel, MergeRule rule, Rgb& radiance, std::uint8_t& source, Counts& counts) {
  radiance = {radiance_of(texel.channel[0], rule), radiance_of(texel.channel[1], rule),
              radiance_of(texel.channel[2], rule)};
  int saturated = 0, black = 0, conflicting = 0, no_data = 0;
  for (const ChannelSums& sums : texel.channel) {
    if (sums.bottom > 0) continue;
    no_data += sums.bright == 0 && sums.dark == 0;
    saturated += sums.bright > 0 && sums.dark == 0;
    black += sums.bright == 0 && sums.dark > 0;
    conflicting += sums.bright > 0 && sums.dark > 0;
  }
  counts.saturated += saturated > 0;
  counts.black += black > 0;
  counts.conflicting += conflicting > 0;
  counts.no_data += no_data > 0;
  source = texel.source;
  if (black == 3) source = kOnlyBlack;
  if (conflicting > 0) source = kInConflict;
  if (saturated > 0) source = kOnlySaturated;
}

}  // namespace

Merge merge_exposures(const Exposures& bracket, const Response& response, const MergeOptions& options, const Run& run) {
  check(bracket.size() >= 2 && bracket.size() <= kMostExposures, "a merge takes an arranged bracket of 2 to 252");
  check(options.masks.empty() || options.masks.size() == bracket.size(), "every exposure needs its mask, or none");
  const int width = bracket[0].picture.width(), height = bracket[0].picture.height();
  const CodeWeight kind = options.rule == MergeRule::kLogMean ? CodeWeight::kHat : CodeWeight::kGaussian;
  const CodeTables tables(bracket, response, kind, options.trusted);

  Merge result{Image<Rgb>(width, height), Image<std::uint8_t>(width, height)};
  const auto work = [&](Block block) {
    Counts counts;
    std::vector<LightTexel> light(static_cast<std::size_t>(width));
    std::vector<TexelSums> sums(light.size());
    const int y = block.begin;
    for (std::size_t k = 0; k < bracket.size(); ++k) {
      read_light(bracket[k], tables[k], y, light);
      const RowAdder adder(options.rule, bracket[k].seconds);
      for (std::size_t x = 0; x < light.size(); ++x) {
        const float mask =
            options.masks.empty() ? 1 : std::max(kLeastMask, options.masks[k](static_cast<int>(x), y) / 255.0f);
        adder.add(light[x], mask, static_cast<std::uint8_t>(k), sums[x]);
      }
    }
    for (int x = 0; x < width; ++x)
      finish_texel(sums[static_cast<std::size_t>(x)], options.rule, result.radiance(x, y), result.source(x, y), counts);
    return counts;
  };
  const Counts counts = reduce_blocks(run, "merging", height, 1, Counts{}, work, [](Counts& all, const Counts& row) {
    all.saturated += row.saturated;
    all.black += row.black;
    all.conflicting += row.conflicting;
    all.no_data += row.no_data;
  });
  result.saturated = counts.saturated, result.black = counts.black;
  result.conflicting = counts.conflicting, result.no_data = counts.no_data;
  return result;
}

}  // namespace zonal
