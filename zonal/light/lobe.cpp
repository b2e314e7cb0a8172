#include "zonal/light/lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/math/vec.h"

namespace zonal {
namespace {

constexpr std::array kKinds = {LobeKind::kCosine,  LobeKind::kPhong, LobeKind::kBlinnPhong, LobeKind::kGgx,
                               LobeKind::kCharlie, LobeKind::kCone,  LobeKind::kGaussian};
constexpr std::array<std::string_view, kKinds.size()> kNames = {"cosine",  "phong", "blinn-phong", "ggx",
                                                                "charlie", "cone",  "gaussian"};

std::string short_text(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

/// Returns the value, or throws the error that names its domain.
double in_domain(LobeKind kind, double value, double low, double high, const char* name) {
  if (value >= low && value <= high) return value;  // NaN falls through
  const std::string lobe(name_of(kind));
  throw Error(ErrorKind::kUsage, "the " + lobe + " lobe's " + name + " is out of range: " + short_text(value),
              "give a value from " + short_text(low) + " to " + short_text(high));
}

/// int_0^1 ((1 + c)/2)^p dc.
double half_power(double p) { return -2 * std::expm1(-(p + 1) * std::numbers::ln2) / (p + 1); }

/// int_0^1 c/(1 - x c)^2 dc for x = (1 - alpha^2)/(1 + alpha^2).
double ggx_integral(double alpha) {
  const double a2 = alpha * alpha, x = (1 - a2) / (1 + a2), one_minus_x = 2 * a2 / (1 + a2);
  if (x > 0.25) return (x / one_minus_x + std::log(one_minus_x)) / (x * x);
  // The closed form cancels as x goes to 0; its series sum (n+1)/(n+2) x^n does not. 0.25^28 < 2^-53.
  double sum = 0;
  for (int n = 28; n >= 0; --n) sum = sum * x + (n + 1.0) / (n + 2.0);
  return sum;
}

}  // namespace

Lobe::Lobe(LobeKind kind, double parameter, double shape, double scale)
    : kind_(kind), parameter_(parameter), shape_(shape), scale_(scale) {}

Lobe Lobe::cosine() { return {LobeKind::kCosine, 0, 0, 1 / kPi}; }

Lobe Lobe::phong(double exponent) {
  in_domain(LobeKind::kPhong, exponent, 0, 1e9, "exponent");
  return {LobeKind::kPhong, exponent, exponent, (exponent + 1) / (2 * kPi)};
}

Lobe Lobe::blinn_phong(double exponent) {
  in_domain(LobeKind::kBlinnPhong, exponent, 0, 1e9, "exponent");
  const double p = exponent / 2;  // c ((1+c)/2)^p = 2 ((1+c)/2)^(p+1) - ((1+c)/2)^p
  return {LobeKind::kBlinnPhong, exponent, p, 1 / (2 * kPi * (2 * half_power(p + 1) - half_power(p)))};
}

Lobe Lobe::ggx(double alpha) {
  in_domain(LobeKind::kGgx, alpha, 1e-4, 1, "alpha");
  const double a2 = alpha * alpha;
  return {LobeKind::kGgx, alpha, 2 * a2 / (1 + a2), 1 / (2 * kPi * ggx_integral(alpha))};
}

Lobe Lobe::charlie(double alpha) {
  in_domain(LobeKind::kCharlie, alpha, 1e-4, 1, "alpha");
  const double q = 1 / (2 * alpha);  // int_0^1 c (1-c)^q dc = 1/((q+1)(q+2))
  return {LobeKind::kCharlie, alpha, q, (q + 1) * (q + 2) / (2 * kPi)};
}

Lobe Lobe::cone(double half_angle) {
  in_domain(LobeKind::kCone, half_angle, 1e-6, kPi, "half angle");
  const double sine = std::sin(half_angle / 2), versine = 2 * sine * sine;
  return {LobeKind::kCone, half_angle, versine, 1 / (2 * kPi * versine)};
}

Lobe Lobe::gaussian(double width) {
  in_domain(LobeKind::kGaussian, width, 1e-5, 100, "width");
  const double kappa = 1 / (width * width);
  return {LobeKind::kGaussian, width, kappa, kappa / (-2 * kPi * std::expm1(-2 * kappa))};
}

double Lobe::kernel_from_versine(double versine) const {
  const double c = 1 - versine;
  if (kind_ == LobeKind::kCone) return versine <= shape_ ? scale_ : 0;
  if (kind_ == LobeKind::kGaussian) return scale_ * std::exp(-shape_ * versine);
  if (c <= 0) return 0;
  switch (kind_) {
    case LobeKind::kCosine:
      return scale_ * c;
    case LobeKind::kPhong:
      return scale_ * std::exp(shape_ * std::log1p(-versine));
    case LobeKind::kBlinnPhong:
      return scale_ * c * std::exp(shape_ * std::log1p(-versine / 2));
    case LobeKind::kGgx: {
      // 1 - x c = (1 - x) + x versine, where 1 - x is the shape.
      const double distance = shape_ + (1 - shape_) * versine;
      return scale_ * c / (distance * distance);
    }
    case LobeKind::kCharlie:
      return scale_ * c * std::pow(versine, shape_);
    case LobeKind::kCone:
    case LobeKind::kGaussian:
      break;
  }
  check(false, "a lobe of unknown kind");
  return 0;
}

double Lobe::kernel_maximum() const {
  // Charlie: the derivative of c (1-c)^q vanishes at 1 - c = q/(q+1). All others fall from their axis.
  return kernel_from_versine(kind_ == LobeKind::kCharlie ? shape_ / (shape_ + 1) : 0);
}

Lobe lobe_for_roughness(LobeKind kind, double roughness) {
  const double alpha = alpha_from_roughness(in_domain(kind, roughness, 0.01, 1, "roughness"));
  const double exponent = 2 / (alpha * alpha) - 2;
  switch (kind) {
    case LobeKind::kGgx:
      return Lobe::ggx(alpha);
    case LobeKind::kCharlie:
      return Lobe::charlie(alpha);
    case LobeKind::kBlinnPhong:
      return Lobe::blinn_phong(exponent);
    case LobeKind::kPhong:
      return Lobe::phong(1 + exponent / 4);
    case LobeKind::kCosine:
    case LobeKind::kCone:
    case LobeKind::kGaussian:
      break;
  }
  throw Error(ErrorKind::kUsage, "the " + std::string(name_of(kind)) + " lobe has no roughness",
              "take ggx, charlie, phong or blinn-phong");
}

std::string_view name_of(LobeKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<LobeKind> lobe_kind_named(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return kKinds[static_cast<std::size_t>(found - kNames.begin())];
}

std::span<const LobeKind> all_lobe_kinds() { return kKinds; }

}  // namespace zonal
