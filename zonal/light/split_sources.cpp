#include "zonal/light/split_sources.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

#include "zonal/light/split_sets.h"

namespace zonal {
namespace {

constexpr double kStandsOut = 4;
constexpr int kNone = -1;

/// A source while its texels are collected.
struct Gathered {
  Source source;
  Vec3 moment;  ///< energy times direction

  /// Of a uniform disc of the size, the mean of 1 - cos of the angle from its middle is the size over 4 pi.
  bool is_compact(double size_sr) const {
    return source.energy - length(moment) <= size_sr / (4 * kPi) * source.energy;
  }
};

/// The set of texels that grows from the brightest down. Components are known by their root, which is their brightest
/// texel, and hold peaks: sets of their own, whose root is their brightest texel as well.
class Flood {
 public:
  Flood(const BrightTexels& texels, const Mapping& mapping, const SourceLimits& limits)
      : texels_(texels),
        mapping_(mapping),
        limits_(limits),
        components_(texels.size()),
        peaks_(texels.size()),
        size_sr_(texels.size()),
        next_(texels.size(), kNone),
        last_(texels.size()),
        is_in_(texels.size(), false),
        is_large_(texels.size(), false) {
    std::iota(last_.begin(), last_.end(), 0);
    // A texel that a circle's rim cuts, with its centre outside, has neighbours but is nobody's.
    for (int i = 0; i < static_cast<int>(texels.size()); ++i) {
      if (mapping.direction(center_of(texels[i].texel))) continue;
      for_each_neighbour(mapping, texels[i].texel, [&](Texel t) {
        if (const int n = texels.find(t); n != kNone) cut_neighbours_[n].push_back(i);
      });
    }
  }

  std::vector<Source> run() {
    std::vector<int> order(texels_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return at(a) != at(b) ? at(a) > at(b) : a < b; });
    for (const int i : order) add(i);
    for (const int i : order) {
      if (components_.root(i) == i && !is_large_[i]) finish(i, limits_.threshold);
    }
    std::sort(sources_.begin(), sources_.end(), [](const Source& a, const Source& b) {
      const Texel s = a.texels[0], t = b.texels[0];  // tell equally strong ones apart by their place
      return a.energy != b.energy ? a.energy > b.energy : s.y != t.y ? s.y < t.y : s.x < t.x;
    });
    return std::move(sources_);
  }

 private:
  double at(int i) const { return texels_[i].brightness; }
  bool brighter(int a, int b) const { return at(a) != at(b) ? at(a) > at(b) : a < b; }

  void add(int i) {
    is_in_[i] = true;
    size_sr_[i] = texels_[i].solid_angle;
    const std::vector<int> around = neighbours_in(i);
    if (around.empty()) {
      is_large_[i] = size_sr_[i] > limits_.max_size_sr;
      return;
    }
    join_components(i, around);
    join_peaks(i, around);
  }

  /// The brightest first.
  std::vector<int> neighbours_in(int i) const {
    std::vector<int> around;
    const auto take = [&](int n) {
      if (n != kNone && n != i && is_in_[n]) around.push_back(n);
    };
    for_each_neighbour(mapping_, texels_[i].texel, [&](Texel t) { take(texels_.find(t)); });
    if (const auto cut = cut_neighbours_.find(i); cut != cut_neighbours_.end())
      std::ranges::for_each(cut->second, take);
    std::sort(around.begin(), around.end(), [&](int a, int b) { return brighter(a, b); });
    return around;
  }

  void join_components(int i, const std::vector<int>& around) {
    std::vector<int> roots;
    for (const int n : around) roots.push_back(components_.root(n));
    std::sort(roots.begin(), roots.end(), [&](int a, int b) { return brighter(a, b); });
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    double size = size_sr_[i];
    bool large = false;
    for (const int r : roots) size += size_sr_[r], large = large || is_large_[r];
    large = large || size > limits_.max_size_sr;
    for (const int r : roots) {
      if (large && !is_large_[r]) finish(r, at(i));
    }
    const int root = roots[0];
    roots.push_back(i);
    for (const int r : roots) {
      if (r == root) continue;
      components_.join(root, r);
      next_[last_[root]] = r;
      last_[root] = last_[r];
    }
    size_sr_[root] = size;
    is_large_[root] = large;
  }

  /// The texel belongs to the peak of its brightest neighbour; the other peaks that meet here stay apart if both rise
  /// high over this place.
  void join_peaks(int i, const std::vector<int>& around) {
    peaks_.join(peaks_.root(around[0]), i);
    for (const int n : around) {
      int high = peaks_.root(around[0]), low = peaks_.root(n);
      if (high == low) continue;
      if (brighter(low, high)) std::swap(low, high);
      if (at(low) < kStandsOut * at(i)) peaks_.join(high, low);
    }
  }

  /// The component as it is now, before something of this brightness joins it: a source for each of its peaks.
  void finish(int root, double outside) {
    const bool isolated = outside <= limits_.threshold;
    const double level = isolated ? limits_.threshold : kStandsOut / 2 * outside;
    std::map<int, Gathered> by_peak;  // in the order of texels, which depends on nothing else
    for (int i = root; i != kNone; i = next_[i]) {
      if (!(at(i) > level)) continue;
      Gathered& gathered = by_peak[peaks_.root(i)];
      const double energy = texels_[i].solid_angle * (at(i) - (isolated ? 0 : outside));
      gathered.source.texels.push_back(texels_[i].texel);
      gathered.source.energy += energy;
      gathered.moment += energy * *mapping_.texel_direction(texels_[i].texel.x, texels_[i].texel.y);
    }
    for (auto& [peak, gathered] : by_peak) {
      Source& source = gathered.source;
      const bool stands_out = isolated || at(peak) >= kStandsOut * outside;
      if (!stands_out || source.energy < limits_.min_energy || !gathered.is_compact(limits_.max_size_sr)) continue;
      source.level = level;
      std::iter_swap(source.texels.begin(), std::ranges::find(source.texels, texels_[peak].texel));
      sources_.push_back(std::move(source));
    }
  }

  const BrightTexels& texels_;
  const Mapping& mapping_;
  const SourceLimits limits_;
  DisjointSets components_, peaks_;
  std::vector<double> size_sr_;         // of the component, at its root
  std::vector<int> next_, last_;        // the component's texels as a list: next_ at each, last_ at its root
  std::vector<bool> is_in_, is_large_;  // is_large_ at the root
  std::unordered_map<int, std::vector<int>> cut_neighbours_;
  std::vector<Source> sources_;
};

}  // namespace

std::vector<Source> find_sources(const BrightTexels& texels, const Mapping& mapping, const SourceLimits& limits) {
  return Flood(texels, mapping, limits).run();
}

}  // namespace zonal
