#include "zonal/image/merge_exposures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/base/parallel.h"
#include "zonal/image/code_table.h"

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
  RowAdder(const CodeTable& table, const MergeOptions& options, double seconds)
      : table_(table),
        options_(options),
        seconds_(static_cast<float>(seconds)),
        log_seconds_(static_cast<float>(std::log(seconds))) {}

  void add(Rgb encoded, float mask, std::uint8_t place, TexelSums& texel) const {
    const float total =
        add(0, encoded.r, mask, texel) + add(1, encoded.g, mask, texel) + add(2, encoded.b, mask, texel);
    if (total <= texel.largest_weight) return;
    texel.largest_weight = total;
    texel.source = place;
  }

 private:
  /// Returns the weight with which the code counts in the result.
  float add(int c, float encoded, float mask, TexelSums& texel) const {
    const CodeValue value = table_(c, encoded);
    ChannelSums& sums = texel.channel[c];
    if (value.weight <= 0) {
      note_unusable(c, encoded, value.exposure / seconds_, sums);
      return 0;
    }
    const bool squares = options_.rule == MergeRule::kLeastSquares;
    const float w = mask * value.weight * (squares ? seconds_ * seconds_ : 1);
    sums.top += w * (squares ? value.exposure / seconds_ : value.log_exposure - log_seconds_);
    sums.bottom += w;
    return w;
  }

  /// Exposures come in rising order: the first saturated one is the shortest, the last black one the longest.
  void note_unusable(int c, float encoded, float radiance, ChannelSums& sums) const {
    if (std::isnan(encoded)) return;
    if (255 * static_cast<double>(encoded) >= options_.trusted[c].highest) {
      if (sums.bright++ == 0) sums.least = radiance;
    } else {
      ++sums.dark;
      sums.most = radiance;
    }
  }

  const CodeTable& table_;
  const MergeOptions& options_;
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
    std::vector<Rgb> encoded(static_cast<std::size_t>(width));
    std::vector<TexelSums> sums(encoded.size());
    const int y = block.begin;
    for (std::size_t k = 0; k < bracket.size(); ++k) {
      read_row(bracket[k], y, encoded);
      const RowAdder adder(tables[k], options, bracket[k].seconds);
      for (std::size_t x = 0; x < encoded.size(); ++x) {
        const float mask =
            options.masks.empty() ? 1 : std::max(kLeastMask, options.masks[k](static_cast<int>(x), y) / 255.0f);
        adder.add(encoded[x], mask, static_cast<std::uint8_t>(k), sums[x]);
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
