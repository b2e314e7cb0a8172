#pragma once

#include <filesystem>
#include <string>

#include "apps/zonal/call.h"
#include "zonal/view/mesh_file.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// Draws every technique in one SVG, without a display: its left half, the exact answer's right half, and the number
/// of their difference. The settings are those of the state. Throws Error{kUsage} where this build or this machine has
/// no OpenGL.
void write_view_sheet(const ViewData&, ViewState, const std::filesystem::path&, const MeshLoadOptions&,
                      const std::string& light_name, Call&);

}  // namespace zonal
