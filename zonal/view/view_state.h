#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "zonal/math/vec.h"
#include "zonal/view/control.h"
#include "zonal/view/technique.h"

namespace zonal {

/// Where the eye is: on a sphere about the object, looking at it. Angles as in a panorama: yaw from +X toward +Y.
struct OrbitCamera {
  double yaw_deg = 180, pitch_deg = 10;  ///< of the eye seen from the object; pitch in [-89, 89]
  double distance = 3.2;                 ///< in [1.2, 20]
  double fov_deg = 40;                   ///< from bottom to top
};

/// A number of the camera as people and addresses know it.
struct CameraField {
  std::string_view name;   ///< in an address
  std::string_view label;  ///< for people, with its unit
  double OrbitCamera::*value;
  double least, greatest;
};
std::span<const CameraField> camera_fields();

/// Column-major 4 x 4, as the shaders take it.
using Matrix4 = std::array<float, 16>;

struct CameraMatrices {
  Vec3 eye;
  Matrix4 clip_from_world, world_from_clip;
  std::array<float, 9> eye_from_world;  ///< columns first; rows right, up, toward the eye
};
CameraMatrices camera_matrices(const OrbitCamera&, double aspect);

/// All that a viewer is set to. A value, the same in the window, in the page and on the command line.
struct ViewState {
  const Technique* technique = &all_techniques()[0];
  OrbitCamera camera;
  std::string mesh = "sphere";
  std::map<std::string, double, std::less<>> controls;  ///< those that differ from their initial value
  double time_s = 0;  ///< since the viewer was opened, for what moves by itself; in no address

  double value(std::string_view control) const;
  /// Throws Error{kUsage} for an unknown control or a value outside its range.
  void set(std::string_view control, double value);
};

/// The uniform marked_lights: how many of the extracted lights the technique shades by, to be marked by rings and
/// arrows.
int marked_lights(const ViewState&);

/// What the page keeps in its address: "technique=split-sum&roughness=0.4&yaw=30". Every field may be missing.
std::string state_text(const ViewState&);
/// Throws Error{kUsage} naming the field that it does not know or cannot take.
ViewState parse_state(std::string_view text);

}  // namespace zonal
