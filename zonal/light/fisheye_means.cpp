#include "zonal/light/fisheye_means.h"

#include <cmath>

#include "zonal/base/parallel.h"
#include "zonal/light/fisheye_pixels.h"

namespace zonal {
namespace {

constexpr int kDirectionsPerBlock = 32;

/// The pixels whose centres lie in the square around the circle.
PixelBox square_around(const PixelCircle& c) {
  const double slack = 1e-9;  // of pixel coordinates up to 10^5: centres on the square's edge belong to it
  const auto first = [&](double edge) { return static_cast<int>(std::ceil(edge - 0.5 - slack)); };
  const auto end = [&](double edge) { return static_cast<int>(std::floor(edge - 0.5 + slack)) + 1; };
  return {first(c.center_x - c.radius_x), first(c.center_y - c.radius_y), end(c.center_x + c.radius_x),
          end(c.center_y + c.radius_y)};
}

/// means[i] = mean_of(i) for all directions.
template <class MeanOf>
std::vector<RgbD> for_directions(std::size_t count, const Run& run, MeanOf mean_of) {
  std::vector<RgbD> means(count);
  for_each_block(run, "means", static_cast<int>(count), kDirectionsPerBlock, [&](Block block) {
    for (int i = block.begin; i < block.end; ++i) means[i] = mean_of(i);
  });
  return means;
}

RgbD mean(const LobeSum& sum, Rgb otherwise) { return sum.weight > 0 ? (1 / sum.weight) * sum.light : RgbD(otherwise); }

}  // namespace

std::vector<RgbD> fisheye_means(const Environment& photograph, const FisheyeMeansOptions& options,
                                std::span<const Vec3> toward, const Run& run) {
  const PixelCircle circle = fisheye_circle(photograph);
  const bool by_solid_angle = options.weights == FisheyeWeights::kSolidAngle;
  const FisheyeLobe weights(options.shininess, !by_solid_angle);
  if (options.ground_by == FisheyeGround::kSquareCorners) {
    const FisheyePixels square =
        pixels_of_plane(photograph, circle, square_around(circle), options.ground, by_solid_angle);
    return for_directions(toward.size(), run, [&](int i) {
      return mean(lobe_sum(square, square.box(), weights, toward[i], run.isa), options.ground);
    });
  }

  // (s + 1)/2π is what makes the lobe's integral over the sphere one: the ground has what the sky leaves.
  const double scale = (options.shininess + 1) / (2 * kPi);
  const FisheyePixels sky = pixels_of_sky(photograph, true);
  if (by_solid_angle) {
    return for_directions(toward.size(), run, [&](int i) {
      const LobeSum sum = lobe_sum(sky, sky.box(), weights, toward[i], run.isa);
      return scale * sum.light + (1 - scale * sum.weight) * RgbD(options.ground);
    });
  }
  require_equidistant_half_sphere(photograph);
  const FisheyeLobe lobe(options.shininess, false);
  const FisheyePixels alike = pixels_of_sky(photograph, false);
  return for_directions(toward.size(), run, [&](int i) {
    const double share = scale * lobe_sum(sky, sky.box(), lobe, toward[i], run.isa).weight;
    const LobeSum sum = lobe_sum(alike, alike.box(), weights, toward[i], run.isa);
    return share * mean(sum, options.ground) + (1 - share) * RgbD(options.ground);
  });
}

}  // namespace zonal
