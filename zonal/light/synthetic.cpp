#include "zonal/light/synthetic.h"

#include <cmath>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/base/parallel.h"
#include "zonal/light/synthetic_disc.h"
#include "zonal/light/synthetic_texel.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

Environment paint(const Projection& projection, ImageSize size, const std::function<Rgb(Vec3)>& radiance,
                  int supersample, const Run& run) {
  check(supersample >= 1, "supersample must be at least 1");
  const Mapping mapping(projection, size);
  Environment result{Image<Rgb>(size.width, size.height), projection};
  const auto value = [&](Vec3 toward) { return RgbD(radiance(toward)); };
  for_each_block(run, "paint", size.height, 8, [&](Block block) {
    mapping.visit([&](const auto& map) {
      for (int y = block.begin; y < block.end; ++y) {
        for (int x = 0; x < size.width; ++x) {
          result.radiance(x, y) = Rgb(texel_mean<RgbD>(map, x, y, supersample, value));
        }
      }
    });
  });
  return result;
}

Environment furnace(const Projection& projection, ImageSize size, Rgb radiance) {
  return paint(projection, size, [=](Vec3) { return radiance; });
}

Environment gradient(const Projection& projection, ImageSize size) {
  return paint(projection, size, [](Vec3 d) {
    const float grey = static_cast<float>(1 + d.x + 0.5 * d.y);
    return Rgb{grey, grey, grey};
  });
}

Environment sun(const Projection& projection, ImageSize size, const SunOptions& options, const Run& run) {
  if (!(options.diameter_deg > 0 && options.diameter_deg <= 180)) {
    throw Error(ErrorKind::kUsage, "the sun's diameter must lie in (0, 180] degrees");
  }
  Environment result = paint(
      projection, size, [&](Vec3) { return options.sky; }, 1, run);
  const RgbD extra = (options.contrast - 1) * RgbD(options.sky);
  add_disc(result, options.toward_sun, radians(options.diameter_deg) / 2, extra);
  return result;
}

Environment checker(const Projection& projection, ImageSize size, double step_deg, Rgb white, const Run& run) {
  if (!(step_deg > 0 && step_deg <= 180)) {
    throw Error(ErrorKind::kUsage, "the step of a checker must lie in (0, 180] degrees");
  }
  const double step = radians(step_deg);
  const auto square = [&](Vec3 d) {
    const double azimuth = std::atan2(d.y, d.x), elevation = std::atan2(d.z, std::hypot(d.x, d.y));
    const auto column = static_cast<long>(std::floor(azimuth / step)),
               row = static_cast<long>(std::floor(elevation / step));
    return (column + row) % 2 == 0 ? white : Rgb{};
  };
  return paint(projection, size, square, 4, run);
}

}  // namespace zonal
