#include "zonal/light/sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "zonal/light/sample_blind_spot.h"
#include "zonal/light/sample_charts.h"
#include "zonal/light/sample_solve.h"
#include "zonal/light/sample_taps.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

/// One channel of a patch: the starting weights' value plus the correction. A correction that is many times the spread
/// of the patch without its four brightest texels comes from a sun in it, which a linear function does not describe: it
/// fades out. Not negative where no texel is.
float limited(const std::array<float, kPatch>& texels, const std::array<double, kPatch>& start,
              const std::array<double, kPatch>& correction) {
  double value = 0, change = 0;
  for (int k = 0; k < kPatch; ++k) {
    value += start[k] * texels[k];
    change += correction[k] * texels[k];
  }
  std::array<float, kPatch> sorted = texels;
  std::sort(sorted.begin(), sorted.end());
  const double spread = sorted[kPatch - 5] - sorted[0];
  if (change != 0) value += change * std::clamp(2 - std::abs(change) / (4 * spread), 0.0, 1.0);
  return static_cast<float>(sorted[0] >= 0 ? std::max(value, 0.0) : value);
}

}  // namespace

struct Sampler::State {
  explicit State(const Environment& e)
      : environment(e),
        mapping(e.projection, {e.radiance.width(), e.radiance.height()}),
        smooth(e.projection, mapping.size()),
        blind_spot(BlindSpot::of(e, mapping)) {}

  Rgb at(Texel t) const { return environment.radiance(t.x, t.y); }

  /// Catmull-Rom along four rows, then down; (x, y) is the texel up and left of the direction, (s, t) the way to the
  /// next.
  template <class Map>
  Rgb cubic(const Map& map, int chart, int x, int y, double s, double t) const {
    const Float4 fs = Float4{} + static_cast<float>(s), ft = Float4{} + static_cast<float>(t);
    Float4 rows[4];
    for (int j = 0; j < 4; ++j) {
      Float4 taps[4];
      for (int i = 0; i < 4; ++i) taps[i] = load(at(map.wrap(chart, x - 1 + i, y - 1 + j)));
      rows[j] = limited_cubic(taps[0], taps[1], taps[2], taps[3], fs);
    }
    return to_rgb(limited_cubic(rows[0], rows[1], rows[2], rows[3], ft));
  }

  template <class Map>
  Rgb solved(const Map& map, Vec3 toward, int chart, int x, int y, double s, double t) const {
    std::array<Vec3, kPatch> directions;
    std::array<double, kPatch> start{}, ease;
    std::array<float, kPatch> r, g, b;
    const std::array<double, 4> near_x = {0, 1 - s, s, 0}, near_y = {0, 1 - t, t, 0};
    const std::array<double, 4> ease_x = {1 - s, 2 - s, 1 + s, s}, ease_y = {1 - t, 2 - t, 1 + t, t};
    for (int k = 0; k < kPatch; ++k) {
      const int i = k % 4, j = k / 4;
      const Texel texel = map.wrap(chart, x - 1 + i, y - 1 + j);
      directions[k] = *map.texel_direction(texel.x, texel.y);
      start[k] = near_x[i] * near_y[j];
      ease[k] = ease_x[i] * ease_y[j];
      const Rgb radiance = at(texel);
      r[k] = radiance.r, g[k] = radiance.g, b[k] = radiance.b;
    }
    const auto correction = linear_correction(toward, directions, start, ease);
    return {limited(r, start, correction), limited(g, start, correction), limited(b, start, correction)};
  }

  template <class Map>
  Rgb sample(const Map& map, Vec3 toward) const {
    const auto p = map.position(toward);
    if (!p) return at(map.nearest(toward));
    const int chart = map.chart(*p);
    const double left = std::floor(p->x - 0.5), top = std::floor(p->y - 0.5);
    const int x = static_cast<int>(left), y = static_cast<int>(top);
    const double s = p->x - 0.5 - left, t = p->y - 0.5 - top;
    if (smooth.hold_around(map, toward, *p)) return cubic(map, chart, x, y, s, t);
    const double blind = blind_spot ? blind_spot->weight(toward) : 0;
    if (blind >= 1) return blind_spot->radiance(toward);
    const Rgb around = solved(map, toward, chart, x, y, s, t);
    return blind > 0 ? Rgb((1 - blind) * RgbD(around) + blind * RgbD(blind_spot->radiance(toward))) : around;
  }

  const Environment& environment;
  Mapping mapping;
  SmoothCharts smooth;
  std::optional<BlindSpot> blind_spot;
};

Sampler::Sampler(const Environment& environment) : state_(std::make_unique<State>(environment)) {}
Sampler::~Sampler() = default;
Sampler::Sampler(Sampler&&) noexcept = default;

Rgb Sampler::operator()(Vec3 toward) const {
  return state_->mapping.visit([&](const auto& map) { return state_->sample(map, toward); });
}

}  // namespace zonal
