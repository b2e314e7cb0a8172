#pragma once

#include <string>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"

namespace zonal {

/// The live part of a bake's page: markup with its script, and the style for it. Both empty: none.
struct BakePageViewer {
  std::string html, style;
};

/// Objects in the light of a panorama, drawn by the reader's browser with WebGL 2. About a megabyte. Throws as
/// view_data() does.
BakePageViewer bake_page_viewer(const Environment& panorama, const Run& = {});

}  // namespace zonal
