#include "zonal/sh/shading_constants.h"

#include <cmath>

#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

/// The clamped cosine's factor times the constant in front of a basis polynomial: y = k, k x, k xy, k (3zz - 1) and
/// k (xx - yy). fC0 .. fC4 of Sloan 2008, appendix A10; times pi (fC1 and fC2 by 1/2 too), Ramamoorthi & Hanrahan's c4,
/// c2, c1 and c5; their c3 is 3 c5.
struct CosineConstants {
  double constant, linear, product, zonal, difference;
};

CosineConstants computed_constants() {
  const std::vector<double> factors = cosine_factors(3);
  return {.constant = factors[0] * std::sqrt(1 / (4 * kPi)),
          .linear = factors[1] * std::sqrt(3 / (4 * kPi)),
          .product = factors[2] * std::sqrt(15 / (4 * kPi)),
          .zonal = factors[2] * std::sqrt(5 / (16 * kPi)),
          .difference = factors[2] * std::sqrt(15 / (16 * kPi))};
}

/// Once in the run of a program, so that the verbs take no heap.
const CosineConstants& cosine_constants() {
  static const CosineConstants constants = computed_constants();
  return constants;
}

template <class Scalar>
IrradianceOverPiConstants<Scalar> vectors_of(const Sh<Color3<Scalar>, 3>& radiance) {
  const CosineConstants& k = cosine_constants();
  const Sh<RgbD, 3> wide = cast<RgbD>(radiance);
  IrradianceOverPiConstants<Scalar> result;
  const std::array channels = {&RgbD::r, &RgbD::g, &RgbD::b};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto value = [&](int l, int m) { return wide(l, m).*channels[c]; };
    const auto narrow = [](double number) { return static_cast<Scalar>(number); };
    result.linear[c] = {narrow(k.linear * value(1, 1)), narrow(k.linear * value(1, -1)), narrow(k.linear * value(1, 0)),
                        narrow(k.constant * value(0, 0) - k.zonal * value(2, 0))};
    result.quadratic[c] = {narrow(k.product * value(2, -2)), narrow(k.product * value(2, -1)),
                           narrow(3 * k.zonal * value(2, 0)), narrow(k.product * value(2, 1))};
    result.last[c] = narrow(k.difference * value(2, 2));
  }
  return result;
}

template <class Scalar>
Color3<Scalar> shade(const IrradianceOverPiConstants<Scalar>& constants, Vec3 normal) {
  const auto x = static_cast<Scalar>(normal.x), y = static_cast<Scalar>(normal.y), z = static_cast<Scalar>(normal.z);
  std::array<Scalar, 3> sums = {};
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const auto &a = constants.linear[c], &b = constants.quadratic[c];
    sums[c] = a[0] * x + a[1] * y + a[2] * z + a[3] + b[0] * x * y + b[1] * y * z + b[2] * z * z + b[3] * z * x +
              constants.last[c] * (x * x - y * y);
  }
  return {sums[0], sums[1], sums[2]};
}

template <class T>
IrradianceMatrix<T> matrix_of(const Sh<T, 3>& radiance) {
  using Wide = WideOf<T>;
  const CosineConstants& k = cosine_constants();
  const auto term = [&](double factor, int l, int m) { return (kPi * factor) * static_cast<Wide>(radiance(l, m)); };
  // A product and a linear term are met twice, on both sides of the diagonal.
  const Wide xx = term(k.difference, 2, 2), xy = term(k.product / 2, 2, -2), xz = term(k.product / 2, 2, 1),
             yz = term(k.product / 2, 2, -1), zz = term(3 * k.zonal, 2, 0), x = term(k.linear / 2, 1, 1),
             y = term(k.linear / 2, 1, -1), z = term(k.linear / 2, 1, 0),
             one = term(k.constant, 0, 0) - term(k.zonal, 2, 0);
  const std::array<std::array<Wide, 4>, 4> rows = {
      {{xx, xy, xz, x}, {xy, -1.0 * xx, yz, y}, {xz, yz, zz, z}, {x, y, z, one}}};
  IrradianceMatrix<T> matrix;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) matrix.rows[i][j] = static_cast<T>(rows[i][j]);
  }
  return matrix;
}

}  // namespace

IrradianceOverPiConstants<float> irradiance_over_pi_constants(const Sh<Rgb, 3>& radiance) {
  return vectors_of(radiance);
}
IrradianceOverPiConstants<double> irradiance_over_pi_constants(const Sh<RgbD, 3>& radiance) {
  return vectors_of(radiance);
}

Rgb irradiance_over_pi(const IrradianceOverPiConstants<float>& constants, Vec3 normal) {
  return shade(constants, normal);
}
RgbD irradiance_over_pi(const IrradianceOverPiConstants<double>& constants, Vec3 normal) {
  return shade(constants, normal);
}

IrradianceMatrix<double> irradiance_matrix(const Sh<double, 3>& radiance) { return matrix_of(radiance); }
IrradianceMatrix<RgbD> irradiance_matrix(const Sh<RgbD, 3>& radiance) { return matrix_of(radiance); }
IrradianceMatrix<Rgb> irradiance_matrix(const Sh<Rgb, 3>& radiance) { return matrix_of(radiance); }

}  // namespace zonal
