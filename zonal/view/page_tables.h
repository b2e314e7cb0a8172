#pragma once

#include <string>

#include "zonal/io/json_text.h"
#include "zonal/view/page.h"

namespace zonal {

/// All that the page's script works with: tables, shaders, words, and the numbers of light and meshes.
JsonValue view_page_tables(const ViewData&, const ViewPageOptions&);

}  // namespace zonal
