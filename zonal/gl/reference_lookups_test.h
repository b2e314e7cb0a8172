#pragma once

#include <array>
#include <functional>
#include <vector>

#include "zonal/gl/technique_reference_test.h"
#include "zonal/image/image.h"
#include "zonal/light/lobe.h"

namespace zonal {

// What the references of techniques are made of.

/// 2(n.v)n - v.
Vec3 mirrored(const SurfacePoint&);

/// How the light is turned: about its own +X, then up, then about the vertical.
Rotation light_rotation(const ViewState&);

/// The light turned, as the library turns pictures: what it has at d is what the panorama has at the result.
std::function<Vec3(Vec3)> into_light(const ViewState&);

/// Between the four texels around the place of a direction, across the edges of faces and discs. Where the library's
/// own Sampler finds better weights (at poles and rims) hardware does not.
std::function<RgbD(Vec3)> lookup(Environment);

/// Between the four nearest texels of a flat picture; (0, 0) is its top left corner, (1, 1) the opposite one.
RgbD bilinear(const Image<Rgb>&, double u, double v, bool repeats_x, bool repeats_y);

/// Where a panorama shows a direction, both 0..1.
std::array<double, 2> on_panorama(Vec3 d);

/// A panorama's texels as directions with solid angles.
struct LitTexel {
  Vec3 toward;
  double solid_angle;
  RgbD radiance;
};
std::vector<LitTexel> texels_of(const Environment&);

/// The mean through a lobe, summed over all texels of the panorama, which must outlive the function.
std::function<RgbD(Vec3)> through(const Environment& panorama, const Lobe&);

/// A function of the normal, times `scale`; of the mirrored direction.
PointLight of_normal(const ViewState&, std::function<RgbD(Vec3)> light, double scale);
PointLight of_mirrored(const ViewState&, std::function<RgbD(Vec3)> light);

}  // namespace zonal
