#pragma once

#include <vector>

#include "zonal/light/environment.h"
#include "zonal/light/fisheye_means.h"
#include "zonal/light/fisheye_means_kernel.h"
#include "zonal/sphere/disc.h"

namespace zonal {

/// Pixels of a photograph, or of the plane around it, made ready for sums: [box.x0, box.x1) x [box.y0, box.y1).
class FisheyePixels {
 public:
  explicit FisheyePixels(PixelBox);

  const PixelBox& box() const { return box_; }
  void set(int x, int y, Vec3 toward, double weight, RgbD radiance);
  /// Row y from x on.
  LobePixels row(int x, int y) const;

 private:
  std::size_t index(int x, int y) const;

  PixelBox box_;
  std::vector<float> x_, y_, z_, weight_, r_, g_, b_;
};

/// The circle of a fisheye photograph, with the defaults filled in. Throws Error{kUsage} for another layout or an
/// impossible lens.
PixelCircle fisheye_circle(const Environment& photograph);
/// Throws Error{kUsage} unless the lens is equidistant and sees 180 degrees: what the published program is made for.
void require_equidistant_half_sphere(const Environment& photograph);

/// The pixels of a box of the plane in which the lens's law goes on beyond the circle, as the published program has
/// them: angles from the zenith of π/2 for each radius, the ground outside of the circle (and of the picture).
/// `by_solid_angle`: weighed by sin(T)/T, else all alike.
FisheyePixels pixels_of_plane(const Environment& photograph, const PixelCircle&, PixelBox, Rgb ground,
                              bool by_solid_angle);
/// The pixels that show the sky, weighed by exact solid angles in steradians; or all alike.
FisheyePixels pixels_of_sky(const Environment& photograph, bool by_solid_angle);

/// max(c, 0)^exponent, times the published sin(a)/a with a = acos(c) or not. Throws Error{kUsage} for an exponent
/// outside [0, 1e4].
class FisheyeLobe {
 public:
  FisheyeLobe(double exponent, bool by_angle_to_lobe);
  LobeShape shape() const;

 private:
  double exponent_;
  std::vector<float> factor_;
};

struct LobeSum {
  RgbD light;
  double weight = 0;
};
/// Over the pixels of a window inside the box, row by row.
LobeSum lobe_sum(const FisheyePixels&, const PixelBox& window, const FisheyeLobe&, Vec3 toward, Isa);

}  // namespace zonal
