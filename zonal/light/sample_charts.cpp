#include "zonal/light/sample_charts.h"

namespace zonal {

SmoothCharts::SmoothCharts(const Projection& p, ImageSize size) {
  const bool lens = p.layout == Layout::kFisheye || p.layout == Layout::kDualFisheye;
  const bool ball = p.layout == Layout::kMirrorBall || p.layout == Layout::kSphereMap;
  if (ball || (lens && p.lens.model == LensModel::kOrthographic)) {
    // Near the rim the angle goes like the square root of the distance from it. A cubic k texels from it is off by
    // about 0.02 sqrt(spacing) k^-3.5 of a linear function: 1e-5 at six texels of a disc of 512.
    margin_ = 6;
  }
  if (p.layout == Layout::kOctahedralEqualArea) {
    // Around the poles azimuth is linear along a diamond, a cone's tip: a cubic k texels away is off by about
    // 0.1 spacing k^-3, so the creases through the tip are kept further away there.
    margin_ = 1;
    pole_margin_ = 6;
    const double radius = 16 * 2.0 / size.width;  // in the diamond's norm; |z| = 1 - radius²
    cos_pole_ = 1 - radius * radius;
  }
}

}  // namespace zonal
