#pragma once

#include <memory>

#include "zonal/light/environment.h"
#include "zonal/math/vec.h"

namespace zonal {

/// Reads an environment between its texels, seamlessly across poles, cube edges and folds. Holds a reference: the
/// environment must outlive it.
class Sampler {
 public:
  explicit Sampler(const Environment&);
  ~Sampler();
  Sampler(Sampler&&) noexcept;

  /// Radiance from a unit direction, interpolated between the nearest texels. Directions that the picture does not show
  /// (outside a fisheye's circle) return the nearest shown texel.
  Rgb operator()(Vec3 toward) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace zonal
