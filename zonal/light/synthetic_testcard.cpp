#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "zonal/light/synthetic.h"
#include "zonal/light/synthetic_stroke.h"

namespace zonal {
namespace {

struct Side {
  const char* name;
  Vec3 center, up;  // up as seen by a viewer who faced +X and then turned, or tilted the head back or down
  Rgb paint;
};

// An axis and its opposite have complementary paints: red/cyan, green/magenta, blue/yellow.
constexpr Side kSides[] = {
    {"+X", {1, 0, 0}, {0, 0, 1}, {0.60f, 0.06f, 0.05f}},  {"-X", {-1, 0, 0}, {0, 0, 1}, {0.05f, 0.45f, 0.45f}},
    {"+Y", {0, 1, 0}, {0, 0, 1}, {0.08f, 0.45f, 0.06f}},  {"-Y", {0, -1, 0}, {0, 0, 1}, {0.45f, 0.07f, 0.40f}},
    {"+Z", {0, 0, 1}, {-1, 0, 0}, {0.07f, 0.16f, 0.65f}}, {"-Z", {0, 0, -1}, {1, 0, 0}, {0.55f, 0.42f, 0.05f}}};

const Side& side_at(Vec3 d) {
  return *std::max_element(std::begin(kSides), std::end(kSides),
                           [&](const Side& a, const Side& b) { return dot(a.center, d) < dot(b.center, d); });
}

/// Distance in degrees from the nearest multiple of `step`.
double from_line(double angle_deg, double step) { return std::abs(std::remainder(angle_deg, step)); }

/// 0: no line, 1: one of the 15 degree grid, 2: equator or a quarter meridian.
int grid_line(Vec3 d) {
  constexpr double kStep = 15, kThin = 0.12, kThick = 0.35;  // degrees, half width
  const double level = std::hypot(d.x, d.y);
  const double azimuth = degrees(std::atan2(d.y, d.x)), elevation = degrees(std::atan2(d.z, level));
  if (std::abs(elevation) < kThick || from_line(azimuth, 90) * level < kThick) return 2;
  // Towards the poles only every third meridian goes on.
  const double meridians = std::abs(elevation) < 75 ? kStep : 3 * kStep;
  return from_line(elevation, kStep) < kThin || from_line(azimuth, meridians) * level < kThin;
}

std::vector<SphereText> all_text() {
  std::vector<SphereText> text;
  for (const Side& side : kSides) text.emplace_back(side.name, side.center, side.up, 0.5);
  // Degrees of azimuth, from +X toward +Y, and of elevation above +X and -X.
  const auto number = [&](int shown, double azimuth_deg, double elevation_deg) {
    const double a = radians(azimuth_deg), e = radians(elevation_deg);
    const Vec3 center = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    const Vec3 up = {-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e)};
    text.emplace_back(std::to_string(shown), center, up, 0.06);
  };
  for (int azimuth = 0; azimuth < 360; azimuth += 30) number(azimuth, azimuth, 22.5);
  for (const int elevation : {-60, -30, 30, 60}) {
    number(elevation, 7.5, elevation);
    number(elevation, 187.5, elevation);
  }
  return text;
}

}  // namespace

Environment testcard(const Projection& projection, ImageSize size, const Run& run) {
  const std::vector<SphereText> text = all_text();
  const auto radiance = [&](Vec3 d) {
    if (std::any_of(text.begin(), text.end(), [&](const SphereText& word) { return word.covers(d); }))
      return Rgb{1, 1, 1};
    const Rgb paint = side_at(d).paint;
    switch (grid_line(d)) {
      case 1:
        return 0.5f * paint;
      case 2:
        return Rgb{0.02f, 0.02f, 0.02f};
      default:
        return paint;
    }
  };
  return paint(projection, size, radiance, 3, run);
}

}  // namespace zonal
