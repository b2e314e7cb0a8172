#include "apps/zonal/view_window.h"

#include "zonal/base/error.h"
#ifdef ZONAL_HAS_WINDOW
#include "apps/viewer/viewer_window.h"
#endif

namespace zonal {

#ifdef ZONAL_HAS_WINDOW
void open_view_window(const ViewState& state, std::string light_name, std::function<Environment(const Run&)> light,
                      const MeshLoadOptions& mesh, std::optional<Image<Rgb>> highlight, Call& call) {
  run_viewer({state, std::move(light), std::move(light_name), mesh, call.run, std::move(highlight)}, call.run);
}
#else
void open_view_window(const ViewState&, std::string, std::function<Environment(const Run&)>, const MeshLoadOptions&,
                      std::optional<Image<Rgb>>, Call&) {
  throw Error(
      ErrorKind::kUsage, "this build opens no window",
      "install libglfw3-dev and libimgui-dev and build again; --screenshot draws a picture, --html writes a page");
}
#endif

}  // namespace zonal
