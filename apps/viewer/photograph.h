#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/tonemap.h"
#include "zonal/light/environment.h"
#include "zonal/light/resample.h"
#include "zonal/sphere/disc.h"

namespace zonal {

/// A picture, and how it becomes the light from everywhere.
struct LightPicture {
  // NOLINTNEXTLINE(google-explicit-constructor): a picture that says all about itself is one
  LightPicture(Environment said, ResampleOptions filling = {}, bool is_known = true)
      : picture(std::move(said)), whole(filling), layout_is_known(is_known) {}

  Environment picture;
  ResampleOptions whole;
  bool layout_is_known;  ///< if not, its projection says nothing
};

/// Gives the light to look at; runs in the background.
using LightLoader = std::function<LightPicture(const Run&)>;

/// One picture, or those that load_environment() takes together. A lone picture may have a layout that nobody can
/// guess.
LightPicture load_light_picture(const std::vector<std::filesystem::path>&, const Run&);

/// What a person says about a picture that may be a fisheye photograph.
struct PhotographSettings {
  bool is_fisheye = false;
  LensModel lens = LensModel::kEquidistant;
  double fov_deg = 180;
  PixelCircle circle;
  bool ground_is_rim = true;  ///< the mean along the rim lies below; else `ground` does
  Rgb ground = {0.2f, 0.2f, 0.2f};
};

/// The picture that the light is made of, with what was said about it. The picture stays in memory, so that another
/// circle does not wait for a file.
struct Photograph {
  std::string name;
  std::shared_ptr<const LightPicture> picture;
  std::shared_ptr<const Image<Rgb8>> small;  ///< of it, for a screen
  PhotographSettings said;                   ///< by the person
  PhotographSettings applied;                ///< what the light was made of

  ImageSize size() const { return {picture->picture.radiance.width(), picture->picture.radiance.height()}; }
  /// Whether a light can be made of it: its layout is known, or said to be a fisheye's.
  bool tells_light() const { return said.is_fisheye || picture->layout_is_known; }
};

/// The settings that its projection and its filling mean.
Photograph photograph_of(std::string name, LightPicture);

/// A panorama of so many rows as the photograph's settings say. Throws Error{kUsage} where the lens is impossible, what
/// resample() throws.
Environment light_of(const Photograph&, int rows, const Run&);

}  // namespace zonal
