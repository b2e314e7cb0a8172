#pragma once

#include <filesystem>
#include <string>

#include "apps/zonal/call.h"
#include "zonal/view/mesh_file.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// Draws one picture of `size` ("1280x720") without a display and says how far the technique is from the exact answer.
/// Throws Error{kUsage} where this build or this machine has no OpenGL.
void write_screenshot(const ViewData&, const ViewState&, const std::filesystem::path&, const std::string& size,
                      const MeshLoadOptions&, Call&);

}  // namespace zonal
