#pragma once

#include "zonal/io/json_text.h"
#include "zonal/view/page_bytes.h"
#include "zonal/view/view_data.h"

namespace zonal {

/// The light of a page: less than the window takes, so that the page stays under 3 MB for any panorama.
ViewDataOptions view_page_data_options();

/// What a page knows of its light: "textures", "uniforms", "exposure_ev" at which it opens, and "cut_off", a sentence
/// about light above kRgb9e5Max or "". Their numbers go into the bytes: texels as rgb9e5() or, in tables, as halves;
/// the others as floats, by [where they begin, how many].
JsonValue::Object light_tables(const ViewData&, PageBytes&);

}  // namespace zonal
