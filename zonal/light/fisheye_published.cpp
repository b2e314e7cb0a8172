#include "zonal/light/fisheye_published.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "zonal/base/check.h"
#include "zonal/base/parallel.h"
#include "zonal/light/fisheye_means.h"
#include "zonal/light/fisheye_pixels.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

Rgb each(Rgb value, float (*change)(float)) { return {change(value.r), change(value.g), change(value.b)}; }
float rounded_level(float value) { return std::round(255 * std::clamp(value, 0.0f, 1.0f)) / 255; }
// An ambient of 0.2f times 255 is a little more than 51; a little less must not become 50.
float cut_level(float value) { return std::floor(255 * std::clamp(value, 0.0f, 1.0f) + 1e-4f) / 255; }

void check_size(int size_px) { check(size_px >= 2, "a published map has two pixels or more along its edge"); }

/// The pixels of a picture whose direction is not wanted keep the ground.
Image<Rgb> means_of(const Environment& photograph, const PublishedOptions& options, const std::vector<Vec3>& toward,
                    ImageSize size, const Run& run) {
  const bool skips = options.outside == FisheyeOutside::kGround;
  std::vector<Vec3> wanted;
  for (const Vec3& q : toward) {
    if (!skips || q.z > 0) wanted.push_back(q);
  }
  const std::vector<RgbD> means = fisheye_means(
      photograph, {options.shininess, options.ground, FisheyeWeights::kAngleToLobe, FisheyeGround::kSquareCorners},
      wanted, run);
  Image<Rgb> map(size.width, size.height);
  auto next = means.begin();
  for (std::size_t i = 0; i < toward.size(); ++i) {
    const bool computed = !skips || toward[i].z > 0;
    const Rgb value = computed ? Rgb(*next++) : options.ground;
    map.values()[i] = options.grey_levels ? each(value, computed ? rounded_level : cut_level) : value;
  }
  return map;
}

/// GL_LINEAR with GL_CLAMP_TO_BORDER, or of a pair GL_CLAMP_TO_EDGE, in the square of a map that begins at column
/// `left`.
Rgb read_linear(const Image<Rgb>& map, int left, double u, double v, Rgb border) {
  const int size = map.height();
  const bool pair = map.width() > size;
  const auto texel = [&](int x, int y) {
    if (pair) return RgbD(map(left + std::clamp(x, 0, size - 1), std::clamp(y, 0, size - 1)));
    return RgbD(x >= 0 && y >= 0 && x < size && y < size ? map(left + x, y) : border);
  };
  const double x = u * size - 0.5, y = v * size - 0.5;
  const int i = static_cast<int>(std::floor(std::clamp(x, -2.0, size + 1.0)));
  const int j = static_cast<int>(std::floor(std::clamp(y, -2.0, size + 1.0)));
  const double fx = std::clamp(x - i, 0.0, 1.0), fy = std::clamp(y - j, 0.0, 1.0);
  return Rgb((1 - fy) * ((1 - fx) * texel(i, j) + fx * texel(i + 1, j)) +
             fy * ((1 - fx) * texel(i, j + 1) + fx * texel(i + 1, j + 1)));
}

}  // namespace

std::vector<Vec3> published_paraboloid_directions(int size_px, bool lower) {
  check_size(size_px);
  std::vector<Vec3> directions;
  for (int y = 0; y < size_px; ++y) {
    for (int x = 0; x < size_px; ++x) {
      const double u = static_cast<double>(x) / (size_px - 1) - 0.5, v = 0.5 - static_cast<double>(y) / (size_px - 1);
      const double m = u * u + v * v, w = 0.25 - m, a = 0.25 + m;
      directions.push_back({v / a, u / a, (lower ? -w : w) / a});  // up, right and zenith of the photograph
    }
  }
  return directions;
}

