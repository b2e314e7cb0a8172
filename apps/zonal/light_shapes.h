#pragma once

#include <optional>
#include <string>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/sh/sh.h"

namespace zonal {

/// What a user says about a light. Options that only some shapes have are empty until given, so that one given in vain
/// is noticed.
struct LightOptions {
  std::string shape;
  int bands = 3;
  std::string toward;  ///< "X,Y,Z"
  std::optional<double> azimuth_deg, elevation_deg;
  std::optional<double> half_angle_deg;
  std::string center;  ///< "X,Y,Z"
  std::optional<double> radius;
  std::vector<std::string> vertices;         ///< "X,Y,Z" each
  std::string irradiance, radiance, ground;  ///< "R,G,B" or "GREY"
  std::optional<double> turbidity;
  std::string albedo;
  bool no_sun = false;
  bool normalise = false;
};

/// "directional, cone, ... or sky".
std::string light_shape_names();

/// A light, and how it was scaled.
struct Light {
  Sh<RgbD> radiance;
  double normalising_factor = 1;
};

/// Throws Error{kUsage} for a shape that is none, an option the shape does not have or lacks, and what the library
/// refuses.
Light light_of(const LightOptions&, const Run&);

}  // namespace zonal
