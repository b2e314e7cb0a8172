#pragma once

#include <array>

#include "zonal/sh/sh.h"

namespace zonal {

/// Irradiance over pi (the radiance of a white matte surface) as a shader likes it: seven vectors of four (Sloan 2008,
/// appendix A10), ready to upload. With the unit normal n = (x, y, z), for each of red, green, blue:
///   E/pi = dot(linear[c], (x, y, z, 1)) + dot(quadratic[c], (xy, yz, zz, zx)) + (xx - yy) last[c].
template <class Scalar>
struct IrradianceOverPiConstants {
  using Vector4 = std::array<Scalar, 4>;
  std::array<Vector4, 3> linear = {};     ///< cAr, cAg, cAb
  std::array<Vector4, 3> quadratic = {};  ///< cBr, cBg, cBb
  Vector4 last = {};                      ///< cC; its fourth number is not used
  bool operator==(const IrradianceOverPiConstants&) const = default;
};

IrradianceOverPiConstants<float> irradiance_over_pi_constants(const Sh<Rgb, 3>& radiance);
IrradianceOverPiConstants<double> irradiance_over_pi_constants(const Sh<RgbD, 3>& radiance);

/// What the shader computes: E/pi at a unit normal.
Rgb irradiance_over_pi(const IrradianceOverPiConstants<float>&, Vec3 normal);
RgbD irradiance_over_pi(const IrradianceOverPiConstants<double>&, Vec3 normal);

/// Irradiance E as a quadratic form: E = n^T M n with n = (x, y, z, 1) (Ramamoorthi & Hanrahan 2001, eq. 11 and 12).
/// Symmetric. T is double or float, or a colour for three matrices in one.
template <class T>
struct IrradianceMatrix {
  std::array<std::array<T, 4>, 4> rows = {};
  bool operator==(const IrradianceMatrix&) const = default;
};

IrradianceMatrix<double> irradiance_matrix(const Sh<double, 3>& radiance);
IrradianceMatrix<RgbD> irradiance_matrix(const Sh<RgbD, 3>& radiance);
IrradianceMatrix<Rgb> irradiance_matrix(const Sh<Rgb, 3>& radiance);

/// E at a unit normal; times albedo/pi it is the reflected radiance.
template <class T>
T irradiance(const IrradianceMatrix<T>& matrix, Vec3 normal) {
  using Scalar = ScalarOf<T>;
  const std::array<Scalar, 4> n = {static_cast<Scalar>(normal.x), static_cast<Scalar>(normal.y),
                                   static_cast<Scalar>(normal.z), Scalar(1)};
  T sum = {};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) sum += (n[i] * n[k]) * matrix.rows[i][k];
  }
  return sum;
}

}  // namespace zonal
