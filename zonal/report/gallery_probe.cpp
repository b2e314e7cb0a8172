#include "zonal/report/gallery_probe.h"

#include <cmath>

#include "zonal/light/synthetic.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

Vec3 toward(double azimuth_deg, double elevation_deg) {
  const double azimuth = radians(azimuth_deg), elevation = radians(elevation_deg);
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

/// A lamp whose edge is soft, as a shade makes it.
Rgb lamp(Vec3 d, Vec3 toward_lamp, double half_angle_deg, Rgb radiance) {
  return static_cast<float>(smooth_cone_profile(angle_between(d, toward_lamp), radians(half_angle_deg))) * radiance;
}

/// Panes between bars, on the wall to the left.
Rgb window_pane(Vec3 d) {
  const double azimuth = degrees(std::atan2(d.y, d.x)) - 70, height = degrees(std::asin(d.z)) - 12;
  if (std::abs(azimuth) > 22 || std::abs(height) > 20) return {};
  if (std::abs(azimuth) < 1.2 || std::abs(height) < 1.2) return {};
  return {2.8f, 4.4f, 7.2f};
}

Rgb room(Vec3 d) {
  if (d.z < -0.25) {
    // Boards of the floor, seen from 1 above it.
    const bool dark = static_cast<long>(std::floor(d.y / -d.z * 2)) % 2 != 0;
    return dark ? Rgb{0.05f, 0.032f, 0.02f} : Rgb{0.075f, 0.05f, 0.03f};
  }
  if (d.z > 0.7) return {0.30f, 0.29f, 0.27f};
  const float falloff = static_cast<float>(0.55 + 0.45 * d.z);
  return falloff * Rgb{0.26f, 0.23f, 0.20f} + window_pane(d);
}

}  // namespace

Environment gallery_probe(const Run& run) {
  const Projection flat = {Layout::kEquirect};
  const auto radiance = [](Vec3 d) {
    return room(d) + lamp(d, toward(-50, 42), 26, {26, 20, 12}) + lamp(d, toward(165, 18), 18, {15, 4, 1.6f});
  };
  return paint(flat, image_size(flat.layout, 256), radiance, 2, run);
}

}  // namespace zonal
