#include "zonal/report/bake_verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "zonal/base/check.h"
#include "zonal/light/reference.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr std::mt19937::result_type kSeed = 20010812;  // the same texels every time

std::vector<Texel> drawn_texels(const Mapping& mapping, int count) {
  const auto [width, height] = mapping.size();
  std::mt19937 random(kSeed);  // its numbers are standardised, those of the distributions are not
  std::vector<Texel> texels;
  while (static_cast<int>(texels.size()) < count) {
    const auto index =
        random() % (static_cast<std::mt19937::result_type>(width) * static_cast<std::mt19937::result_type>(height));
    const Texel texel = {static_cast<int>(index) % width, static_cast<int>(index) / width};
    if (mapping.direction(center_of(texel))) texels.push_back(texel);
  }
  return texels;
}

}  // namespace

Verification verify(const Environment& environment, const Lobe& lobe, const Environment& map,
                    const ConvolveReport& report, const VerifyOptions& options, const Run& run) {
  check(options.directions > 0, "nothing to verify");
  const Mapping mapping(map.projection, {map.radiance.width(), map.radiance.height()});
  const std::vector<Texel> texels = drawn_texels(mapping, options.directions);
  std::vector<Vec3> directions;
  for (const Texel& texel : texels) directions.push_back(*mapping.direction(center_of(texel)));
  const std::vector<RgbD> truth = convolve_at(environment, lobe, directions, run);

  const double mean = report.bound_to_mean > 0 ? report.error_bound / report.bound_to_mean : 0;
  const double floor = 1e-3 * options.factor * mean;
  double squares = 0, worst = 0;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const RgbD expected = options.factor * truth[i], got(map.radiance(texels[i].x, texels[i].y));
    const double pairs[3][2] = {{expected.r, got.r}, {expected.g, got.g}, {expected.b, got.b}};
    for (const auto& [value, result] : pairs) {
      const double difference = std::abs(result - value);
      // Texels are floats, and sums of many: a few roundings of the value come on top of the bound.
      const double allowed = options.factor * report.error_bound + 1e-5 * std::abs(value);
      if (options.bounded && difference > allowed) {
        throw std::logic_error(
            fmt::format("a map is wrong by {:.3g} at texel ({}, {}), more than its stated error bound {:.3g}",
                        difference, texels[i].x, texels[i].y, allowed));
      }
      const double scale = std::max(std::abs(value), floor);
      const double relative = difference > 0 ? difference / scale : 0;
      squares += relative * relative;
      worst = std::max(worst, relative);
    }
  }
  return {options.directions, std::sqrt(squares / (3.0 * static_cast<double>(texels.size()))), worst};
}

}  // namespace zonal
