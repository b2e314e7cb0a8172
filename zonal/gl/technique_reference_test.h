#pragma once

#include <functional>
#include <string>

#include "zonal/light/environment.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// A point of a surface as the shaders see it, the light not yet turned.
struct SurfacePoint {
  Vec3 position, normal, toward_eye;
  double u = 0, v = 0;
};

/// An environment without any symmetry: the labelled axes, a slope, and a coloured lamp off every axis.
Environment lopsided_environment(int rows);

/// A highlight of a person's own: two strokes of a brush.
Image<Rgb> painted_highlight();

/// Sizes small enough for sums over all texels for each pixel.
ViewDataOptions small_view_data();

/// The light of a technique on a point as the library's own verbs give it, from the environment and not from
/// view_data(). The environment must be a panorama of small_view_data().panorama_px rows and outlive the function.
using PointLight = std::function<RgbD(const SurfacePoint&)>;
PointLight technique_reference(const Environment&, const ViewState&);
/// The same for the exact answer.
PointLight exact_reference(const Environment&, const ViewState&);

}  // namespace zonal
