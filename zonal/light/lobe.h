#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace zonal {

enum class LobeKind { kCosine, kPhong, kBlinnPhong, kGgx, kCharlie, kCone, kGaussian };

/// A blur of the sphere that depends on c = l.n alone (n = v = r, Karis 2013): a kernel k(c) of unit integral over the
/// sphere. A plain value. Filtering radiance with it multiplies band l by band_factors(lobe, bands)[l]. The factories
/// throw Error{kUsage} when the parameter is outside the domain stated with them.
class Lobe {
 public:
  /// max(c, 0)/pi: the irradiance of a surface, over pi.
  static Lobe cosine();
  /// max(c, 0)^exponent, exponent in [0, 1e9] (Phong 1975). Without a factor n.l: to include it, add 1.
  static Lobe phong(double exponent);
  /// max(c, 0) ((1 + c)/2)^(exponent/2), exponent in [0, 1e9] (Blinn 1977): (n.h)^exponent times n.l.
  static Lobe blinn_phong(double exponent);
  /// D(h) n.l with Trowbridge-Reitz's D (Walter et al. 2007, "GGX"); alpha in [1e-4, 1]. At 1 it is the cosine.
  static Lobe ggx(double alpha);
  /// D(h) n.l with D = (2 + 1/alpha) sin(h)^(1/alpha) / 2pi (Estevez & Kulla 2017, "Charlie", for sheen); alpha in
  /// [1e-4, 1]. With n = v = r it is max(c, 0) ((1 - c)/2)^(1/(2 alpha)): zero along n, a broad ring around it.
  static Lobe charlie(double alpha);
  /// Constant within half_angle radians of n, zero outside; half_angle in [1e-6, pi]. A disc light, a box blur.
  static Lobe cone(double half_angle);
  /// exp(kappa (c - 1)) with kappa = 1/width^2: von Mises-Fisher 1953, a spherical Gaussian. `width` is the standard
  /// deviation along either axis, in radians, where it is small; width in [1e-5, 100].
  static Lobe gaussian(double width);

  LobeKind kind() const { return kind_; }
  /// What the factory was given; 0 for the cosine.
  double parameter() const { return parameter_; }

  /// The kernel at c = l.n in [-1, 1] (give or take a rounding), in 1/sr. Its integral over the sphere is 1.
  double kernel(double c) const { return kernel_from_versine(std::clamp(1 - c, 0.0, 2.0)); }
  /// The same at 1 - c = 2 sin^2(angle/2) in [0, 2]: keeps all digits where a sharp lobe lives.
  double kernel_from_versine(double versine) const;
  /// The greatest value of the kernel, in 1/sr.
  double kernel_maximum() const;

  bool operator==(const Lobe&) const = default;

 private:
  Lobe(LobeKind, double parameter, double shape, double scale);

  LobeKind kind_;
  double parameter_;
  double shape_;  // what the kernel's formula needs of the parameter
  double scale_;  // makes the integral 1
};

/// lambda_l = 2 pi int k(c) P_l(c) dc for l = 0..bands-1; lambda_0 = 1, |lambda_l| <= 1. Absolute error under 1e-12.
/// O(bands), plus O(1/alpha) for GGX. Derivations: docs/notes/lobes.md.
std::vector<double> band_factors(const Lobe&, int bands);

/// The first band from which on every |lambda_l| stays below `tolerance`, so that this many bands are enough for it.
/// tolerance in (0, 1]. Throws Error{kUsage} where that would take more than a million bands (a cone's factors fall
/// like l^-3/2 only).
int bands_for(const Lobe&, double tolerance);

/// GGX and Charlie take alpha; what artists call roughness is its square root (Burley 2012): alpha = roughness^2.
constexpr double alpha_from_roughness(double roughness) { return roughness * roughness; }

/// The lobe that a chain of prefiltered levels uses at this perceptual roughness in [0.01, 1].
/// GGX, Charlie: alpha = roughness^2. Blinn-Phong: exponent 2/alpha^2 - 2 (Walter et al. 2007). Phong, n.l included: a
/// quarter of that, plus 1 (Fisher & Woo 1994). All but Charlie end at the cosine. Throws Error{kUsage} outside, and
/// for the cosine, cones and Gaussians, which know no roughness.
Lobe lobe_for_roughness(LobeKind, double roughness);

std::string_view name_of(LobeKind);
std::optional<LobeKind> lobe_kind_named(std::string_view name);
std::span<const LobeKind> all_lobe_kinds();

}  // namespace zonal
