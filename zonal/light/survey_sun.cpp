#include "zonal/light/survey_sun.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace zonal {
namespace {

/// Grows sets of texels over the sphere, across every seam of the picture.
class Region {
 public:
  Region(const Environment& environment, const Mapping& mapping, Texel start)
      : environment_(environment),
        mapping_(mapping),
        member_(environment.radiance.width(), environment.radiance.height(), 0) {
    add(start);
  }

  /// Adds connected texels that qualify; false when their solid angle exceeds the limit.
  bool grow(const std::function<bool(Rgb)>& qualifies, double limit) {
    double solid_angle = 0;
    for (std::size_t next = 0; next < texels_.size(); ++next) {
      solid_angle += mapping_.solid_angle(texels_[next].x, texels_[next].y);
      if (solid_angle > limit) return false;
      for_each_neighbour(texels_[next], [&](Texel t) {
        if (qualifies(environment_.radiance(t.x, t.y))) add(t);
      });
    }
    return true;
  }

  /// Adds all neighbours; returns them.
  std::vector<Texel> add_ring() {
    const std::size_t inside = texels_.size();
    for (std::size_t i = 0; i < inside; ++i) for_each_neighbour(texels_[i], [&](Texel t) { add(t); });
    return {texels_.begin() + static_cast<std::ptrdiff_t>(inside), texels_.end()};
  }

  const std::vector<Texel>& texels() const { return texels_; }

 private:
  void add(Texel t) {
    char& member = member_(t.x, t.y);
    if (!member) texels_.push_back(t);
    member = 1;
  }
  template <class F>
  void for_each_neighbour(Texel t, const F& f) {
    const int chart = mapping_.chart(center_of(t));
    for (int k = 0; k < 9; ++k) {
      if (k != 4) f(mapping_.wrap(chart, t.x + k % 3 - 1, t.y + k / 3 - 1));
    }
  }

  const Environment& environment_;
  const Mapping& mapping_;
  Grid<char> member_;
  std::vector<Texel> texels_;
};

bool is_finite(RgbD c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

}  // namespace

std::optional<SunEstimate> estimate_sun(const Environment& e, const Mapping& mapping, Texel brightest,
                                        double mean_luminance, double total_luminance) {
  // A glint that outshines its surroundings but gives hardly any light is no sun.
  constexpr double kStandsOut = 16, kCompact = 0.03, kPartOfPeak = 0.1, kLeastShare = 0.005;
  const double peak = luminance(RgbD(e.radiance(brightest.x, brightest.y)));
  if (!(peak > kStandsOut * mean_luminance) || !(total_luminance > 0)) return std::nullopt;
  Region region(e, mapping, brightest);
  const auto bright = [&](Rgb c) { return luminance(RgbD(c)) > kPartOfPeak * peak; };
  if (!region.grow(bright, kCompact)) return std::nullopt;
  region.add_ring();
  const std::vector<Texel> members = region.texels();

  RgbD background;
  double weight = 0;
  for (const Texel& t : region.add_ring()) {
    const RgbD radiance(e.radiance(t.x, t.y));
    const double solid_angle = mapping.solid_angle(t.x, t.y);
    if (is_finite(radiance)) background += solid_angle * radiance, weight += solid_angle;
  }
  if (weight > 0) background = (1 / weight) * background;

  Vec3 moment;
  double energy = 0;
  for (const Texel& t : members) {
    const RgbD excess = RgbD(e.radiance(t.x, t.y)) - background;
    const auto toward = mapping.texel_direction(t.x, t.y);
    if (!is_finite(excess) || !toward) continue;
    const double part = mapping.solid_angle(t.x, t.y) * luminance(excess);
    energy += part;
    moment += part * *toward;
  }
  if (!(energy > kLeastShare * total_luminance)) return std::nullopt;

  SunEstimate sun;
  sun.toward_sun = normalize(moment);
  for (const Texel& t : members) {
    const RgbD excess = RgbD(e.radiance(t.x, t.y)) - background;
    const auto toward = mapping.texel_direction(t.x, t.y);
    if (!is_finite(excess) || !toward) continue;
    sun.irradiance += (mapping.solid_angle(t.x, t.y) * dot(*toward, sun.toward_sun)) * excess;
  }
  // The disc of the peak's luminance that holds the energy: ω = 4π sin²(radius / 2).
  const double disc = std::min(4 * kPi, energy / (peak - luminance(background)));
  sun.diameter_deg = degrees(4 * std::asin(std::sqrt(disc / (4 * kPi))));
  sun.energy_share = energy / total_luminance;
  return sun;
}

bool looks_clipped(const Environment& e, const Mapping& mapping, Texel brightest, float max_channel,
                   double mean_luminance) {
  constexpr double kCompact = 0.1, kLikeASun = 1000, kBright = 2;
  constexpr std::size_t kFewest = 4;
  if (!(max_channel > kBright * mean_luminance) || max_channel > kLikeASun * mean_luminance) return false;
  Region region(e, mapping, brightest);
  const auto at_ceiling = [&](Rgb c) { return zonal::max_channel(c) == max_channel; };
  return region.grow(at_ceiling, kCompact) && region.texels().size() >= kFewest;
}

}  // namespace zonal
