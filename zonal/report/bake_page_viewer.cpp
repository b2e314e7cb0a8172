#include "zonal/report/bake_page_viewer.h"

#include "zonal/base/check.h"
#include "zonal/view/page.h"

namespace zonal {

BakePageViewer bake_page_viewer(const Environment& panorama, const Run& run) {
  // A quarter of the texels of a page that is nothing but a viewer.
  const ViewData light = view_data(panorama, {.panorama_px = 128, .cube_px = 64, .chain_px = 64, .sky_px = 16}, run);
  ViewState state;
  state.technique = technique_named("split-sum");  // what a bake is for
  check(state.technique != nullptr, "the viewer opens with a technique that it has");
  ViewSection section = view_section(light, {.state = state, .embedded = true});
  return {std::move(section.html), std::move(section.style)};
}

}  // namespace zonal
