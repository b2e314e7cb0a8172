#include "apps/zonal/view_window.h"

#include "zonal/base/error.h"
#ifdef ZONAL_HAS_WINDOW
#include "apps/viewer/viewer_window.h"
#endif

namespace zonal {

#ifdef ZONAL_HAS_WINDOW
void open_view_window(const ViewState& state, std::string light_name, std::function<ViewLight(const Run&)> light,
                      const MeshLoadOptions& mesh, std::optional<Image<Rgb>> highlight, Call& call) {
  const auto picture = [light = std::move(light)](const Run& run) {
    ViewLight read = light(run);
    return LightPicture(std::move(read.picture), read.whole);
  };
  run_viewer({state, picture, std::move(light_name), mesh, call.run, std::move(highlight)}, call.run);
}
#else
void open_view_window(const ViewState&, std::string, std::function<ViewLight(const Run&)>, const MeshLoadOptions&,
                      std::optional<Image<Rgb>>, Call&) {
  throw Error(
      ErrorKind::kUsage, "this build opens no window",
      "install libglfw3-dev and libimgui-dev and build again; --screenshot draws a picture, --html writes a page");
}
#endif

}  // namespace zonal
