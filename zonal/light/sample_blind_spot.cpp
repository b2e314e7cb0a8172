#include "zonal/light/sample_blind_spot.h"

#include <algorithm>
#include <vector>

namespace zonal {
namespace {

struct RingTexel {
  Vec3 toward;
  Rgb radiance;
};

std::vector<RingTexel> outermost(const Environment& e, const Mapping& mapping) {
  std::vector<RingTexel> ring;
  const auto shown = [&](int x, int y) { return mapping.direction(center_of({x, y})); };
  for (int y = 0; y < e.radiance.height(); ++y) {
    for (int x = 0; x < e.radiance.width(); ++x) {
      const auto toward = shown(x, y);
      if (!toward || (shown(x - 1, y) && shown(x + 1, y) && shown(x, y - 1) && shown(x, y + 1))) continue;
      ring.push_back({*toward, e.radiance(x, y)});
    }
  }
  return ring;
}

}  // namespace

std::optional<BlindSpot> BlindSpot::of(const Environment& e, const Mapping& mapping) {
  if (e.projection.layout != Layout::kMirrorBall && e.projection.layout != Layout::kSphereMap) return std::nullopt;
  if (!mapping.covers_sphere())
    return std::nullopt;  // the picture's edge cuts the ball: its outermost texels are no ring
  const std::vector<RingTexel> ring = outermost(e, mapping);
  if (ring.empty()) return std::nullopt;

  BlindSpot spot;
  spot.axis_ = -kBackwardMirrored.center;
  spot.side_ = normalize(cross(spot.axis_, {0, 0, 1}));
  spot.up_ = cross(spot.side_, spot.axis_);
  spot.low_ = spot.high_ = ring.front().radiance;
  for (const RingTexel& t : ring) {
    spot.radius_ = std::max(spot.radius_, length(t.toward - spot.axis_));
    spot.low_ = {std::min(spot.low_.r, t.radiance.r), std::min(spot.low_.g, t.radiance.g),
                 std::min(spot.low_.b, t.radiance.b)};
    spot.high_ = {std::max(spot.high_.r, t.radiance.r), std::max(spot.high_.g, t.radiance.g),
                  std::max(spot.high_.b, t.radiance.b)};
  }

  std::array<LinearColumn, kLinear> normal{};
  std::array<LinearColumn, 3> right{};
  for (const RingTexel& t : ring) {
    const LinearColumn row = spot.basis(t.toward);
    for (int i = 0; i < kLinear; ++i) {
      right[0][i] += row[i] * t.radiance.r, right[1][i] += row[i] * t.radiance.g, right[2][i] += row[i] * t.radiance.b;
      for (int j = 0; j <= i; ++j) normal[i][j] += row[i] * row[j];
    }
  }
  for (int c = 0; c < 3; ++c) spot.channel_[c] = solve_semidefinite(normal, right[c]);

  const Rgb eighth = 0.125f * (spot.high_ - spot.low_);
  const auto below = [](float low, float step) { return low >= 0 ? std::max(0.0f, low - step) : low - step; };
  spot.low_ = {below(spot.low_.r, eighth.r), below(spot.low_.g, eighth.g), below(spot.low_.b, eighth.b)};
  spot.high_ += eighth;
  return spot;
}

LinearColumn BlindSpot::basis(Vec3 toward) const {
  // Of size one over the ring; the last is how far the direction lies behind the plane that touches at the axis.
  const Vec3 offset = toward - axis_;
  return {1, dot(offset, side_) / radius_, dot(offset, up_) / radius_, -dot(offset, axis_) / (radius_ * radius_)};
}

double BlindSpot::weight(Vec3 toward) const {
  const double distance = length(toward - axis_) / radius_;
  return std::clamp(4 - 4 * distance, 0.0, 1.0);
}

Rgb BlindSpot::radiance(Vec3 toward) const {
  const LinearColumn row = basis(toward);
  const auto value = [&](int c, float low, float high) {
    double sum = 0;
    for (int i = 0; i < kLinear; ++i) sum += channel_[c][i] * row[i];
    return std::clamp(static_cast<float>(sum), low, high);
  };
  return {value(0, low_.r, high_.r), value(1, low_.g, high_.g), value(2, low_.b, high_.b)};
}

}  // namespace zonal
