#include "zonal/light/split_level.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/base/parallel.h"

namespace zonal {
namespace {

// A float's exponent and the first five bits of its fraction.
constexpr int kBinShift = 18, kBins = 1 << (31 - kBinShift);

int bin_of(double brightness) {
  return static_cast<int>(std::bit_cast<std::uint32_t>(static_cast<float>(brightness)) >> kBinShift);
}

struct Histogram {
  std::vector<double> solid_angle, energy;
  double maximum = 0;
  std::int64_t not_finite = 0;

  void add(Rgb c, double angle) {
    if (angle <= 0) return;
    if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) {
      ++not_finite;
      return;
    }
    const double light = brightness(c);
    const int bin = bin_of(light);
    solid_angle[bin] += angle;
    energy[bin] += angle * light;
    maximum = std::max(maximum, light);
  }
  void join(const Histogram& part) {
    for (int i = 0; i < kBins; ++i) solid_angle[i] += part.solid_angle[i], energy[i] += part.energy[i];
    maximum = std::max(maximum, part.maximum);
    not_finite += part.not_finite;
  }
};

/// Calls f(x, solid angle) for a row. Rows of a panorama have one solid angle.
template <class F>
void for_each_in_row(const Mapping& mapping, int y, const F& f) {
  const bool even = mapping.projection().layout == Layout::kEquirect;
  const double first = even ? mapping.solid_angle(0, y) : 0;
  for (int x = 0; x < mapping.size().width; ++x) f(x, even ? first : mapping.solid_angle(x, y));
}

Histogram histogram_of(const Environment& e, const Mapping& mapping, const Run& run) {
  const int rows = mapping.size().height;
  constexpr int kParts = 64;
  const std::vector<double> none(kBins);
  return reduce_blocks(
      run, "split: histogram", rows, std::max(1, (rows + kParts - 1) / kParts), Histogram{none, none},
      [&](Block block) {
        Histogram part{none, none};
        for (int y = block.begin; y < block.end; ++y) {
          for_each_in_row(mapping, y, [&](int x, double angle) { part.add(e.radiance(x, y), angle); });
        }
        return part;
      },
      [](Histogram& total, const Histogram& part) { total.join(part); });
}

/// The mean of the bins up to one.
double mean_up_to(const Histogram& histogram, int last) {
  double energy = 0, solid_angle = 0;
  for (int i = 0; i <= last; ++i) energy += histogram.energy[i], solid_angle += histogram.solid_angle[i];
  return solid_angle > 0 ? energy / solid_angle : 0;
}

}  // namespace

BrightLevel bright_level(const Environment& e, const Mapping& mapping, double times, const Run& run) {
  const Histogram histogram = histogram_of(e, mapping, run);
  if (histogram.not_finite > 0) {
    throw Error(ErrorKind::kInput, std::to_string(histogram.not_finite) + " texels are not finite",
                "--fix fills them with the mean of their neighbours");
  }
  BrightLevel level{0, mean_up_to(histogram, kBins - 1), histogram.maximum};
  // Fewer and fewer texels, so it comes to an end.
  for (int last = kBins - 1, next = 0;; last = next) {
    level.threshold = times * mean_up_to(histogram, last);
    next = std::min(last, bin_of(std::min<double>(level.threshold, std::numeric_limits<float>::max())));
    if (next == last) return level;
  }
}

BrightTexels::BrightTexels(const Environment& e, const Mapping& mapping, double threshold, const Run& run) {
  const int rows = mapping.size().height;
  std::vector<std::vector<BrightTexel>> found(static_cast<std::size_t>(rows));
  for_each_block(run, "split: bright texels", rows, 16, [&](Block block) {
    for (int y = block.begin; y < block.end; ++y) {
      for (int x = 0; x < mapping.size().width; ++x) {
        const double light = brightness(e.radiance(x, y));
        if (!(light > threshold)) continue;
        const double solid_angle = mapping.solid_angle(x, y);
        if (solid_angle > 0 && mapping.texel_direction(x, y)) found[y].push_back({{x, y}, light, solid_angle});
      }
    }
  });
  row_begin_.reserve(found.size() + 1);
  for (const auto& row : found) {
    row_begin_.push_back(texels_.size());
    texels_.insert(texels_.end(), row.begin(), row.end());
  }
  row_begin_.push_back(texels_.size());
  check(texels_.size() < std::numeric_limits<int>::max(), "bright texels are counted by int");
}

int BrightTexels::find(Texel t) const {
  const auto begin = texels_.begin() + static_cast<std::ptrdiff_t>(row_begin_[t.y]);
  const auto end = texels_.begin() + static_cast<std::ptrdiff_t>(row_begin_[t.y + 1]);
  const auto at = std::lower_bound(begin, end, t.x, [](const BrightTexel& b, int x) { return b.texel.x < x; });
  return at != end && at->texel.x == t.x ? static_cast<int>(at - texels_.begin()) : -1;
}

}  // namespace zonal
