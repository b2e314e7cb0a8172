#include "zonal/light/brdf.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "zonal/base/error.h"

namespace zonal {
namespace {

void check_range(const char* what, double value, double lo, double hi) {
  if (!(value >= lo && value <= hi)) {
    throw Error(ErrorKind::kUsage, std::string(what) + " is out of its range: " + std::to_string(value));
  }
}

void check_share(const char* what, RgbD share) {
  for (const double value : {share.r, share.g, share.b}) check_range(what, value, 0, 1);
}

/// |h|^2 without the loss of 1 - (n.h)^2 near the normal: sin^2 and cos^2 of the half vector, and v.h.
struct HalfVector {
  double sine2, cosine2, v_dot_h;
};
HalfVector half_vector(Vec3 l, Vec3 v) {
  const Vec3 sum = l + v;
  const double long_side2 = dot(sum, sum);
  return {(sum.x * sum.x + sum.y * sum.y) / long_side2, sum.z * sum.z / long_side2, std::sqrt(long_side2) / 2};
}

RgbD gray(double value) { return {value, value, value}; }

}  // namespace

Brdf lambert_brdf(RgbD albedo) {
  check_share("the albedo", albedo);
  return [value = (1 / kPi) * albedo](Vec3, Vec3) { return value; };
}

Brdf phong_brdf(double exponent) {
  check_range("the exponent", exponent, 0, 1e7);
  return [exponent](Vec3 l, Vec3 v) {
    const double cosine = dot(Vec3{-v.x, -v.y, v.z}, l);
    return gray(cosine > 0 ? (exponent + 2) / (2 * kPi) * std::pow(cosine, exponent) : 0);
  };
}

Brdf blinn_phong_brdf(double exponent) {
  check_range("the exponent", exponent, 0, 1e7);
  const double scale = (exponent + 2) * (exponent + 4) / (8 * kPi * (std::exp2(-exponent / 2) + exponent));
  return [exponent, scale](Vec3 l, Vec3 v) { return gray(scale * std::pow(half_vector(l, v).cosine2, exponent / 2)); };
}

Brdf ggx_brdf(double alpha, RgbD f0, Masking masking) {
  check_range("alpha", alpha, 1e-4, 1);
  check_share("f0", f0);
  return [a2 = alpha * alpha, f0, masking](Vec3 l, Vec3 v) {
    const auto [sine2, cosine2, v_dot_h] = half_vector(l, v);
    const double root = cosine2 * a2 + sine2, d = a2 / (kPi * root * root);
    const double smith_l = std::sqrt(a2 + (1 - a2) * l.z * l.z), smith_v = std::sqrt(a2 + (1 - a2) * v.z * v.z);
    // G/(4 n.l n.v), which is finite where G alone over n.l would be 0/0.
    const double visibility = masking == Masking::kHeightCorrelated ? 0.5 / (l.z * smith_v + v.z * smith_l)
                                                                    : 1 / ((l.z + smith_l) * (v.z + smith_v));
    const double fresnel = std::pow(std::max(0.0, 1 - v_dot_h), 5);  // Schlick 1994
    return d * visibility * (f0 + fresnel * (gray(1) - f0));
  };
}

}  // namespace zonal
