#pragma once

#include <functional>
#include <optional>
#include <string>

#include "apps/zonal/call.h"
#include "zonal/light/environment.h"
#include "zonal/view/mesh_file.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// Opens the desktop viewer and returns when it is closed. `light` runs in the background of the window. Throws
/// Error{kUsage} where this build or this machine has no window.
void open_view_window(const ViewState&, std::string light_name, std::function<Environment(const Run&)> light,
                      const MeshLoadOptions&, std::optional<Image<Rgb>> highlight, Call&);

}  // namespace zonal
