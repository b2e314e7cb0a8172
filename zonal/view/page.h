#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "zonal/view/light_tables.h"
#include "zonal/view/mesh.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// What goes into a page beside the light.
struct ViewPageOptions {
  std::string title = "Zonal view";
  std::string subtitle = {};
  ViewState state = {};  ///< how it opens; the exposure is the light's own where the state says nothing
  std::vector<std::pair<std::string, Mesh>> meshes = {};  ///< by name, beyond the shapes without a file; uv in 0..1
  /// The library for browsers (apps/web, a WebAssembly module): with it, a page of its own takes any panorama. Alive
  /// until the page is written.
  std::span<const std::byte> module = {};
  std::string_view notices = {};  ///< what goes beside the module as a comment: no two hyphens in a row
  bool embedded = false;          ///< in a page of others: no title of its own, and nothing is kept in the address
};

/// A self-contained page that draws with WebGL2: no network, nothing beside it. All techniques and controls of the
/// tables; its address keeps the settings by the names of view_state.h. Light above kRgb9e5Max is cut off, and the page
/// says so. Throws Error{kUsage} when the state names an object that the page does not have.
std::string view_page_html(const ViewData&, const ViewPageOptions& = {});

/// The same for a page of others, which has to allow inline script and style: the style, and what goes where the viewer
/// is to be. The style uses the variables --paper, --ink, --quiet, --rule, --shade, --accent.
struct ViewSection {
  std::string style, html;
};
ViewSection view_section(const ViewData&, ViewPageOptions);

}  // namespace zonal
