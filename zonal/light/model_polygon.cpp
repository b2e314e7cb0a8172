#include "zonal/light/model_polygon.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "zonal/base/check.h"
#include "zonal/light/model_argument.h"
#include "zonal/math/quadrature.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/zonal_lights.h"

namespace zonal {
namespace {

/// Angles closer to a half circle than this: the edge, or the polygon's plane, passes through the lit point up to
/// rounding.
constexpr double kTouching = 1e-12;

/// The solid angle to the left of the loop as seen from outside the sphere, negative where it runs the other way round.
double signed_solid_angle(std::span<const Vec3> v) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    const Vec3 a = v[0], b = v[i], c = v[i + 1];
    // By differences of the corners, so that small triangles keep their digits.
    const double volume = dot(a, cross(b - a, c - a));
    const double la = length(a), lb = length(b), lc = length(c);
    sum += 2 * std::atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return std::remainder(sum, 4 * kPi);  // a fan that leaves the polygon may count the whole sphere
}

/// A polygon that is a light: not degenerate, and of a size whose products neither overflow nor vanish.
struct Outline {
  std::vector<Vec3> vertices;
  double signed_solid_angle;
};

Outline outline_of(std::span<const Vec3> vertices) {
  if (vertices.size() < 3) throw Error(ErrorKind::kUsage, "a polygon light needs at least three vertices");
  double largest = 0;
  for (const Vec3 v : vertices) {
    direction_of(v, "a vertex of a polygon light, as seen from the lit point,");
    largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  }
  Outline outline{{vertices.begin(), vertices.end()}, 0};
  for (Vec3& v : outline.vertices) v = {v.x / largest, v.y / largest, v.z / largest};
  outline.signed_solid_angle = signed_solid_angle(outline.vertices);
  if (!(std::abs(outline.signed_solid_angle) < 2 * kPi - kTouching)) {
    throw Error(ErrorKind::kUsage, "the lit point lies in the polygon light", "move it out of the light's plane");
  }
  return outline;
}

/// An edge as seen from the lit point: the arc from unit vector `from` on toward `ahead`, in the plane of unit normal
/// `left`, which points to the left of it as seen from outside the sphere.
struct Arc {
  Vec3 from, ahead, left;
  double angle;
};

Arc arc_between(Vec3 p, Vec3 q) {
  const Vec3 from = direction_of(p, "a vertex"), normal = cross(p, q - p);
  const double sine = length(normal), angle = std::atan2(sine, dot(p, q));
  if (angle > kPi - kTouching) {
    throw Error(ErrorKind::kUsage, "an edge of the polygon light passes through the lit point",
                "move it out of the light's plane");
  }
  if (sine == 0) return {from, from, from, 0};
  const Vec3 left = (1 / sine) * normal;
  return {from, cross(left, from), left, angle};
}

/// The integrals of the basis functions along an arc. On it band l is a trigonometric polynomial of degree l.
Sh<double> integrals_along(const Arc& arc, int bands) {
  // Gauss's rule is exact from (bands - 1) angle/4 nodes on, and then at once; a third and 16 more leave nothing above
  // rounding.
  const Quadrature gauss = gauss_legendre(16 + static_cast<int>((bands - 1) * arc.angle / 3), 0, arc.angle);
  Sh<double> sum(bands), y(bands);
  for (std::size_t i = 0; i < gauss.size(); ++i) {
    const double s = gauss.nodes[i];
    basis(bands, std::cos(s) * arc.from + std::sin(s) * arc.ahead, y.values());
    sum += gauss.weights[i] * y;
  }
  return sum;
}

/// d.grad(r^l y_lm) for all m of band l as the combination of band l-1 that it is, added to `out` times `scale`.
/// `lower` holds band l-1. (Hobson 1931, section 79, for our real basis.)
void add_derivative(const Sh<double>& lower, int l, Vec3 d, double scale, Sh<double>& out) {
  const auto y = [&](int m) { return std::abs(m) < l ? lower(l - 1, m) : 0; };
  const double ratio = (2.0 * l + 1) / (2.0 * l - 1), root2 = std::sqrt(2.0);
  for (int m = 0; m <= l; ++m) {
    const double along = std::sqrt(ratio * (l - m) * (l + m));
    const double raise = std::sqrt(ratio * (l - m) * (l - m - 1)) / 2,
                 lower_m = std::sqrt(ratio * (l + m) * (l + m - 1)) / 2;
    if (m == 0) {
      out(l, 0) += scale * (d.z * along * y(0) - root2 * raise * (d.x * y(1) + d.y * y(-1)));
      continue;
    }
    // Between m = 1 and m = 0 stands the sqrt(2) of m > 0; and there is no sine of m = 0.
    const double cosine = m == 1 ? root2 * y(0) : y(m - 1), sine = m == 1 ? 0 : y(-(m - 1));
    out(l, m) += scale * (d.z * along * y(m) + d.x * (lower_m * cosine - raise * y(m + 1)) -
                          d.y * (lower_m * sine + raise * y(-(m + 1))));
    out(l, -m) += scale * (d.z * along * y(-m) + d.x * (lower_m * sine - raise * y(-(m + 1))) +
                           d.y * (lower_m * cosine + raise * y(m + 1)));
  }
}

}  // namespace

double polygon_solid_angle(std::span<const Vec3> vertices) { return std::abs(outline_of(vertices).signed_solid_angle); }

Sh<RgbD> polygon_sh(std::span<const Vec3> vertices, RgbD radiance, int bands) {
  check(bands >= 1, "a light needs at least one band");
  finite(radiance, "the radiance");
  const auto [corners, solid_angle] = outline_of(vertices);
  const double turn = solid_angle < 0 ? -1 : 1;
  Sh<double> shape(bands);
  shape(0, 0) = std::abs(solid_angle) * delta_zonal(1)[0];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Arc arc = arc_between(corners[i], corners[(i + 1) % corners.size()]);
    if (arc.angle == 0 || bands == 1) continue;
    const Sh<double> lower = integrals_along(arc, bands - 1);
    for (int l = 1; l < bands; ++l) add_derivative(lower, l, arc.left, turn / (l * (l + 1.0)), shape);
  }
  return radiance * shape;
}

}  // namespace zonal
