#pragma once

#include <array>
#include <optional>

#include "zonal/light/environment.h"
#include "zonal/light/sample_solve.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

/// What lies behind a mirrored ball. The whole rim of its picture shows one direction, and the outermost texels
/// surround it at a few degrees: inside that ring the radiance is the linear function that fits the ring's texels best,
/// kept within an eighth of their range.
class BlindSpot {
 public:
  /// nullopt: the projection has none.
  static std::optional<BlindSpot> of(const Environment&, const Mapping&);

  /// 1 well inside the ring, falling to 0 from three quarters of its radius to the ring.
  double weight(Vec3 toward) const;
  Rgb radiance(Vec3 toward) const;

 private:
  LinearColumn basis(Vec3 toward) const;

  Vec3 axis_, side_, up_;
  double radius_ = 0;                      // of the ring, as a chord
  std::array<LinearColumn, 3> channel_{};  // of the fit
  Rgb low_, high_;                         // what it may return
};

}  // namespace zonal
