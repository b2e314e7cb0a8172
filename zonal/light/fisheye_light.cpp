#include "zonal/light/fisheye_light.h"

#include <algorithm>
#include <cmath>

#include "zonal/light/fisheye_pixels.h"
#include "zonal/light/resample.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr int kLeastRows = 16, kMostRows = 2048;

/// Where the photograph shows nothing, the ground.
Environment panorama_of(const Environment& photograph, Rgb ground, const Rotation& world_from_source, const Run& run) {
  const PixelCircle circle = fisheye_circle(photograph);
  const double rows = 2 * std::max(circle.radius_x, circle.radius_y) * 180 / photograph.projection.lens.fov_deg;
  const int height = static_cast<int>(std::lround(std::clamp<double>(rows, kLeastRows, kMostRows)));
  return resample(photograph, {Layout::kEquirect}, height, {world_from_source, 0, Uncovered::kConstant, ground}, run);
}

std::vector<Lobe> lobes_of(const std::vector<double>& shininess) {
  std::vector<Lobe> lobes;
  for (const double s : shininess) lobes.push_back(Lobe::phong(s));
  return lobes;
}

}  // namespace

Projection sky_paraboloid(int size_px, bool extended) {
  if (!extended) return {Layout::kFisheye, {LensModel::kStereographic, 180}};
  // tan(T/2) is 1 at the circle and √2 at the corners.
  const double center = size_px / 2.0;
  return {Layout::kFisheye,
          {LensModel::kStereographic, degrees(4 * std::atan(std::sqrt(2.0))), center, center, center * std::sqrt(2.0)}};
}

FisheyeLight::FisheyeLight(const Environment& photograph, Rgb ground, const std::vector<double>& shininess,
                           FisheyeOutside outside, const Run& run)
    : ground_(ground),
      outside_(outside),
      upright_(panorama_of(photograph, ground, {}, run), lobes_of(shininess), {}, run) {
  if (outside != FisheyeOutside::kTwo) return;
  // Half a turn about the photograph's right: its up points down, and so does the zenith.
  upside_down_.emplace(panorama_of(photograph, ground, Rotation::about_y(kPi), run), lobes_of(shininess),
                       ConvolveOptions{}, run);
}

Convolved FisheyeLight::render(int i, const Projection& projection, ImageSize size, const Run& run) const {
  return upright_.render(i, projection, size, run);
}

Image<Rgb> FisheyeLight::paraboloid(int i, int size_px, const Run& run) const {
  const Projection projection = sky_paraboloid(size_px, outside_ != FisheyeOutside::kGround);
  const ImageSize size{size_px, size_px};
  Image<Rgb> map = render(i, projection, size, run).map.radiance;
  const Mapping mapping(projection, size);
  for (int y = 0; y < size_px; ++y) {
    for (int x = 0; x < size_px; ++x) {
      if (!mapping.direction({x + 0.5, y + 0.5})) map(x, y) = ground_;
    }
  }
  if (!upside_down_) return map;
  const Image<Rgb> lower = upside_down_->render(i, projection, size, run).map.radiance;
  Image<Rgb> both(2 * size_px, size_px);
  for (int y = 0; y < size_px; ++y) {
    std::ranges::copy(map.row(y), both.row(y).begin());
    std::ranges::copy(lower.row(size_px - 1 - y), both.row(y).begin() + size_px);  // its up is down
  }
  return both;
}

}  // namespace zonal
