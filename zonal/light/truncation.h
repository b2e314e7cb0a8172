#pragma once

#include <vector>

#include "zonal/light/lobe.h"

namespace zonal {

/// What is left of a lobe's kernel after its first bands: e(c) = k(c) - Σ_{l < bands} (2l+1)/4π λ_l P_l(c), on rings of
/// equal width in angle. A convolution cut there is wrong in direction d by Σ f(s) e(d·s), so |e| and the distribution
/// of f bound it.
class Truncation {
 public:
  /// Follows the series up to `max_bands`; O(rings * bands), eight rings for each half wave of the last band.
  Truncation(const Lobe& lobe, int max_bands);

  int bands() const { return bands_; }
  int max_bands() const { return static_cast<int>(factors_.size()); }
  /// Goes on to this many bands, at least as many as so far.
  void extend(int bands);

  std::vector<double> errors() const;                                        ///< |e| on each ring, 1/sr
  const std::vector<double>& solid_angles() const { return solid_angles_; }  ///< of each ring, steradians

 private:
  std::vector<double> factors_;
  std::vector<double> cosines_, solid_angles_;
  std::vector<double> remainder_;          // e so far
  std::vector<double> legendre_, before_;  // P_l and P_{l-1} on each ring
  int bands_ = 0;
};

}  // namespace zonal
