#include "apps/viewer/photograph.h"

#include <algorithm>

#include "apps/viewer/circle_drag.h"
#include "zonal/base/check.h"
#include "zonal/image/block_means.h"
#include "zonal/io/environment_file.h"
#include "zonal/light/fisheye_pixels.h"

namespace zonal {
namespace {

constexpr int kSmallEdge = 512;  // pixels of the copy, at most

bool is_fisheye(const LightPicture& picture) {
  return picture.layout_is_known && picture.picture.projection.layout == Layout::kFisheye;
}

Image<Rgb8> small_copy(const Image<Rgb>& picture) {
  const int longest = std::max(picture.width(), picture.height());
  const Image<Rgb> copy = block_means(picture, (longest + kSmallEdge - 1) / kSmallEdge);
  return tonemap(copy, {.exposure_ev = auto_exposure_ev(copy)});
}

/// The circle of the lens; of another layout the largest one in its middle.
PixelCircle circle_of(const LightPicture& picture) {
  if (is_fisheye(picture)) return fisheye_circle(picture.picture);
  const double width = picture.picture.radiance.width(), height = picture.picture.radiance.height();
  const double radius = std::min(width, height) / 2;
  return {width / 2, height / 2, radius, radius};
}

Projection projection_of(const Photograph& photograph) {
  const PhotographSettings& said = photograph.said;
  if (!said.is_fisheye) return photograph.picture->picture.projection;
  const PixelCircle circle = limited_circle(said.circle, photograph.size());
  return {Layout::kFisheye,
          {said.lens, said.fov_deg, circle.center_x, circle.center_y, circle.radius_x, circle.radius_y}};
}

}  // namespace

LightPicture load_light_picture(const std::vector<std::filesystem::path>& paths, const Run& run) {
  std::error_code ignored;
  if (paths.size() != 1) return load_environment(paths, {}, run).environment;
  if (std::filesystem::is_directory(paths[0], ignored)) return load_environment(paths[0], {}, run).environment;
  Image<Rgb> pixels = load_picture(paths[0], {}, run).pixels;
  const std::optional<Guess> guess = guess_projection({pixels.width(), pixels.height()}, paths[0].filename().string());
  const Projection projection = guess ? guess->projection : Projection{Layout::kFisheye};
  return {{std::move(pixels), projection}, {}, guess.has_value()};
}

Photograph photograph_of(std::string name, LightPicture light) {
  PhotographSettings said;
  said.is_fisheye = is_fisheye(light);
  if (said.is_fisheye) {
    said.lens = light.picture.projection.lens.model;
    said.fov_deg = light.picture.projection.lens.fov_deg;
  }
  said.circle = circle_of(light);
  if (light.whole.uncovered == Uncovered::kConstant) {
    said.ground_is_rim = false;
    said.ground = light.whole.ground;
  }
  auto small = std::make_shared<const Image<Rgb8>>(small_copy(light.picture.radiance));
  return {std::move(name), std::make_shared<const LightPicture>(std::move(light)), std::move(small), said, said};
}

Environment light_of(const Photograph& photograph, int rows, const Run& run) {
  check(photograph.tells_light(), "a light is made of a picture whose layout is known");
  const LightPicture& light = *photograph.picture;
  ResampleOptions whole = light.whole;
  if (photograph.said.is_fisheye && !photograph.said.ground_is_rim) {
    whole.uncovered = Uncovered::kConstant;
    whole.ground = photograph.said.ground;
  } else if (photograph.said.is_fisheye && whole.uncovered == Uncovered::kConstant) {
    whole.uncovered = Uncovered::kRimMean;
  }
  const Projection projection = projection_of(photograph);
  const Projection panorama = {Layout::kEquirect};
  if (projection == light.picture.projection) return resample(light.picture, panorama, rows, whole, run);
  return resample({light.picture.radiance, projection}, panorama, rows, whole, run);
}

}  // namespace zonal