Image<Rgb> published_paraboloid(const Environment& photograph, const PublishedOptions& options, const Run& run) {
  const std::vector<Vec3> upper = published_paraboloid_directions(options.size_px);
  if (options.outside != FisheyeOutside::kTwo) {
    return means_of(photograph, options, upper, {options.size_px, options.size_px}, run);
  }
  const std::vector<Vec3> lower = published_paraboloid_directions(options.size_px, true);
  std::vector<Vec3> both;
  for (auto row = 0; row < options.size_px; ++row) {
    for (const std::vector<Vec3>* half : {&upper, &lower}) {
      const auto begin = half->begin() + static_cast<std::ptrdiff_t>(row) * options.size_px;
      both.insert(both.end(), begin, begin + options.size_px);
    }
  }
  return means_of(photograph, options, both, {2 * options.size_px, options.size_px}, run);
}

Image<Rgb> first_published_disc(const Environment& photograph, const PublishedOptions& options, const Run& run) {
  check_size(options.size_px);
  const PixelCircle circle = fisheye_circle(photograph);
  const auto edge = [](double radius) { return static_cast<int>(std::lround(2 * radius)) + 1; };
  const int width = edge(circle.radius_x), height = edge(circle.radius_y), size = options.size_px;
  const FisheyeLobe lobe(options.shininess, true);
  // The window of the outermost pixels reaches half its size beyond the circle.
  const int x0 = static_cast<int>(std::floor(circle.center_x - circle.radius_x)) - width / 2 - 1;
  const int y0 = static_cast<int>(std::floor(circle.center_y - circle.radius_y)) - height / 2 - 1;
  const FisheyePixels plane =
      pixels_of_plane(photograph, circle, {x0, y0, x0 + 2 * width + 3, y0 + 2 * height + 3}, options.ground, false);

  Image<Rgb> map(size, size);
  for_each_block(run, "means", size, 1, [&](Block block) {
    const int y = block.index;
    const double t = 1 - 2.0 * y / (size - 1);
    for (int x = 0; x < size; ++x) {
      const double s = 2.0 * x / (size - 1) - 1, r = std::hypot(s, t);
      Rgb value = options.ground;
      if (r < 1) {
        const double side = r > 0 ? std::sin(r * kPi / 2) / r : 0;
        const int cx = static_cast<int>(std::lround(circle.center_x - 0.5 + s * circle.radius_x));
        const int cy = static_cast<int>(std::lround(circle.center_y - 0.5 - t * circle.radius_y));
        // Of an even number of rows, counted from the bottom there, the greater half lies below: here above is less.
        const int left = cx - width / 2, top = cy - (height - height / 2 - 1);
        const LobeSum sum = lobe_sum(plane, {left, top, left + width, top + height}, lobe,
                                     {t * side, s * side, std::cos(r * kPi / 2)}, run.isa);
        if (sum.weight > 0) value = Rgb((1 / sum.weight) * sum.light);
      }
      map(x, y) = options.grey_levels ? each(value, rounded_level) : value;
    }
  });
  return map;
}

Environment read_paraboloid(const Image<Rgb>& map, Rgb ground, const Projection& projection, ImageSize size) {
  const bool two = map.width() == 2 * map.height();
  check(two || map.width() == map.height(), "a paraboloid map is a square, or two");
  const Mapping mapping(projection, size);
  Environment out{Image<Rgb>(size.width, size.height), projection};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto d = mapping.texel_direction(x, y);
      if (!d) continue;
      const bool lower = two && d->z < 0;
      const double scale = 2 * (1 + (lower ? -d->z : d->z));
      if (scale > 0) {
        const double u = d->y / scale + 0.5, v = 0.5 - d->x / scale;
        out.radiance(x, y) = read_linear(map, lower ? map.height() : 0, u, v, ground);
      } else {
        out.radiance(x, y) = ground;  // the nadir lies infinitely far outside
      }
    }
  }
  return out;
}

}  // namespace zonal
