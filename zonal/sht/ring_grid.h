#pragma once

#include <vector>

namespace zonal {

/// A texel of a grid.
struct GridTexel {
  int x = 0, y = 0;
  bool operator==(const GridTexel&) const = default;
};

/// How much a texel of an equirectangular grid counts in an integral over the sphere.
enum class RingWeights {
  kTexelArea,  ///< its solid angle: the map is the sum of its texels, exact for that sum at any number of bands
  kFejer,  ///< Fejér's first rule: exact for the integral of any function of fewer bands than the grid has rows
};

/// An equirectangular grid as rings of constant θ: θ_j = π (j + 1/2) / height, j = 0 at the north pole (+Z).
struct RingGrid {
  int width = 0;
  int height = 0;

  int pairs() const { return (height + 1) / 2; }
  double theta(int ring) const;
  /// Steradians of one texel of each ring; width times their sum is 4π.
  std::vector<double> weights(RingWeights) const;

  /// What the grid takes the constant 1 for: Σ over texels of the weight times y_l0, l = 0..bands-1. The first is
  /// sqrt(4π), the others would be zero if the sum were the integral.
  std::vector<double> response_to_one(RingWeights, int bands) const;
};

}  // namespace zonal
