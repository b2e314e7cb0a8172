#include "zonal/light/split_fill.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>

#include "zonal/base/parallel.h"
#include "zonal/light/split_sets.h"

namespace zonal {
namespace {

/// A source's edge reaches one texel farther where it was smoothed, and a resampler's ringing beside it a few more: it
/// is known by the values below zero, and by the bright ones next to them.
constexpr int kRingingRings = 4;

bool is_negative(Rgb c) { return c.r < 0 || c.g < 0 || c.b < 0; }

struct RimTexel {
  Vec3 toward;
  double solid_angle = 0;
  RgbD radiance;
};

/// Texels that touch each other, to be filled from one rim.
struct Hole {
  std::vector<int> members;  // of Region::texels
  std::vector<RimTexel> rim;
};

/// The texels to be filled.
class Region {
 public:
  Region(const Environment& e, const Mapping& mapping, const std::vector<Source>& sources)
      : environment_(e), mapping_(mapping) {
    for (std::size_t s = 0; s < sources.size(); ++s) {
      for (const Texel& t : sources[s].texels) add(t, static_cast<int>(s));
    }
    grow([](const FilledTexel&, Rgb) { return true; });
    for (int ring = 0; ring < kRingingRings; ++ring) {
      grow([&](const FilledTexel& inside, Rgb c) {
        const double level = sources[static_cast<std::size_t>(inside.source)].level;
        return is_negative(c) || (is_negative(inside.before) && brightness(c) > level);
      });
    }
  }

  std::vector<FilledTexel> texels;

  /// In the order of their first texels.
  std::vector<Hole> holes() const {
    DisjointSets sets(texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) {
      for_each_neighbour(mapping_, texels[i].texel, [&](Texel t) {
        const auto member = index_.find(key(t));
        if (member == index_.end()) return;
        const int a = sets.root(static_cast<int>(i)), b = sets.root(member->second);
        sets.join(std::min(a, b), std::max(a, b));
      });
    }
    std::vector<Hole> holes;
    std::vector<int> hole_of(texels.size());  // at roots, which come before the others
    std::set<std::pair<int, std::int64_t>> on_rim;
    for (int i = 0; i < static_cast<int>(texels.size()); ++i) {
      const int root = sets.root(i);
      if (root == i) {
        hole_of[i] = static_cast<int>(holes.size());
        holes.emplace_back();
      }
      const int h = hole_of[root];
      holes[h].members.push_back(i);
      for_each_neighbour(mapping_, texels[i].texel, [&](Texel t) {
        if (index_.contains(key(t)) || !on_rim.emplace(h, key(t)).second) return;
        if (const auto toward = mapping_.texel_direction(t.x, t.y))
          holes[h].rim.push_back({*toward, mapping_.solid_angle(t.x, t.y), RgbD(environment_.radiance(t.x, t.y))});
      });
    }
    return holes;
  }

 private:
  std::int64_t key(Texel t) const { return std::int64_t{t.y} * mapping_.size().width + t.x; }

  void add(Texel t, int source) {
    const auto toward = mapping_.texel_direction(t.x, t.y);
    if (!toward || !index_.emplace(key(t), static_cast<int>(texels.size())).second) return;
    texels.push_back({t, source, *toward, mapping_.solid_angle(t.x, t.y), environment_.radiance(t.x, t.y)});
  }

  /// Adds neighbours that qualify, seen from a texel inside.
  template <class Qualifies>
  void grow(const Qualifies& qualifies) {
    const std::size_t count = texels.size();
    for (std::size_t i = 0; i < count; ++i) {
      const FilledTexel inside = texels[i];
      for_each_neighbour(mapping_, inside.texel, [&](Texel t) {
        if (qualifies(inside, environment_.radiance(t.x, t.y))) add(t, inside.source);
      });
    }
  }

  const Environment& environment_;
  const Mapping& mapping_;
  std::unordered_map<std::int64_t, int> index_;
};

Rgb fill_at(Vec3 toward, const std::vector<RimTexel>& rim) {
  RgbD sum;
  double total = 0;
  for (const RimTexel& r : rim) {
    const Vec3 apart = r.toward - toward;
    constexpr double kTiny = 1e-30;  // two texels of a circle's rim may stand for the same direction
    const double weight = r.solid_angle / (dot(apart, apart) + kTiny);
    sum += weight * r.radiance;
    total += weight;
  }
  return Rgb((1 / total) * sum);
}

}  // namespace

std::vector<FilledTexel> fill_sources(Environment& e, const Mapping& mapping, const std::vector<Source>& sources,
                                      const Run& run) {
  Region region(e, mapping, sources);
  const std::vector<Hole> holes = region.holes();
  std::vector<bool> can_be_filled(sources.size(), true);
  for (const Hole& hole : holes) {
    if (!hole.rim.empty()) continue;
    for (const int i : hole.members) can_be_filled[region.texels[i].source] = false;
  }
  for (const Hole& hole : holes) {
    for_each_block(run, "split: fill", static_cast<int>(hole.members.size()), 16, [&](Block block) {
      for (int i = block.begin; i < block.end; ++i) {
        const FilledTexel& texel = region.texels[hole.members[i]];
        if (can_be_filled[texel.source]) e.radiance(texel.texel.x, texel.texel.y) = fill_at(texel.toward, hole.rim);
      }
    });
  }
  std::vector<FilledTexel> filled;
  for (const FilledTexel& texel : region.texels) {
    if (can_be_filled[texel.source]) filled.push_back(texel);
  }
  std::stable_sort(filled.begin(), filled.end(),
                   [](const FilledTexel& a, const FilledTexel& b) { return a.source < b.source; });
  return filled;
}

}  // namespace zonal
