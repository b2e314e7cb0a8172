#include "apps/zonal/view_picture.h"

#include "zonal/base/error.h"
#ifdef ZONAL_HAS_GL
#include "zonal/gl/context.h"
#include "zonal/gl/scene.h"
#include "zonal/gl/target.h"
#endif

namespace zonal {

#ifdef ZONAL_HAS_GL
struct ViewPainter::Parts {
  OffscreenContext context;
  Scene scene;
};

ViewPainter::ViewPainter(const ViewData& data, const std::string& mesh, const MeshLoadOptions& options, Call& call) {
  const LoadedMesh object = mesh_of(mesh, options, call.run);
  for (const std::string& note : object.notes) call.console.note(note);
  parts_ = std::make_unique<Parts>();
  parts_->scene.set_light(data);
  parts_->scene.set_mesh(object.mesh);
}

Image<Rgb8> ViewPainter::picture(const ViewState& state, ImageSize size) {
  const DrawTarget picture(size.width, size.height, {.texels = TargetTexels::kBytes}),
      samples(size.width, size.height, {.texels = TargetTexels::kBytes, .samples = kEdgeSamples});
  samples.bind();
  parts_->scene.draw(state, size.width, size.height);
  samples.copy_to(picture, 0, size.height);
  return picture.read_bytes();
}

double ViewPainter::difference(const ViewState& state, ImageSize size) {
  return parts_->scene.difference(state, size.width, size.height).rms;
}
#else
struct ViewPainter::Parts {};

ViewPainter::ViewPainter(const ViewData&, const std::string&, const MeshLoadOptions&, Call&) {
  throw Error(ErrorKind::kUsage, "this build has no viewer",
              "install libepoxy-dev and libegl-dev and build again, or write a page: zonal view --html FILE");
}

Image<Rgb8> ViewPainter::picture(const ViewState&, ImageSize) { return {}; }
double ViewPainter::difference(const ViewState&, ImageSize) { return 0; }
#endif

ViewPainter::~ViewPainter() = default;

}  // namespace zonal
