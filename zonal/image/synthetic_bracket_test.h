#pragma once

#include <functional>
#include <vector>

#include "zonal/image/exposures.h"

/// Photographs of known scenes by known cameras, for the tests of everything about brackets.
namespace zonal::sample {

/// A camera: how exposure (radiance times seconds) becomes an encoded value 0..1 (cut there), and its noise.
struct Camera {
  std::function<double(double exposure)> encode;
  double noise_codes = 0;  ///< standard deviation, in codes of 255
  int bits = 8;
  unsigned seed = 1;
};

double srgb_camera(double exposure);
double gamma_camera(double exposure);  ///< power 1/2.2
/// Film-like: an S on a logarithmic axis with a toe and a shoulder.
double film_camera(double exposure);

/// Radiance over four decades around 1: smooth slopes, soft spots and hard-edged blocks. `offset` moves what is seen,
/// in texels: scene(w, h, {dx, dy})(x, y) == scene(w, h)(x + dx, y + dy).
Image<Rgb> scene(int width, int height, Shift offset = {});

/// The same scene by a camera that moved and turned: what lies at p of placed_scene(w, h, placement) lies at the placed
/// point of the scene. Texels gather the light of their area, as a sensor does.
Image<Rgb> placed_scene(int width, int height, const Placement&);

/// What the camera makes of radiance, as an encoded picture.
Image<Rgb> photograph(const Image<Rgb>& radiance, const Camera&, double seconds);

/// An arranged bracket of one scene.
Exposures bracket(const Image<Rgb>& radiance, const Camera&, const std::vector<double>& seconds);

/// Nine exposures two stops apart around 1 s, and five three stops apart: none of the scene is lost in either.
std::vector<double> nine_times();
std::vector<double> five_times();
/// Nine over the same range in uneven steps. Even steps of k stops leave a curve free up to a factor that repeats every
/// k stops (Grossberg & Nayar 2003), unless it is asked to be smooth.
std::vector<double> uneven_times();

}  // namespace zonal::sample
