#include "zonal/image/align_bitmaps.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <vector>

namespace zonal {
namespace {

constexpr int kNoise = 4;  // grey levels around the threshold that say nothing (Ward 2003)
constexpr int kLowestThreshold = 20, kHighestThreshold = 235;
/// Shares of darker texels to cut at, the median first and outward from it: dark and bright pairs have no information
/// at their median, pairs many stops apart only in a narrow range.
constexpr auto kShares = [] {
  constexpr double kStep = 0.02;
  std::array<double, 49> shares = {};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const auto steps = static_cast<double>((i + 1) / 2);
    shares[i] = 0.5 + (i % 2 == 1 ? -steps : steps) * kStep;
  }
  return shares;
}();

int percentile(const GreyHistogram& histogram, double share) {
  std::int64_t total = 0, below = 0;
  for (const std::int64_t n : histogram) total += n;
  for (int value = 0; value < kGreyLevels; ++value) {
    below += histogram[value];
    if (static_cast<double>(below) > share * static_cast<double>(total)) return value;
  }
  return kGreyLevels - 1;
}

struct Thresholds {
  int first, second;
};

/// Where to cut a pair, by what both show; nullopt when every percentile is black or white in one of them.
std::optional<Thresholds> thresholds_of(const Grey& fixed, const Grey& moving, Shift shift) {
  const Part part = shared_part(fixed, moving, shift);
  const GreyHistogram ha = histogram_of(fixed, part), hb = histogram_of(moving, moved(part, shift));
  const auto useful = [](int t) { return t >= kLowestThreshold && t <= kHighestThreshold; };
  for (const double share : kShares) {
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

/// The share of different bits in the part that both show.
double disagreement(const Grey& fixed, const Grey& moving, Shift shift) {
  const auto [left, top, right, bottom] = shared_part(fixed, moving, shift);
  std::int64_t different = 0, compared = 0;
  for (int y = top; y < bottom && left < right; ++y) {
    const std::uint8_t* a = fixed.row(y).data() + left;
    const std::uint8_t* b = moving.row(y + shift.dy).data() + left + shift.dx;
    for (int i = 0; i < right - left; ++i) {
      const int both = ((a[i] | b[i]) & 2) == 0;
      compared += both;
      different += both & (a[i] ^ b[i]);
    }
  }
  return compared == 0 ? 1 : static_cast<double>(different) / static_cast<double>(compared);
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

/// The best shift within `radius` of `start`.
std::optional<Shift> search(const Grey& fixed, const Grey& moving, Shift start, int radius) {
  const std::optional<Thresholds> cut = thresholds_of(fixed, moving, start);
  if (!cut) return std::nullopt;
  const Grey a = bits_of(fixed, cut->first), b = bits_of(moving, cut->second);
  Shift best = start;
  double least = std::numeric_limits<double>::infinity();
  for (const Shift tried : shifts_around(start, radius)) {
    const double share = disagreement(a, b, tried);
    if (share < least) best = tried, least = share;
  }
  return best;
}

}  // namespace

int halvings(int width, int height, int smallest_side) {
  int times = 0;
  while (std::min(width, height) >> times >= 2 * smallest_side) ++times;
  return times;
}

std::optional<Shift> align_bitmaps(const Grey& fixed, const Grey& moving, int largest_shift_px) {
  const int times = halvings(fixed.width(), fixed.height(), kCoarsestSide);
  Grey a = fixed, b = moving;
  for (int i = 0; i < times; ++i) a = halved(a), b = halved(b);
  const int radius = (largest_shift_px + (1 << times) - 1) >> times;
  const std::optional<Shift> found = search(a, b, {}, radius);
  if (!found) return std::nullopt;
  // Once more, cut by what both show at the place just found.
  const std::optional<Shift> again = search(a, b, *found, 1);
  if (!again) return std::nullopt;
  return Shift{again->dx << times, again->dy << times};
}

}  // namespace zonal
