#pragma once

#include <functional>
#include <optional>
#include <string>

#include "apps/zonal/call.h"
#include "zonal/light/environment.h"
#include "zonal/light/resample.h"
#include "zonal/view/mesh_file.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// A picture as it was read, and how it becomes the light from everywhere.
struct ViewLight {
  Environment picture;
  ResampleOptions whole;
};

/// Opens the desktop viewer and returns when it is closed. `light` runs in the background of the window. Throws
/// Error{kUsage} where this build or this machine has no window.
void open_view_window(const ViewState&, std::string light_name, std::function<ViewLight(const Run&)> light,
                      const MeshLoadOptions&, std::optional<Image<Rgb>> highlight, Call&);

}  // namespace zonal
