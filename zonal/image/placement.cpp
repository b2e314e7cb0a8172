#include "zonal/image/placement.h"

#include <cmath>
#include <numbers>

namespace zonal {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

}  // namespace

Placing::Placing(const Placement& placement, PicturePoint center)
    : center_(center),
      cosine_(std::cos(kRadians * placement.rotation_deg)),
      sine_(std::sin(kRadians * placement.rotation_deg)),
      dx_(placement.dx),
      dy_(placement.dy) {}

Placement composed(const Placement& second, const Placement& first) {
  const PicturePoint moved = Placing(second, {})({first.dx, first.dy});
  return {moved.x, moved.y, first.rotation_deg + second.rotation_deg};
}

Placement inverse(const Placement& placement) {
  const PicturePoint back = Placing({0, 0, -placement.rotation_deg}, {})({-placement.dx, -placement.dy});
  return {back.x, back.y, -placement.rotation_deg};
}

bool is_whole(const Placement& p) {
  return p.rotation_deg == 0 && p.dx == std::round(p.dx) && p.dy == std::round(p.dy);
}

Placement settled(const Placement& p, int width, int height, double tolerance_px) {
  const Placement whole{std::round(p.dx), std::round(p.dy), 0};
  const double at_corner = kRadians * std::abs(p.rotation_deg) * std::hypot(width, height) / 2;
  return std::hypot(p.dx - whole.dx, p.dy - whole.dy) + at_corner <= tolerance_px ? whole : p;
}

}  // namespace zonal
