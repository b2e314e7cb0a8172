#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "zonal/math/vec.h"
#include "zonal/sh/sh.h"

namespace zonal {

// What the linear band of a radiance says about light and its direction. At least two bands, or std::logic_error.

/// e = int L(l) l dl over the sphere (Gershun 1936): |e| is the irradiance of a light that alone would carry as much
/// energy through the point, e/|e| points toward it. From the linear band alone, and exact: sqrt(4pi/3) times it.
template <int N>
Vec3 vector_irradiance(const Sh<double, N>& radiance) {
  check(radiance.bands() >= 2, "the vector irradiance is in the second band");
  return std::sqrt(4 * kPi / 3) * Vec3{radiance(1, 1), radiance(1, -1), radiance(1, 0)};
}

/// Each channel has one of its own: red, green, blue.
template <class T, int N>
std::array<Vec3, 3> vector_irradiance(const Sh<Color3<T>, N>& radiance) {
  check(radiance.bands() >= 2, "the vector irradiance is in the second band");
  std::array<Sh<double, 2>, 3> channels;
  for (std::size_t i = 0; i < 4; ++i) {
    const RgbD value(radiance[i]);
    channels[0][i] = value.r;
    channels[1][i] = value.g;
    channels[2][i] = value.b;
  }
  return {vector_irradiance(channels[0]), vector_irradiance(channels[1]), vector_irradiance(channels[2])};
}

/// E(n) - E(-n), what passes through a surface from its front to its back: n.e, exactly.
constexpr double net_irradiance(Vec3 vector_irradiance, Vec3 normal) { return dot(normal, vector_irradiance); }

/// E(n) as if all light came from the direction of e. Exact where no light falls on the back of the surface; else too
/// small, by E(-n) on a side that is turned toward e.
constexpr double irradiance_from_vector(Vec3 vector_irradiance, Vec3 normal) {
  return std::max(dot(normal, vector_irradiance), 0.0);
}

/// The direction in which the linear band rises: that of the vector irradiance, and the best place for a single light
/// where one dominates (Sloan 2008, "optimal linear direction"). For colour that of the luminance, with the weights of
/// Rec. 709. None where the linear band is zero.
template <int N>
std::optional<Vec3> optimal_linear_direction(const Sh<double, N>& sh) {
  const Vec3 rise = vector_irradiance(sh);
  const double size = std::hypot(rise.x, rise.y, rise.z);
  if (size == 0) return std::nullopt;
  return Vec3{rise.x / size, rise.y / size, rise.z / size};
}

template <class T, int N>
std::optional<Vec3> optimal_linear_direction(const Sh<Color3<T>, N>& sh) {
  check(sh.bands() >= 2, "the linear direction is in the second band");
  Sh<double, 2> brightness;
  for (std::size_t i = 0; i < 4; ++i) brightness[i] = luminance(RgbD(sh[i]));
  return optimal_linear_direction(brightness);
}

}  // namespace zonal
