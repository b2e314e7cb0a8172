#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "zonal/math/vec.h"

namespace zonal {

/// One light far away: a uniform disc, or with half_angle 0 a single direction.
struct FileLight {
  Vec3 direction;               ///< unit, toward the light
  RgbD irradiance;              ///< on a receiver that faces it
  double half_angle = 0;        ///< radians, 0 to pi
  std::optional<double> share;  ///< of the energy of the light it was taken from, where that is known; finite

  bool operator==(const FileLight&) const = default;
};

/// Lights and what shines beside them: the value of a file of lights. In the world frame (right-handed, +Z up, +X the
/// centre of a panorama).
struct LightsFile {
  std::optional<RgbD> ambient;  ///< radiance of a constant light beside them; none where another file holds the rest
  std::vector<FileLight> lights;

  bool operator==(const LightsFile&) const = default;
};

/// Degrees from +X toward +Y, (-180, 180]; 0 straight up and straight down.
double azimuth_deg(Vec3 toward);
/// Degrees above the plane of X and Y, [-90, 90].
double elevation_deg(Vec3 toward);
/// Of a disc, in steradians: 2 pi (1 - cos half_angle).
double disc_solid_angle(double half_angle);
/// The radiance of the disc that gives this irradiance to a receiver that faces it: E / (pi sin² half_angle), E / pi
/// from a right angle on. half_angle > 0.
RgbD disc_radiance(RgbD irradiance, double half_angle);

/// {"format":"zonal-lights","version":1,"frame":"z-up-right-handed","azimuth":"from +X toward +Y",
/// "ambient_radiance":[r,g,b] or null,"lights":[{"direction":[x,y,z],"azimuth_deg":...,"elevation_deg":...,
/// "half_angle_deg":...,"solid_angle_sr":...,"irradiance":[r,g,b],"radiance":[r,g,b] or null for half_angle 0,"share":
/// number or null},...]}, in the shortest decimals that read back as the same doubles. Throws Error{kInput} where a
/// value is not finite or out of its domain, and where the radiance would be.
std::string lights_json_text(const LightsFile&);

/// Reads that schema and no other: every field must be there, once, with a value that is known, and nothing else. What
/// is said twice (the direction in degrees, solid angle, radiance) must agree to 1e-6. At most 65536 lights. Throws
/// Error{kInput} that names the field. Angles may differ by one rounding from those written.
LightsFile parse_lights_json(std::string_view text);

}  // namespace zonal
