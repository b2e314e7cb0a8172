#pragma once

#include <vector>

#include "zonal/math/vec.h"

namespace zonal {

/// Where a GGX lobe really points. A rough surface seen at an angle does not reflect about the mirrored direction r:
/// the mean direction of the light that it sends to the eye, weighted by D V n.l (Heitz 2014's masking), leans from r
/// toward the normal, at a grazing angle by almost all of the way where alpha is 1 ("off-specular peak", Torrance &
/// Sparrow 1967). A table over the angle of the eye, made when constructed (O(1e5) lobe values); angles in radians,
/// from the normal, and good to 2e-3 (3e-3 beyond 80 degrees).
class LobeLean {
 public:
  /// alpha in [1e-4, 1], else Error{kUsage}.
  explicit LobeLean(double alpha);

  /// From r toward the normal, for an eye `theta` from the normal; in [0, theta]. Beyond kSteepest as there.
  double lean(double theta) const;
  /// The mean direction of the lobe for an eye and a normal, unit vectors.
  Vec3 mean(Vec3 view, Vec3 normal) const;
  /// The normal whose lobe has this mean direction for the eye. Where none has, the one that the eye sees at kSteepest,
  /// in the plane of both.
  Vec3 normal(Vec3 view, Vec3 mean) const;

  static constexpr double kSteepest = 1.52;  ///< n.v of 0.05

 private:
  std::vector<double> leans_;  // at equal steps of theta from 0 to kSteepest
};

}  // namespace zonal
