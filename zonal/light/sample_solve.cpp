#include "zonal/light/sample_solve.h"

#include <cmath>

namespace zonal {

LinearColumn solve_semidefinite(std::array<LinearColumn, kLinear> m, LinearColumn right) {
  // Cholesky's method in place.
  // Pivots below this part of the diagonal are rounding: the rows are scaled to size one.
  constexpr double kVanishing = 1e-9;
  std::array<bool, kLinear> kept{};
  for (int i = 0; i < kLinear; ++i) {
    const double diagonal = m[i][i];
    for (int k = 0; k < i; ++k) {
      if (!kept[k]) continue;
      for (int j = 0; j < k; ++j) {
        if (kept[j]) m[i][k] -= m[i][j] * m[k][j];
      }
      m[i][k] /= m[k][k];
      m[i][i] -= m[i][k] * m[i][k];
    }
    kept[i] = m[i][i] > kVanishing * diagonal;
    if (kept[i]) m[i][i] = std::sqrt(m[i][i]);
  }
  LinearColumn x{};
  for (int i = 0; i < kLinear; ++i) {
    if (!kept[i]) continue;
    double sum = right[i];
    for (int k = 0; k < i; ++k) sum -= kept[k] ? m[i][k] * x[k] : 0;
    x[i] = sum / m[i][i];
  }
  for (int i = kLinear - 1; i >= 0; --i) {
    if (!kept[i]) continue;
    double sum = x[i];
    for (int k = i + 1; k < kLinear; ++k) sum -= kept[k] ? m[k][i] * x[k] : 0;
    x[i] = sum / m[i][i];
  }
  return x;
}

std::array<double, kPatch> linear_correction(Vec3 toward, std::span<const Vec3, kPatch> texels,
                                             std::span<const double, kPatch> start,
                                             std::span<const double, kPatch> ease) {
  // Offsets in a frame at `toward`: two tangents, and how far the chord falls below the tangent plane, which is of the
  // square of the spacing. Dividing by the spacing makes all constraints of size one.
  const Vec3 side = std::abs(toward.z) < 0.5 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 t1 = normalize(cross(side, toward)), t2 = cross(toward, t1);
  double spread = 0;
  for (const Vec3& texel : texels) spread += dot(texel - toward, texel - toward);
  const double spacing_squared = spread / kPatch, spacing = std::sqrt(spacing_squared);

  std::array<double, kPatch> correction{};
  if (!(spacing > 0)) return correction;
  std::array<LinearColumn, kPatch> rows;
  std::array<LinearColumn, kLinear> normal{};
  LinearColumn miss{0, 0, 0, 0};
  for (int k = 0; k < kPatch; ++k) {
    const Vec3 offset = texels[k] - toward;
    rows[k] = {1, dot(offset, t1) / spacing, dot(offset, t2) / spacing, -dot(offset, toward) / spacing_squared};
    for (int i = 0; i < kLinear; ++i) {
      if (i > 0) miss[i] -= start[k] * rows[k][i];
      for (int j = 0; j <= i; ++j) normal[i][j] += ease[k] * rows[k][i] * rows[k][j];
    }
  }
  const LinearColumn multipliers = solve_semidefinite(normal, miss);
  for (int k = 0; k < kPatch; ++k) {
    double sum = 0;
    for (int i = 0; i < kLinear; ++i) sum += multipliers[i] * rows[k][i];
    correction[k] = ease[k] * sum;
  }
  return correction;
}

}  // namespace zonal
