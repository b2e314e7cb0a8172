#include "zonal/gl/reference_lookups_test.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "zonal/light/reference.h"
#include "zonal/sphere/mapping.h"

namespace zonal {

Vec3 mirrored(const SurfacePoint& p) { return 2 * dot(p.normal, p.toward_eye) * p.normal - p.toward_eye; }

Rotation light_rotation(const ViewState& state) {
  return Rotation::about_z(radians(state.value("light_yaw_deg"))) *
         Rotation::about_y(-radians(state.value("light_pitch_deg"))) *
         Rotation::about_x(radians(state.value("light_roll_deg")));
}

std::function<Vec3(Vec3)> into_light(const ViewState& state) {
  return [light_from_world = transpose(light_rotation(state))](Vec3 d) { return light_from_world * d; };
}

std::function<RgbD(Vec3)> lookup(Environment environment) {
  const Mapping mapping(environment.projection, {environment.radiance.width(), environment.radiance.height()});
  return [picture = std::move(environment.radiance), mapping](Vec3 d) {
    const PixelPoint p = *mapping.position(d);
    const int chart = mapping.chart(p), x0 = static_cast<int>(std::floor(p.x - 0.5)),
              y0 = static_cast<int>(std::floor(p.y - 0.5));
    const double x = p.x - 0.5 - x0, y = p.y - 0.5 - y0;
    RgbD sum;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        const auto texel = mapping.wrap(chart, x0 + i, y0 + j);
        sum += ((i == 1 ? x : 1 - x) * (j == 1 ? y : 1 - y)) * RgbD(picture(texel.x, texel.y));
      }
    }
    return sum;
  };
}

RgbD bilinear(const Image<Rgb>& image, double u, double v, bool repeats_x, bool repeats_y) {
  const auto place = [](int i, int size, bool repeats) {
    return repeats ? ((i % size) + size) % size : std::clamp(i, 0, size - 1);
  };
  const double x = u * image.width() - 0.5, y = v * image.height() - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  RgbD sum;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const double weight = (i == 1 ? x - x0 : 1 - (x - x0)) * (j == 1 ? y - y0 : 1 - (y - y0));
      sum += weight * RgbD(image(place(x0 + i, image.width(), repeats_x), place(y0 + j, image.height(), repeats_y)));
    }
  }
  return sum;
}

std::array<double, 2> on_panorama(Vec3 d) {
  const Mapping mapping({Layout::kEquirect}, {2, 1});
  const PixelPoint p = *mapping.position(d);
  return {p.x / 2, p.y};
}

std::vector<LitTexel> texels_of(const Environment& environment) {
  const Image<Rgb>& image = environment.radiance;
  const Mapping mapping(environment.projection, {image.width(), image.height()});
  std::vector<LitTexel> texels;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      texels.push_back({*mapping.texel_direction(x, y), mapping.solid_angle(x, y), RgbD(image(x, y))});
    }
  }
  return texels;
}

PointLight of_normal(const ViewState& state, std::function<RgbD(Vec3)> light, double scale) {
  return [in_light = into_light(state), light = std::move(light), scale](const SurfacePoint& p) {
    return scale * light(in_light(p.normal));
  };
}

PointLight of_mirrored(const ViewState& state, std::function<RgbD(Vec3)> light) {
  return [in_light = into_light(state), light = std::move(light)](const SurfacePoint& p) {
    return light(in_light(mirrored(p)));
  };
}

std::function<RgbD(Vec3)> through(const Environment& panorama, const Lobe& lobe) {
  return [&panorama, lobe](Vec3 d) { return convolve_at(panorama, lobe, std::array{d})[0]; };
}

}  // namespace zonal
