#include "zonal/light/resample_energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "zonal/base/parallel.h"

namespace zonal {
namespace {

/// A texel counts as bright when it is this many times the map's mean and holds this share of its energy. Below that
/// its few percent do not matter.
constexpr double kTimesMean = 32, kShare = 1e-5;
/// At most so many, the brightest.
constexpr std::size_t kMost = 1024;

struct Bright {
  Texel texel;
  double solid_angle = 0, energy = 0;
};

struct Reading {
  double sum = 0;
  std::vector<std::pair<int, float>> row_maxima;
};

std::vector<Bright> bright_texels(const Environment& source, const Mapping& mapping, const Run& run) {
  const int width = source.radiance.width(), height = source.radiance.height();
  const ResampleKernels& kernels = resample_kernels(run.isa);
  const Reading read = reduce_blocks(
      run, "", height, 64, Reading{},
      [&](Block block) {
        Reading part;
        for (int y = block.begin; y < block.end; ++y) {
          float sum = 0, max = 0;
          kernels.sum_and_max(&source.radiance(0, y).r, 3 * width, &sum, &max);
          part.sum += sum;
          part.row_maxima.emplace_back(y, max);
        }
        return part;
      },
      [](Reading& total, const Reading& part) {
        total.sum += part.sum;
        total.row_maxima.insert(total.row_maxima.end(), part.row_maxima.begin(), part.row_maxima.end());
      });

  const double mean = read.sum / (3.0 * width * height);
  std::vector<Bright> found;
  if (!(mean > 0)) return found;
  for (const auto& [y, max] : read.row_maxima) {
    if (!(max > kTimesMean * mean)) continue;
    for (int x = 0; x < width; ++x) {
      const RgbD radiance(source.radiance(x, y));
      const double level = luminance(radiance);
      if (!(level > kTimesMean * mean) || !std::isfinite(level)) continue;
      const double solid_angle = mapping.solid_angle(x, y);  // 0 where the picture shows nothing
      if (level * solid_angle > kShare * 4 * kPi * mean) found.push_back({{x, y}, solid_angle, level * solid_angle});
    }
  }
  std::sort(found.begin(), found.end(), [](const Bright& a, const Bright& b) {
    return std::tuple(-a.energy, a.texel.y, a.texel.x) < std::tuple(-b.energy, b.texel.y, b.texel.x);
  });
  if (found.size() > kMost) {
    // A large even light is left to itself as a whole: the errors of its texels cancel only while all of them are
    // there.
    const double large = 2 * found[kMost].energy;
    found.erase(std::find_if(found.begin(), found.end(), [&](const Bright& b) { return b.energy <= large; }),
                found.end());
  }
  return found;
}

/// The four texels of the straight-line interpolation at a direction.
struct Tap {
  Texel texel;
  double weight = 0;
};
std::array<Tap, 4> taps_at(const Mapping& source, Vec3 toward) {
  return source.visit([&](const auto& map) {
    std::array<Tap, 4> taps;
    const auto p = map.position(toward);
    if (!p) return taps;
    const int chart = map.chart(*p);
    const double left = std::floor(p->x - 0.5), top = std::floor(p->y - 0.5);
    const double s = p->x - 0.5 - left, t = p->y - 0.5 - top;
    for (int k = 0; k < 4; ++k) {
      const int i = k % 2, j = k / 2;
      taps[k] = {map.wrap(chart, static_cast<int>(left) + i, static_cast<int>(top) + j),
                 (i ? s : 1 - s) * (j ? t : 1 - t)};
    }
    return taps;
  });
}

/// Target texels that lie on the way from a source texel to its neighbours: near enough to all that may hold a part of
/// it, also where a seam of either picture tears them apart. The first holds the source texel's centre.
std::vector<Texel> seeds_of(const TileResampler& tiles, Texel source_texel) {
  constexpr int kSteps = 8;
  const Mapping &from = tiles.source_mapping(), &target = tiles.target_mapping();
  const Rotation target_from_source = transpose(tiles.source_from_target());
  const Vec3 toward = *from.texel_direction(source_texel.x, source_texel.y);
  const int chart = from.chart(center_of(source_texel));
  std::vector<Texel> seeds = {target.nearest(target_from_source * toward)};
  for (int k = 0; k < 9; ++k) {
    const Texel n = from.wrap(chart, source_texel.x + k % 3 - 1, source_texel.y + k / 3 - 1);
    const Vec3 step = *from.texel_direction(n.x, n.y) - toward;
    for (int i = 1; i <= kSteps; ++i) {
      seeds.push_back(
          target.nearest(target_from_source * normalize(toward + (static_cast<double>(i) / kSteps) * step)));
    }
  }
  return seeds;
}

/// A target texel and the parts of it that bright texels have.
struct Holder {
  Texel texel;
  std::map<std::size_t, double> shares;  // by index into the bright texels
  int reach = 0;                         // how many rings around it are still to be looked at
};

/// Finds the target texels that hold a part of any bright texel, and two rings around them: where a rim or a seam tears
/// the target apart, a texel that holds a little may lie behind one that holds nothing.
class HolderSearch {
 public:
  HolderSearch(const TileResampler& tiles, const std::vector<Bright>& bright) : tiles_(tiles) {
    for (std::size_t i = 0; i < bright.size(); ++i) index_[{bright[i].texel.x, bright[i].texel.y}] = i;
    for (const Bright& b : bright) {
      for (const Texel& seed : seeds_of(tiles, b.texel)) visit(seed, 1);
    }
    for (std::size_t next = 0; next < holders_.size(); ++next) {
      if (holders_[next].reach > 0) visit_around(holders_[next].texel, holders_[next].reach - 1);
    }
  }

