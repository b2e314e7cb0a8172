#pragma once

#include <string>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/view/technique.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// How long the parts of a turn took, in milliseconds.
struct LiveTimes {
  double turn = 0;     ///< of the panorama's pixels
  double project = 0;  ///< onto six bands
  double derive = 0;   ///< all that follows from these: shader constants, an ambient cube, lights
  double filter = 0;   ///< with the lobes of the settings
  double all() const { return turn + project + derive + filter; }
};

/// The light turned for real: not looked up in another direction, but its pixels turned, projected and filtered anew.
struct LiveLight {
  ViewData data;              ///< what one technique and the background look up
  Rotation world_from_light;  ///< how its pixels are turned
  LiveTimes times;
};

/// The textures and uniforms of the data that the shaders of a technique and of the background look at.
std::vector<std::string> names_used(const Technique&, const ViewData&);

/// Whether everything that is used is among what live_light() makes, or does not turn with the light.
bool can_be_live(const std::vector<std::string>& used, const ViewData& whole);

/// `whole` is what view_data() gave for the light before it was turned; its technique, turn, roughness and shininess
/// are those of `state`. Filtered maps have one level, made for exactly this roughness and shininess. Throws
/// Error{kCancelled}.
LiveLight live_light(const ViewData& whole, const std::vector<std::string>& used, const ViewState& state,
                     const Run& = {});

}  // namespace zonal
