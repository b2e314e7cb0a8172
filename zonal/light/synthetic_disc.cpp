#include "zonal/light/synthetic_disc.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/light/synthetic_texel.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

struct Covered {
  Texel texel;
  double part = 0;  ///< of the texel's area, 0..1
  double solid_angle = 0;
};

/// How far a texel reaches from its direction. Corners outside a circle's rim show nothing nearer than the rest does.
double reach_of(const Mapping& mapping, Texel t, Vec3 toward) {
  double reach = std::sqrt(mapping.solid_angle(t.x, t.y));
  for (int corner = 0; corner < 4; ++corner) {
    // A little inside: a corner itself may belong to another face.
    const auto d = mapping.direction({t.x + 0.01 + 0.98 * (corner % 2), t.y + 0.01 + 0.98 * (corner / 2)});
    if (d) reach = std::max(reach, angle_between(*d, toward));
  }
  return reach;
}

double covered_part(const Mapping& mapping, Texel t, Vec3 center, double radius) {
  const auto toward = mapping.texel_direction(t.x, t.y);
  if (!toward) return 0;
  const double distance = angle_between(*toward, center);
  // Texels larger than this occur only in pictures of a few hundred texels, which are then all looked at.
  constexpr double kFar = 0.5;
  if (distance > radius + kFar && mapping.size().width > 64) return 0;
  const double reach = reach_of(mapping, t, *toward);
  if (distance > radius + reach) return 0;
  if (distance + reach < radius) return 1;
  // Points a sixteenth of the radius apart, up to 128² of them.
  const int n = std::clamp(static_cast<int>(std::ceil(32 * reach / radius)), 8, 128);
  const double limit = std::cos(radius);
  return texel_mean<double>(mapping, t.x, t.y, n, [&](Vec3 d) { return dot(d, center) >= limit ? 1.0 : 0.0; });
}

bool shows_all_of(const Mapping& mapping, Vec3 center, double radius) {
  if (mapping.covers_sphere()) return true;
  const Vec3 side = normalize(cross(center, std::abs(center.z) < 0.5 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
  constexpr int kAround = 64;
  for (int i = 0; i < kAround; ++i) {
    const Vec3 out = Rotation::about(center, 2 * kPi * i / kAround) * side;
    if (!mapping.position(std::cos(radius) * center + std::sin(radius) * out)) return false;
  }
  return mapping.position(center).has_value();
}

}  // namespace

void add_disc(Environment& environment, Vec3 center, double radius, RgbD radiance) {
  const Mapping mapping(environment.projection, {environment.radiance.width(), environment.radiance.height()});
  std::vector<Covered> covered;
  double inner = 0, edge = 0;
  for (int y = 0; y < environment.radiance.height(); ++y) {
    for (int x = 0; x < environment.radiance.width(); ++x) {
      const double part = covered_part(mapping, {x, y}, center, radius);
      if (part <= 0) continue;
      const double solid_angle = mapping.solid_angle(x, y);
      covered.push_back({{x, y}, part, solid_angle});
      (part < 1 ? edge : inner) += part * solid_angle;
    }
  }

  const double half_sine = std::sin(radius / 2), disc = 4 * kPi * half_sine * half_sine;  // 2π(1 - cos radius)
  if (shows_all_of(mapping, center, radius)) {
    if (inner + edge <= 0) {  // smaller than the distance of the points
      const Texel t = mapping.nearest(center);
      const double solid_angle = mapping.solid_angle(t.x, t.y);
      covered.assign(1, {t, disc / solid_angle, solid_angle});
    } else {
      const bool edge_can = edge > 0 && disc > inner;
      const double inner_scale = edge_can ? 1 : disc / (inner + edge);
      const double edge_scale = edge_can ? (disc - inner) / edge : inner_scale;
      for (Covered& c : covered) c.part *= c.part < 1 ? edge_scale : inner_scale;
    }
  }
  for (const Covered& c : covered) {
    Rgb& texel = environment.radiance(c.texel.x, c.texel.y);
    texel = Rgb(RgbD(texel) + c.part * radiance);
  }
}

}  // namespace zonal
