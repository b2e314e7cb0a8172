#include "zonal/image/align_exposures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "zonal/base/check.h"
#include "zonal/base/parallel.h"

namespace zonal {
namespace {

using Grey = Image<std::uint8_t>;

constexpr int kNoise = 4;  // grey levels around the threshold that say nothing (Ward 2003)
constexpr int kLowestThreshold = 20, kHighestThreshold = 235;
constexpr int kSmallestSide = 32;  // of the coarsest picture
/// Percentiles to cut at, the first one preferred: dark and bright pairs have no information at their median.
constexpr std::array<double, 11> kPercentiles = {0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9, 0.05, 0.95, 0.02, 0.98};

/// The green of the photograph as it was taken. Unlike a mean of the channels, which clip one by one, its order of
/// brightness is the same in every exposure.
Grey grey_of(const CodedPicture& picture) {
  Grey grey(picture.width(), picture.height());
  std::vector<Rgb> row(static_cast<std::size_t>(picture.width()));
  for (int y = 0; y < picture.height(); ++y) {
    picture.row(y, row);
    std::transform(row.begin(), row.end(), grey.row(y).begin(),
                   [](const Rgb& p) { return static_cast<std::uint8_t>(255 * std::clamp(p.g, 0.0f, 1.0f) + 0.5f); });
  }
  return grey;
}

Grey halved(const Grey& fine) {
  Grey coarse(fine.width() / 2, fine.height() / 2);
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      const int sum = fine(2 * x, 2 * y) + fine(2 * x + 1, 2 * y) + fine(2 * x, 2 * y + 1) + fine(2 * x + 1, 2 * y + 1);
      coarse(x, y) = static_cast<std::uint8_t>((sum + 2) / 4);
    }
  }
  return coarse;
}

/// The picture and its halves, fine first.
std::vector<Grey> pyramid_of(const Exposure& exposure) {
  std::vector<Grey> pyramid = {grey_of(exposure.picture)};
  while (std::min(pyramid.back().width(), pyramid.back().height()) >= 2 * kSmallestSide)
    pyramid.push_back(halved(pyramid.back()));
  return pyramid;
}

using Histogram = std::array<std::int64_t, 256>;

/// A part of a picture, ends excluded.
struct Part {
  int left, top, right, bottom;
};

Histogram histogram_of(const Grey& grey, Part part) {
  Histogram histogram = {};
  for (int y = part.top; y < part.bottom; ++y) {
    for (int x = part.left; x < part.right; ++x) ++histogram[grey(x, y)];
  }
  return histogram;
}

/// What `fixed` shows of `moving` when (x, y) of one is (x + dx, y + dy) of the other.
Part shared_part(const Grey& fixed, const Grey& moving, Shift shift) {
  return {std::max(0, -shift.dx), std::max(0, -shift.dy), std::min(fixed.width(), moving.width() - shift.dx),
          std::min(fixed.height(), moving.height() - shift.dy)};
}

int percentile(const Histogram& histogram, double share) {
  std::int64_t total = 0, below = 0;
  for (const std::int64_t n : histogram) total += n;
  for (int value = 0; value < 256; ++value) {
    below += histogram[value];
    if (static_cast<double>(below) > share * static_cast<double>(total)) return value;
  }
  return 255;
}

struct Thresholds {
  int first, second;
};

/// Where to cut a pair, by what both show; nullopt when every percentile is black or white in one of them.
std::optional<Thresholds> thresholds_of(const Grey& fixed, const Grey& moving, Shift shift) {
  const Part part = shared_part(fixed, moving, shift);
  const Part moved = {part.left + shift.dx, part.top + shift.dy, part.right + shift.dx, part.bottom + shift.dy};
  const Histogram ha = histogram_of(fixed, part), hb = histogram_of(moving, moved);
  const auto useful = [](int t) { return t >= kLowestThreshold && t <= kHighestThreshold; };
  for (const double share : kPercentiles) {
    const Thresholds t{percentile(ha, share), percentile(hb, share)};
    if (useful(t.first) && useful(t.second)) return t;
  }
  return std::nullopt;
}

/// 0 below the threshold, 1 above, 2 too near to say.
Grey bits_of(const Grey& grey, int threshold) {
  Grey bits(grey.width(), grey.height());
  std::transform(grey.values().begin(), grey.values().end(), bits.values().begin(), [&](std::uint8_t value) {
    const int away = value - threshold;
    return static_cast<std::uint8_t>(std::abs(away) <= kNoise ? 2 : away > 0);
  });
  return bits;
}

