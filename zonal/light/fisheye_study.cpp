#include "zonal/light/fisheye_study.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "zonal/image/block_means.h"
#include "zonal/image/color.h"
#include "zonal/light/fisheye_means.h"
#include "zonal/light/fisheye_pixels.h"
#include "zonal/light/resample.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr int kErrorGrid = 33;  // the errors are smooth, and so many directions tell them to a few per cent
constexpr Projection kPanorama = {Layout::kEquirect}, kCube = {Layout::kCubeStack};

ImageSize panorama_size(int size_px) { return image_size(Layout::kEquirect, size_px); }
ImageSize cube_size(int size_px) { return image_size(Layout::kCubeStack, std::max(1, size_px / 2)); }

std::vector<Vec3> directions_above_horizon() {
  std::vector<Vec3> all = published_paraboloid_directions(kErrorGrid);
  std::erase_if(all, [](const Vec3& q) { return !(q.z > 0); });
  return all;
}

FisheyeError error_of(const std::vector<RgbD>& got, const std::vector<RgbD>& exact) {
  double sum = 0, most = 0, full = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const RgbD d = got[i] - exact[i];
    sum += d.r * d.r + d.g * d.g + d.b * d.b;
    most = std::max({most, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
    full = std::max(full, max_channel(exact[i]));
  }
  if (full <= 0) return {};  // a black sky over black ground
  return {std::sqrt(sum / (3 * static_cast<double>(exact.size()))) / full, most / full};
}

/// The corrected map as it is computed against the direct sums, at the texel centres of our own paraboloid.
FisheyeError error_of_library(const FisheyeLight& light, int i, const Environment& photograph,
                              const FisheyeMeansOptions& exact, const Run& run) {
  const Projection projection = sky_paraboloid(kErrorGrid, false);
  const ImageSize size{kErrorGrid, kErrorGrid};
  const Environment map = light.render(i, projection, size, run).map;
  const Mapping mapping(projection, size);
  std::vector<Vec3> toward;
  std::vector<RgbD> got;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto d = mapping.direction({x + 0.5, y + 0.5});
      if (!d) continue;
      toward.push_back(*d);
      got.emplace_back(map.radiance(x, y));
    }
  }
  return error_of(got, fisheye_means(photograph, exact, toward, run));
}

FisheyeStudy study_of(const Environment& photograph, const FisheyeLight& light, int i, const PublishedOptions& options,
                      const Run& run) {
  const int size = options.size_px;
  FisheyeStudy study;
  study.shininess = options.shininess;
  study.corrected = corrected_forms(light, i, size, run);
  const Image<Rgb> map = published_paraboloid(photograph, options, run);
  study.published = {map, read_paraboloid(map, options.ground, kPanorama, panorama_size(size)),
                     read_paraboloid(map, options.ground, kCube, cube_size(size))};

  const std::vector<Vec3> toward = directions_above_horizon();
  const auto means = [&](FisheyeWeights weights, FisheyeGround ground_by) {
    return fisheye_means(photograph, {options.shininess, options.ground, weights, ground_by}, toward, run);
  };
  const auto exact = means(FisheyeWeights::kSolidAngle, FisheyeGround::kWhole);
  study.total = error_of(means(FisheyeWeights::kAngleToLobe, FisheyeGround::kSquareCorners), exact);
  study.weights_alone = error_of(means(FisheyeWeights::kAngleToLobe, FisheyeGround::kWhole), exact);
  study.ground_alone = error_of(means(FisheyeWeights::kSolidAngle, FisheyeGround::kSquareCorners), exact);
  study.library = error_of_library(light, i, photograph, {options.shininess, options.ground}, run);
  return study;
}

}  // namespace

FisheyeForms corrected_forms(const FisheyeLight& light, int i, int size_px, const Run& run) {
  return {light.paraboloid(i, size_px, run), light.render(i, kPanorama, panorama_size(size_px), run).map,
          light.render(i, kCube, cube_size(size_px), run).map};
}

std::vector<FisheyeStudy> fisheye_study(const Environment& photograph, const std::vector<double>& shininess,
                                        const PublishedOptions& options, const Run& run) {
  require_equidistant_half_sphere(photograph);
  const FisheyeLight light(photograph, options.ground, shininess, options.outside, run);
  std::vector<FisheyeStudy> studies;
  for (std::size_t i = 0; i < shininess.size(); ++i) {
    PublishedOptions one = options;
    one.shininess = shininess[i];
    studies.push_back(study_of(photograph, light, static_cast<int>(i), one, run));
  }
  return studies;
}

Environment smaller_photograph(const Environment& photograph, int factor) {
  const PixelCircle circle = fisheye_circle(photograph);
  Lens lens = photograph.projection.lens;
  lens.center_x_px = circle.center_x / factor, lens.center_y_px = circle.center_y / factor;
  lens.radius_x_px = circle.radius_x / factor, lens.radius_y_px = circle.radius_y / factor;
  return {block_means(photograph.radiance, factor), {Layout::kFisheye, lens}};
}

FisheyeError error_of_averaging_codes(const Environment& codes, Rgb ground, double shininess, const Run& run) {
  Environment light = codes;
  for (Rgb& texel : light.radiance.values()) texel = srgb_decode(texel);
  const std::vector<Vec3> toward = directions_above_horizon();
  std::vector<RgbD> got = fisheye_means(codes, {.shininess = shininess, .ground = ground}, toward, run);
  for (RgbD& mean : got) mean = RgbD(srgb_decode(Rgb(mean)));
  return error_of(got, fisheye_means(light, {.shininess = shininess, .ground = srgb_decode(ground)}, toward, run));
}

FisheyeForms first_published_forms(const Environment& photograph, const PublishedOptions& options, const Run& run) {
  const Image<Rgb> disc = first_published_disc(photograph, options, run);
  // The outermost pixels' centres lie on the horizon.
  Lens lens;
  lens.radius_x_px = (options.size_px - 1) / 2.0;
  const Environment half{disc, {Layout::kFisheye, lens}};
  const ResampleOptions below{.uncovered = Uncovered::kConstant, .ground = options.ground};
  return {disc, resample(half, kPanorama, panorama_size(options.size_px), below, run),
          resample(half, kCube, cube_size(options.size_px), below, run)};
}

}  // namespace zonal
