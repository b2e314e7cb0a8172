#pragma once

#include <limits>

#include "zonal/sh/sh.h"

namespace zonal {

/// The deepest value of a function and how much deeper it could still be.
struct Minimum {
  Vec3 direction;
  double found = 0;       ///< the value there
  double guaranteed = 0;  ///< no value anywhere is below this
  int evaluations = 0;
};

struct MinimumOptions {
  /// Search until found - guaranteed is at most this, in the units of the function; above 0.
  double tolerance = 1e-6;
  /// Stop as soon as a value below this is found: enough for the question whether there is one.
  double enough = -std::numeric_limits<double>::infinity();
  /// Stop then at the latest; the guarantee is weaker, and still true.
  int max_evaluations = 1 << 20;
};

/// Branch and bound. A cell of the sphere with radius r has no value below the least one that the value, slope and
/// curvatures at its centre allow within r, less derivative_bound(f, 3) r^3/6; the cell with the least bound is cut in
/// four until no bound lies more than the tolerance below the least value seen. Nothing is assumed about the function:
/// `guaranteed` is true up to rounding, and that is allowed for. For 1..300 bands; some thousand evaluations for a few
/// bands. Throws Error{kInput} when a coefficient is not finite.
Minimum certified_minimum(const Sh<double>&, const MinimumOptions& = {});

}  // namespace zonal