struct Match {
  std::int64_t different = 0, compared = 0;
  double share() const { return compared == 0 ? 1 : static_cast<double>(different) / static_cast<double>(compared); }
};

/// Compares the bits of the part that both show.
Match match(const Grey& fixed, const Grey& moving, Shift shift) {
  const auto [left, top, right, bottom] = shared_part(fixed, moving, shift);
  Match total;
  for (int y = top; y < bottom && left < right; ++y) {
    const std::uint8_t* a = fixed.row(y).data() + left;
    const std::uint8_t* b = moving.row(y + shift.dy).data() + left + shift.dx;
    std::int32_t different = 0, compared = 0;
    for (int i = 0; i < right - left; ++i) {
      const int both = ((a[i] | b[i]) & 2) == 0;
      compared += both;
      different += both & (a[i] ^ b[i]);
    }
    total.different += different;
    total.compared += compared;
  }
  return total;
}

/// Shifts up to `radius` around `start`, the nearest first: ties stay where they are.
std::vector<Shift> shifts_around(Shift start, int radius) {
  std::vector<Shift> shifts;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) shifts.push_back({dx, dy});
  }
  std::stable_sort(shifts.begin(), shifts.end(),
                   [](Shift a, Shift b) { return a.dx * a.dx + a.dy * a.dy < b.dx * b.dx + b.dy * b.dy; });
  for (Shift& shift : shifts) shift = {start.dx + shift.dx, start.dy + shift.dy};
  return shifts;
}

/// The best shift within `radius` of `start`; as it is and too_flat when there is nothing to compare.
Alignment search(const Grey& fixed, const Grey& moving, Shift start, int radius) {
  Alignment best{start, std::numeric_limits<double>::infinity()};
  const std::optional<Thresholds> cut = thresholds_of(fixed, moving, start);
  if (!cut) return {start, 0, true};
  const Grey a = bits_of(fixed, cut->first), b = bits_of(moving, cut->second);
  for (const Shift tried : shifts_around(start, radius)) {
    const double share = match(a, b, tried).share();
    if (share < best.disagreement) best = {tried, share};
  }
  return best;
}

/// The shift of `moving` against `fixed`, pyramids of equal sizes.
Alignment align_pair(const std::vector<Grey>& fixed, const std::vector<Grey>& moving, int largest_shift_px) {
  const int side = std::min(fixed[0].width(), fixed[0].height());
  const int largest = std::min(largest_shift_px > 0 ? largest_shift_px : side / 8, side / 2);
  const int coarsest = static_cast<int>(fixed.size()) - 1;
  Alignment found;
  for (int level = coarsest; level >= 0; --level) {
    const Shift start{2 * found.shift.dx, 2 * found.shift.dy};
    const int radius = level == coarsest ? (largest + (1 << level) - 1) >> level : 1;
    found = search(fixed[level], moving[level], start, radius);
    if (found.too_flat) return {{}, 0, true};
    // Once more, cut by what both show at the place just found.
    found = search(fixed[level], moving[level], found.shift, 1);
    if (found.too_flat) return {{}, 0, true};
  }
  return found;
}

}  // namespace

std::vector<Alignment> align_exposures(Exposures& bracket, const AlignOptions& options, const Run& run) {
  check(bracket.size() >= 2, "an alignment takes an arranged bracket");
  check(options.largest_shift_px >= 0, "the largest shift must not be negative");
  const int count = static_cast<int>(bracket.size()), middle = count / 2;
  // One pair at a time is in memory, for each thread.
  std::vector<Alignment> pairs(static_cast<std::size_t>(count));
  for_each_block(run, "aligning", count, 1, [&](Block block) {
    const int k = block.begin;
    if (k == middle) return;
    const int toward = k < middle ? k + 1 : k - 1;
    pairs[k] = align_pair(pyramid_of(bracket[toward]), pyramid_of(bracket[k]), options.largest_shift_px);
  });
  const auto chain = [&](int k, int toward) {
    const Shift onto = pairs[toward].shift;
    pairs[k].shift = {onto.dx + pairs[k].shift.dx, onto.dy + pairs[k].shift.dy};
  };
  for (int k = middle + 1; k < count; ++k) chain(k, k - 1);
  for (int k = middle - 1; k >= 0; --k) chain(k, k + 1);
  for (int k = 0; k < count; ++k) bracket[k].shift = pairs[k].shift;
  return pairs;
}

}  // namespace zonal
