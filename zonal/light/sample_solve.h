#pragma once

#include <array>
#include <span>

#include "zonal/math/vec.h"

namespace zonal {

/// The 4 x 4 texels around a direction where no smooth chart holds them all: at cube edges, folds, creases, rims.
inline constexpr int kPatch = 16;

/// Functions of direction that are linear: a constant and three slopes.
inline constexpr int kLinear = 4;
using LinearColumn = std::array<double, kLinear>;

/// Solves a symmetric positive semidefinite system of which the lower triangle is given. An equation that follows from
/// the ones before it is left out: its unknown is 0.
LinearColumn solve_semidefinite(std::array<LinearColumn, kLinear> lower, LinearColumn right);

/// A correction to `start` (weights that sum to 1) after which Σ w = 1 and Σ w toward_k = toward: every linear function
/// of direction is then interpolated exactly, every smooth one to second order. Of all corrections the smallest, where
/// texels with a large `ease` move first (minimum of Σ c²/ease). A constraint that the texels cannot meet is left out.
std::array<double, kPatch> linear_correction(Vec3 toward, std::span<const Vec3, kPatch> texels,
                                             std::span<const double, kPatch> start,
                                             std::span<const double, kPatch> ease);

}  // namespace zonal
