#pragma once

#include <functional>
#include <span>

namespace zonal {

/// A function of several numbers: its value at x, and its gradient into `slopes`.
using SlopedFunction = std::function<double(std::span<const double> x, std::span<double> slopes)>;

struct MinimiseOptions {
  double flat = 1e-13;  ///< length of the gradient that counts as none, for x of length 1 or less
  int max_steps = 300;
};

/// Moves x downhill to where the function is flat, or no step leads lower any more. A local search: the value never
/// grows. The first step has length 1 at most, so x is best scaled to what it may move by. O(steps * x.size()^2) beside
/// the function's own time. BFGS (Nocedal & Wright 2006, section 6.1) with the line search of Lewis & Overton 2013,
/// which asks nothing of the second derivative: kinks, as bounds make them, do not stop it.
void minimise(const SlopedFunction&, std::span<double> x, const MinimiseOptions& = {});

}  // namespace zonal