  const std::vector<Holder>& holders() const { return holders_; }

 private:
  void visit(Texel t, int reach) {
    if (!known_.emplace(t.x, t.y).second) return;
    constexpr int kRings = 2;
    Holder holder{t, {}, 0};
    const std::vector<Vec3> samples = tiles_.samples_of(t);
    for (const Vec3& toward : samples) {
      for (const Tap& tap : taps_at(tiles_.source_mapping(), toward)) {
        const auto found = index_.find({tap.texel.x, tap.texel.y});
        if (found == index_.end() || tap.weight <= 0) continue;
        holder.shares[found->second] += tap.weight / static_cast<double>(samples.size());
      }
    }
    holder.reach = holder.shares.empty() ? reach : kRings;
    holders_.push_back(std::move(holder));
  }

  void visit_around(Texel t, int reach) {
    const Mapping& target = tiles_.target_mapping();
    const int chart = target.chart(center_of(t));
    for (int k = 0; k < 9; ++k) {
      const Texel n = {t.x + k % 3 - 1, t.y + k / 3 - 1};
      visit(target.wrap(chart, n.x, n.y), reach);
      // wrap() never names texels whose centre a rim has left outside; they hold light too.
      const bool inside = n.x >= 0 && n.y >= 0 && n.x < target.size().width && n.y < target.size().height;
      if (inside && target.texel_direction(n.x, n.y)) visit(n, reach);
    }
  }

  const TileResampler& tiles_;
  std::map<std::pair<int, int>, std::size_t> index_;
  std::set<std::pair<int, int>> known_;
  std::vector<Holder> holders_;
};

void add(Rgb& radiance, double factor, Rgb light) {
  const auto one = [&](float& value, float more) {
    const float sum = static_cast<float>(value + factor * more);
    value = value >= 0 && more >= 0 ? std::max(sum, 0.0f) : sum;
  };
  one(radiance.r, light.r), one(radiance.g, light.g), one(radiance.b, light.b);
}

}  // namespace

void keep_bright_texels(const Environment& source, const TileResampler& tiles, const Run& run, Environment& result) {
  const Mapping& target = tiles.target_mapping();
  const std::vector<Bright> bright = bright_texels(source, tiles.source_mapping(), run);
  const HolderSearch search(tiles, bright);
  const auto light_of = [&](std::size_t i) { return source.radiance(bright[i].texel.x, bright[i].texel.y); };

  std::vector<double> held(bright.size(), 0.0);
  for (const Holder& h : search.holders()) {
    for (const auto& [i, share] : h.shares) held[i] += share * target.solid_angle(h.texel.x, h.texel.y);
  }
  for (const Holder& h : search.holders()) {
    Rgb& radiance = result.radiance(h.texel.x, h.texel.y);
    for (const auto& [i, share] : h.shares) {
      if (held[i] > 0) add(radiance, (bright[i].solid_angle / held[i] - 1) * share, light_of(i));
    }
  }
  for (std::size_t i = 0; i < bright.size(); ++i) {
    if (held[i] > 0) continue;  // else no sample met it
    const Texel t = seeds_of(tiles, bright[i].texel).front();
    add(result.radiance(t.x, t.y), bright[i].solid_angle / target.solid_angle(t.x, t.y), light_of(i));
  }
}

}  // namespace zonal
