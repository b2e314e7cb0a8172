#include "zonal/view/sky_maps.h"

#include <algorithm>
#include <array>

#include "zonal/base/error.h"
#include "zonal/light/convolve.h"
#include "zonal/light/fisheye_light.h"
#include "zonal/light/fisheye_means.h"
#include "zonal/light/fisheye_published.h"
#include "zonal/light/resample.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr Rgb kWhite = {1, 1, 1};

/// Directions of both maps' texels, the zenith's beside the nadir's, row by row.
std::vector<Vec3> beside(const std::vector<Vec3>& upper, const std::vector<Vec3>& lower, int size_px) {
  std::vector<Vec3> both;
  for (std::ptrdiff_t row = 0; row < size_px; ++row) {
    for (const std::vector<Vec3>* map : {&upper, &lower}) {
      both.insert(both.end(), map->begin() + row * size_px, map->begin() + (row + 1) * size_px);
    }
  }
  return both;
}

/// One of the two programs: how it weighs, what the ground is to it, where its texels look.
struct Program {
  FisheyeWeights weights;
  FisheyeGround ground_by;
  std::vector<Vec3> toward;
};

Program published(int size_px) {
  return {FisheyeWeights::kAngleToLobe, FisheyeGround::kSquareCorners,
          beside(published_paraboloid_directions(size_px), published_paraboloid_directions(size_px, true), size_px)};
}

Program corrected(int size_px) {
  const Mapping mapping(sky_paraboloid(size_px, true), {size_px, size_px});
  std::vector<Vec3> upper, lower;
  for (int y = 0; y < size_px; ++y) {
    for (int x = 0; x < size_px; ++x) {
      const Vec3 d = *mapping.direction({x + 0.5, y + 0.5});
      upper.push_back(d);
      lower.push_back({d.x, d.y, -d.z});
    }
  }
  return {FisheyeWeights::kSolidAngle, FisheyeGround::kWhole, beside(upper, lower, size_px)};
}

/// Into the rows from `first_row` on.
void add_means(Image<Rgb>& maps, int first_row, const Environment& photograph, double shininess, const Program& program,
               const Run& run) {
  const std::vector<RgbD> means =
      fisheye_means(photograph, {shininess, {}, program.weights, program.ground_by}, program.toward, run);
  std::ranges::transform(means, maps.values().begin() + std::ptrdiff_t{first_row} * maps.width(),
                         [](const RgbD& mean) { return Rgb(mean); });
}

/// The ground's share in the upper left quarters of both maps: what black sky over white ground gives.
std::vector<double> shares_of(const Environment& black, double shininess, const Program& program, int size_px,
                              const Run& run) {
  std::vector<Vec3> toward;
  const int half = size_px / 2;
  for (std::ptrdiff_t y = 0; y < half; ++y) {
    for (const std::ptrdiff_t x : {0, size_px}) {
      const auto first = program.toward.begin() + y * 2 * size_px + x;
      toward.insert(toward.end(), first, first + half);
    }
  }
  std::vector<double> shares;
  for (const RgbD& mean : fisheye_means(black, {shininess, kWhite, program.weights, program.ground_by}, toward, run)) {
    shares.push_back(mean.r);
  }
  return shares;
}

/// Of the rows [first, end) of a panorama.
RgbD mean_of_rows(const Environment& panorama, int first, int end) {
  const Image<Rgb>& image = panorama.radiance;
  const Mapping mapping(panorama.projection, {image.width(), image.height()});
  RgbD sum;
  double area = 0;
  for (int y = first; y < end; ++y) {
    const double texel = mapping.solid_angle(0, y);
    for (const Rgb& value : image.row(y)) sum += texel * RgbD(value);
    area += texel * image.width();
  }
  return (1 / area) * sum;
}

}  // namespace

int sky_photograph_px(int size_px) { return 2 * size_px; }

SkyMaps sky_maps(const Environment& environment, const std::vector<double>& shininess, int size_px, const Run& run) {
  if (size_px < 4 || size_px % 2 != 0) {
    throw Error(ErrorKind::kUsage, "maps of a sky of a size that they cannot have", "an even size of four or more");
  }
  const Environment photograph = resample(environment, {Layout::kFisheye}, sky_photograph_px(size_px), {}, run);
  const Environment black = {Image<Rgb>(photograph.radiance.width(), photograph.radiance.height()),
                             photograph.projection};
  const std::array programs = {published(size_px), corrected(size_px)};

  SkyMaps result;
  result.shininess = shininess;
  const int levels = static_cast<int>(shininess.size()), half = size_px / 2;
  result.maps = Image<Rgb>(2 * size_px, 2 * levels * size_px);
  result.shares = Image<Rgb>(size_px, levels * half);
  for (int i = 0; i < levels; ++i) {
    const double s = shininess[static_cast<std::size_t>(i)];
    for (int j = 0; j < 2; ++j) {
      const Program& program = programs[static_cast<std::size_t>(j)];
      add_means(result.maps, (2 * i + j) * size_px, photograph, s, program, run);
      const std::vector<double> shares = shares_of(black, s, program, size_px, run);
      for (std::size_t k = 0; k < shares.size(); ++k) {
        Rgb& share = result.shares.values()[static_cast<std::size_t>(i) * shares.size() + k];
        (j == 0 ? share.r : share.g) = static_cast<float>(shares[k]);
      }
    }
  }

  const Environment panorama = as_equirect(environment, run);
  const int rows = panorama.radiance.height();  // where they are odd, the middle one belongs to both halves
  result.sky_mean = mean_of_rows(panorama, 0, (rows + 1) / 2);
  result.ground_mean = mean_of_rows(panorama, rows / 2, rows);
  return result;
}

}  // namespace zonal
