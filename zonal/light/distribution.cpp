#include "zonal/light/distribution.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/light/distribution_kernel.h"

namespace zonal {
namespace {

constexpr int kGroup = kGroupTexels;
constexpr int kRowsPerBlock = 32;
// Bins by the leading bits of the float: its exponent and three of its mantissa, so an eighth of an octave each.
constexpr int kShift = 23 - 3;
constexpr int kBins = 256 << 3;
// How many times brighter than the mean a peak is.
constexpr double kOutshines = 10;

float brightness(Rgb c) { return std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)}); }

struct Tally {
  double energy = 0;
  float maximum = 0;
  bool any_negative = false;
};

/// Sums one block of rows and leaves the brightest of each group in `groups`.
Tally tally_rows(const Grid<Rgb>& map, const std::vector<double>& weights, TallyRow tally_row, Grid<float>& groups,
                 Block rows) {
  Tally tally;
  for (int y = rows.begin; y < rows.end; ++y) {
    const std::span<float> row_groups = groups.row(y);
    const RowTally row = tally_row(&map.row(y).data()->r, 3 * map.width(), row_groups.data());
    tally.energy += weights[y] * row.sum / 3;
    tally.maximum = std::max(tally.maximum, *std::max_element(row_groups.begin(), row_groups.end()));
    tally.any_negative |= row.lowest < 0;
  }
  return tally;
}

std::vector<Distribution::Peak> find_peaks(const Grid<Rgb>& map, const std::vector<double>& weights,
                                           const Grid<float>& groups, double least_energy, double least_value,
                                           int most) {
  std::vector<Distribution::Peak> peaks;
  for (int y = 0; y < map.height(); ++y) {
    const double threshold = std::max(least_energy / weights[y], least_value);
    for (int group = 0; group < groups.width(); ++group) {
      if (groups(group, y) <= threshold) continue;
      const int end = std::min(map.width(), (group + 1) * kGroup);
      for (int x = group * kGroup; x < end; ++x) {
        const double value = brightness(map(x, y));
        if (value > threshold) peaks.push_back({{x, y}, value * weights[y]});
      }
    }
  }
  std::stable_sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.energy > b.energy; });
  if (static_cast<int>(peaks.size()) > most) peaks.resize(most);
  return peaks;
}

/// Looks at the groups with peaks in them again, without these.
void leave_out(const Grid<Rgb>& map, const std::vector<Distribution::Peak>& peaks, Grid<float>& groups) {
  const auto is_peak = [&](int x, int y) {
    return std::any_of(peaks.begin(), peaks.end(), [&](const auto& peak) { return peak.texel == GridTexel{x, y}; });
  };
  for (const auto& peak : peaks) {
    const int group = peak.texel.x / kGroup, y = peak.texel.y;
    float brightest = 0;
    for (int x = group * kGroup; x < std::min(map.width(), (group + 1) * kGroup); ++x) {
      if (!is_peak(x, y)) brightest = std::max(brightest, brightness(map(x, y)));
    }
    groups(group, y) = brightest;
  }
}

std::vector<Distribution::Bin> bin_groups(const Grid<float>& groups, int width, const std::vector<double>& weights) {
  std::vector<double> solid_angles(kBins);
  for (int y = 0; y < groups.height(); ++y) {
    for (int group = 0; group < groups.width(); ++group) {
      const int texels = std::min(kGroup, width - group * kGroup);
      solid_angles[std::bit_cast<std::uint32_t>(groups(group, y)) >> kShift] += weights[y] * texels;
    }
  }
  std::vector<Distribution::Bin> bins;
  for (int i = kBins - 1; i >= 0; --i) {
    const auto upper = std::bit_cast<float>(static_cast<std::uint32_t>(i + 1) << kShift);
    if (solid_angles[i] > 0) bins.push_back({upper, solid_angles[i]});
  }
  return bins;
}

}  // namespace

Distribution::Distribution(const Grid<Rgb>& map, const std::vector<double>& weights, double peak_share, int most_peaks,
                           const Run& run) {
  Grid<float> groups((map.width() + kGroup - 1) / kGroup, map.height());
  const Tally total = reduce_blocks(
      run, {}, map.height(), kRowsPerBlock, Tally{},
      [&](Block rows) { return tally_rows(map, weights, tally_row(run.isa), groups, rows); },
      [](Tally& sum, const Tally& part) {
        sum.energy += part.energy;
        sum.maximum = std::max(sum.maximum, part.maximum);
        sum.any_negative |= part.any_negative;
      });
  if (!std::isfinite(total.energy)) {
    throw Error(ErrorKind::kInput, "the map has values that are not finite (NaN or infinity)",
                "repair it first: --fix replaces them by their neighbours and says how many there were");
  }
  energy_ = total.energy;
  maximum_ = total.maximum;
  any_negative_ = total.any_negative;
  peaks_ = find_peaks(map, weights, groups, peak_share * energy_, kOutshines * energy_ / (4 * kPi), most_peaks);
  leave_out(map, peaks_, groups);
  rest_ = bin_groups(groups, map.width(), weights);
}

double rearrangement_bound(const std::vector<Distribution::Bin>& bins, std::vector<double> errors,
                           const std::vector<double>& solid_angles) {
  std::vector<std::size_t> order(errors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return errors[a] > errors[b]; });
  double bound = 0, left = 0;
  auto bin = bins.begin();
  for (const std::size_t i : order) {
    double open = solid_angles[i];
    while (open > 0 && bin != bins.end()) {
      if (left == 0) left = bin->solid_angle;
      const double part = std::min(open, left);
      bound += part * errors[i] * bin->upper;
      open -= part;
      left -= part;
      if (left <= 0) {
        left = 0;
        ++bin;
      }
    }
  }
  return bound;
}

}  // namespace zonal
