#pragma once

#include <array>
#include <span>

#include "zonal/sh/eval.h"
#include "zonal/sh/per_band.h"
#include "zonal/sh/sh.h"
#include "zonal/sh/zonal.h"

namespace zonal {

/// Six values, one for each side of the world: the function sum over the axes of (coordinate)^2 times the value of that
/// side (McTaggart 2004, Half-Life 2's lighting). It is continuous and takes the value of a side on its axis.
template <class T>
struct AmbientCube {
  std::array<T, 6> sides = {};  // +X -X +Y -Y +Z -Z
  bool operator==(const AmbientCube&) const = default;
};

/// The axes in the order of AmbientCube's sides.
inline constexpr std::array<Vec3, 6> kCubeAxes = {Vec3{1, 0, 0},  Vec3{-1, 0, 0}, Vec3{0, 1, 0},
                                                  Vec3{0, -1, 0}, Vec3{0, 0, 1},  Vec3{0, 0, -1}};

/// lambda_l of the cube's basis function max(c, 0)^2 about its axis for l = 0..factors.size()-1, exact to rounding: 2pi
/// times the integral of c^2 P_l(c) over [0, 1] (Byerly 1893). 0 for even l >= 4, which c^2 does not contain.
constexpr void cube_side_factors(std::span<double> factors) {
  double even = 2 * kPi / 3, odd = 2 * kPi / 4;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const double l = static_cast<double>(i);
    double& value = i % 2 == 0 ? even : odd;
    if (i >= 2) value *= (4 - l) / (3 + l);
    factors[i] = value;
  }
}

/// The function of the cube at a unit direction.
template <class T>
T evaluate(const AmbientCube<T>& cube, Vec3 d) {
  using Scalar = ScalarOf<T>;
  return static_cast<Scalar>(d.x * d.x) * cube.sides[d.x < 0 ? 1 : 0] +
         static_cast<Scalar>(d.y * d.y) * cube.sides[d.y < 0 ? 3 : 2] +
         static_cast<Scalar>(d.z * d.z) * cube.sides[d.z < 0 ? 5 : 4];
}

namespace ambient_cube_detail {
/// The integrals of a function times each of the six basis functions to the six values of its least-squares fit.
template <class Wide>
std::array<Wide, 6> solve(const std::array<Wide, 6>& integrals) {
  // Sloan 2008. The integral of a basis function squared is 2pi/5; opposite sides do not overlap, others do by pi/15.
  // So differences of opposite sides solve for themselves, and the three sums up to their total.
  constexpr double kSame = 2 * kPi / 5, kOther = kPi / 15;
  std::array<Wide, 3> sums;
  Wide total = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sums[axis] = integrals[2 * axis] + integrals[2 * axis + 1];
    total += sums[axis];
  }
  total = (1 / (kSame + 4 * kOther)) * total;
  std::array<Wide, 6> sides;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Wide sum = (1 / (kSame - 2 * kOther)) * (sums[axis] - (2 * kOther) * total);
    const Wide difference = (1 / kSame) * (integrals[2 * axis] - integrals[2 * axis + 1]);
    sides[2 * axis] = 0.5 * (sum + difference);
    sides[2 * axis + 1] = 0.5 * (sum - difference);
  }
  return sides;
}
}  // namespace ambient_cube_detail

/// The cube nearest to a function of any number of bands, in the mean square over the sphere. For matte shading give it
/// irradiance_over_pi(radiance): even bands from 4 on do not reach the cube, and of the odd bands from 3 on, which
/// would, the clamped cosine leaves nothing.
template <class T, int N>
AmbientCube<T> ambient_cube(const Sh<T, N>& sh) {
  // The integral of the function with a basis function about an axis is the convolution of the two there.
  PerBand<double, N> factors = per_band<double, N>(sh.bands());
  cube_side_factors(factors);
  const Sh<WideOf<T>, N> wide = convolve(cast<WideOf<T>>(sh), factors);
  std::array<WideOf<T>, 6> integrals;
  for (std::size_t i = 0; i < 6; ++i) integrals[i] = evaluate(wide, kCubeAxes[i]);
  const std::array<WideOf<T>, 6> sides = ambient_cube_detail::solve(integrals);
  AmbientCube<T> cube;
  for (std::size_t i = 0; i < 6; ++i) cube.sides[i] = static_cast<T>(sides[i]);
  return cube;
}

/// The first coefficients of the cube's function, which has infinitely many bands. `bands` is needed where N is
/// dynamic. A function of 3 bands that goes to a cube and back keeps its constant, its two squares on the axes and
/// 15/16 of its linear part, and loses xy, yz and zx.
template <int N = kDynamic, class T>
Sh<T, N> sh_from_ambient_cube(const AmbientCube<T>& cube, int bands = N) {
  check(bands >= 1, "coefficients of at least one band");
  PerBand<double, N> factors = per_band<double, N>(bands);
  cube_side_factors(factors);
  Sh<WideOf<T>, N> sum(bands);
  Sh<double, N> y(bands);
  for (std::size_t side = 0; side < 6; ++side) {
    basis(bands, kCubeAxes[side], y.values());
    for (std::size_t i = 0; i < y.size(); ++i) sum[i] += y[i] * static_cast<WideOf<T>>(cube.sides[side]);
  }
  return cast<T>(convolve(std::move(sum), factors));
}

}  // namespace zonal
