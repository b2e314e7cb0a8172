#pragma once

#include <string>

#include "zonal/io/json_text.h"
#include "zonal/view/page.h"

namespace zonal {

/// What the page's script works with.
struct ViewPageTables {
  JsonValue tables;     ///< names, words, shaders, where in the bytes the numbers of light and meshes are
  std::string opening;  ///< packed_text() of the bytes, as far as the first picture needs them
  std::string rest;     ///< and of those that follow
};
ViewPageTables view_page_tables(const ViewData&, const ViewPageOptions&);

}  // namespace zonal
