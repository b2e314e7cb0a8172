#include "zonal/light/split.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "zonal/base/error.h"
#include "zonal/light/split_balance.h"
#include "zonal/light/split_fill.h"
#include "zonal/light/split_level.h"
#include "zonal/light/split_sources.h"

namespace zonal {
namespace {

void check_options(const SplitOptions& o) {
  const auto refuse = [](const char* what, const char* hint) { throw Error(ErrorKind::kUsage, what, hint); };
  if (o.max_lights < 0) refuse("the number of lights must not be negative", "0 takes none out");
  if (!(o.threshold >= 1) || !std::isfinite(o.threshold))
    refuse("a threshold is a number of times the mean of the rest", "1 or more; 16 is the default");
  if (!(o.min_share >= 0 && o.min_share <= 1)) refuse("a share of the energy is from 0 to 1", "0.005 is the default");
  if (!(o.max_size_sr > 0 && o.max_size_sr <= 4 * kPi))
    refuse("a source's size is over 0 and at most the whole sphere", "0.06 steradians is the default");
}

/// In a coarse picture a sun may cover four texels as well, however large they are.
double size_limit(const Environment& e, const SplitOptions& options) {
  constexpr double kTexels = 4;
  return std::max(options.max_size_sr, kTexels * 4 * kPi / static_cast<double>(e.radiance.size()));
}

/// One source's texels before and after.
class Excess {
 public:
  Excess(std::span<const FilledTexel> texels, Environment& e) : texels_(texels), environment_(e) {}

  /// What a channel would gain stays in the picture.
  void keep_positive() {
    const RgbD energy = energy_in_rgb();
    if (!(energy.r > 0)) restore(&Rgb::r);
    if (!(energy.g > 0)) restore(&Rgb::g);
    if (!(energy.b > 0)) restore(&Rgb::b);
  }
  void restore_all() {
    restore(&Rgb::r);
    restore(&Rgb::g);
    restore(&Rgb::b);
  }

  /// nullopt where nothing is left to be a light.
  std::optional<SplitLight> light() const {
    SplitLight light;
    Vec3 moment;
    double peak = 0, peak_angle = 0;
    for (const FilledTexel& t : texels_) {
      const RgbD excess = excess_of(t);
      const double bright = luminance(excess);
      light.energy += t.solid_angle * excess;
      moment += (t.solid_angle * bright) * t.toward;
      if (bright > peak) peak = bright, peak_angle = t.solid_angle;
    }
    const double energy = luminance(light.energy);
    if (!(energy > 0) || !(length(moment) > 0) || !(peak > 0)) return std::nullopt;
    light.direction = normalize(moment);
    for (const FilledTexel& t : texels_) {
      light.irradiance += (t.solid_angle * dot(t.toward, light.direction)) * excess_of(t);
    }
    // A disc that has radius sqrt(2) texel sides covers the texel around its middle wherever that is.
    const double disc = std::min(4 * kPi, energy / peak);
    light.half_angle = 2 * std::asin(std::sqrt(disc / (4 * kPi)));
    light.resolved = disc >= 2 * kPi * peak_angle;
    return light;
  }

 private:
  RgbD excess_of(const FilledTexel& t) const {
    return RgbD(t.before) - RgbD(environment_.radiance(t.texel.x, t.texel.y));
  }
  RgbD energy_in_rgb() const {
    RgbD energy;
    for (const FilledTexel& t : texels_) energy += t.solid_angle * excess_of(t);
    return energy;
  }
  void restore(float Rgb::*channel) {
    for (const FilledTexel& t : texels_) environment_.radiance(t.texel.x, t.texel.y).*channel = t.before.*channel;
  }

  std::span<const FilledTexel> texels_;
  Environment& environment_;
};

/// Calls f with the texels of each source; they stand in the order of sources.
template <class F>
void for_each_source(std::span<const FilledTexel> texels, const F& f) {
  while (!texels.empty()) {
    const auto end = std::ranges::find_if(texels, [&](const FilledTexel& t) { return t.source != texels[0].source; });
    const auto count = static_cast<std::size_t>(end - texels.begin());
    f(texels.first(count));
    texels = texels.subspan(count);
  }
}

double range_of(const BrightLevel& level) { return level.mean > 0 ? level.maximum / level.mean : 0; }

}  // namespace

SplitEnvironment split_lights(Environment environment, const SplitOptions& options, const Run& run) {
  check_options(options);
  const Mapping mapping(environment.projection, {environment.radiance.width(), environment.radiance.height()});
  const BrightLevel level = bright_level(environment, mapping, options.threshold, run);
  SplitEnvironment split;
  split.threshold_luminance = level.threshold;
  split.range_before = split.range_after = range_of(level);
  split.balance.whole = sphere_sum(environment, mapping, run);
  const double whole = luminance(split.balance.whole.energy);

  std::vector<Source> sources;
  if (whole > 0 && level.maximum > level.threshold) {
    sources = find_sources(BrightTexels(environment, mapping, level.threshold, run), mapping,
                           {level.threshold, size_limit(environment, options), options.min_share * whole});
  }
  split.sources = static_cast<int>(sources.size());
  sources.resize(std::min(sources.size(), static_cast<std::size_t>(options.max_lights)));

  const std::vector<FilledTexel> filled = fill_sources(environment, mapping, sources, run);
  for_each_source(filled, [&](std::span<const FilledTexel> texels) {
    Excess excess(texels, environment);
    excess.keep_positive();
    std::optional<SplitLight> light = excess.light();
    if (!light || luminance(light->energy) < options.min_share * whole) return excess.restore_all();
    light->share = luminance(light->energy) / whole;
    split.changed_texels += static_cast<std::int64_t>(texels.size());
    split.lights.push_back(*light);
  });
  std::ranges::stable_sort(split.lights, std::greater<>(), &SplitLight::share);

  split.balance.lights = sphere_sum(split.lights);
  split.balance.rest = split.balance.whole;
  if (!split.lights.empty()) {
    split.balance.rest = sphere_sum(environment, mapping, run);
    split.range_after = range_of(bright_level(environment, mapping, options.threshold, run));
  }
  split.rest = std::move(environment);
  return split;
}

}  // namespace zonal
