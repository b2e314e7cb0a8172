#pragma once

#include <memory>
#include <string>

#include "apps/zonal/call.h"
#include "zonal/image/tonemap.h"
#include "zonal/sphere/projection.h"
#include "zonal/view/mesh_file.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// Draws pictures of one object in one light without a display.
class ViewPainter {
 public:
  /// Notes about the mesh go to the console. Throws Error{kUsage} where this build or this machine has no OpenGL.
  ViewPainter(const ViewData&, const std::string& mesh, const MeshLoadOptions&, Call&);
  ~ViewPainter();
  ViewPainter(const ViewPainter&) = delete;
  ViewPainter& operator=(const ViewPainter&) = delete;

  Image<Rgb8> picture(const ViewState&, ImageSize);
  /// How far the technique is from its exact answer: the RMS over the pixels of the object, over that of the answer.
  double difference(const ViewState&, ImageSize = {320, 180});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace zonal
