#include "zonal/light/resample_footprint.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace zonal {
namespace {

/// Samples may stand so many source texels apart: a straight-line kernel sampled there still weighs all source texels
/// alike to 2 % (sinc² of 1/1.15), as it does anywhere below.
constexpr double kWidest = 1.15;
/// Up to this ratio of sides the curve between source texels matters more than the mean over many.
constexpr double kCubicUpTo = 1.5;

struct Sides {
  double across = 0, down = 0;
};

/// The sides of a texel as angles, measured over its inner half so that the points stay inside it; nullopt at a rim.
std::optional<Sides> sides_of(const Mapping& mapping, Texel t) {
  return mapping.visit([&](const auto& map) -> std::optional<Sides> {
    const auto corner = map.direction({t.x + 0.25, t.y + 0.25});
    const auto right = map.direction({t.x + 0.75, t.y + 0.25});
    const auto below = map.direction({t.x + 0.25, t.y + 0.75});
    if (!corner || !right || !below) return std::nullopt;
    return Sides{2 * length(*right - *corner), 2 * length(*below - *corner)};
  });
}

Sides sides_or_square(const Mapping& mapping, Texel t) {
  if (const auto sides = sides_of(mapping, t)) return *sides;
  const double side = std::sqrt(mapping.solid_angle(t.x, t.y));
  return {side, side};
}

}  // namespace

Footprint largest(const Footprint& a, const Footprint& b) {
  if (!a.shown || !b.shown) return a.shown ? a : b;
  return {std::max(a.across, b.across), std::max(a.down, b.down), a.cubic && b.cubic, true};
}

Footprint footprint(const Mapping& target, const Mapping& source, const Rotation& source_from_target, Texel t,
                    int supersample) {
  const auto toward = target.texel_direction(t.x, t.y);
  if (!toward) return {};
  const Sides over = sides_or_square(target, t);
  const Sides below = sides_or_square(source, source.nearest(source_from_target * *toward));
  const double longest = std::max(below.across, below.down);
  const double step = std::max(std::sqrt(below.across * below.down), longest / 4);
  const double across = over.across / step, down = over.down / step;
  const auto count = [&](double ratio) {
    return supersample > 0 ? supersample : std::max(1, static_cast<int>(std::ceil(ratio / kWidest)));
  };
  // Around the poles of the equal-area octahedron the chart itself bends too sharply for straight lines.
  const bool bent = source.projection().layout == Layout::kOctahedralEqualArea;
  return {count(across), count(down), bent || std::max(over.across, over.down) <= kCubicUpTo * longest, true};
}

}  // namespace zonal
