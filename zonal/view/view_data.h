#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/image.h"
#include "zonal/io/ktx2.h"
#include "zonal/light/environment.h"

namespace zonal {

/// A texture of the shaders by the name of its sampler. Linear filtering, trilinear where it has levels.
struct ViewTexture {
  std::string name;
  TextureShape shape = TextureShape::kPicture;
  bool repeats_x = false;               ///< 2D: from left to right; else the edge goes on
  bool repeats_y = false;               ///< 2D: from top to bottom
  bool table = false;                   ///< numbers rather than light: wants more than nine bits
  std::vector<Image<Rgb>> levels = {};  ///< each half of the last; cubes as stacks of six faces +X -X +Y -Y +Z -Z
};

/// A uniform array of vectors of `components` floats.
struct ViewUniform {
  std::string name;
  int components = 3;
  std::vector<float> values;
};

/// All that the shaders know about the light: computed here, so that they hold no number of lighting themselves.
struct ViewData {
  std::vector<ViewTexture> textures;
  std::vector<ViewUniform> uniforms;
  double exposure_ev = 0;  ///< at which the panorama looks well
  double unit = 1;         ///< radiance that 1 stands for: a power of two by which a sun fits into half floats
};

/// Sizes, in the natural unit of each layout.
struct ViewDataOptions {
  int panorama_px = 256;    ///< rows
  int cube_px = 128;        ///< faces of the cube map; the ball and paraboloid maps are twice that
  int chain_px = 128;       ///< faces of the sharpest filtered level
  int irradiance_px = 32;   ///< faces
  int sky_px = 32;          ///< paraboloid maps of the fisheye program
  int reference_rows = 64;  ///< of the small panorama that the slow exact answers sum over
};

/// Throws Error{kInput} for values that are not finite, Error{kCancelled}.
ViewData view_data(const Environment&, const ViewDataOptions& = {}, const Run& = {});

}  // namespace zonal
