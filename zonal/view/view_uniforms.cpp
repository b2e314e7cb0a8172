#include "zonal/view/view_uniforms.h"

#include <algorithm>
#include <cmath>

#include "zonal/light/extract.h"
#include "zonal/sh/ambient_cube.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/shading_constants.h"
#include "zonal/sh/vector_irradiance.h"

namespace zonal {
namespace {

constexpr int kMostLights = 3;

/// k1..k5 of the polynomial of Ramamoorthi & Hanrahan 2001 (eq. 13), read off the matrix of unit coefficients.
std::vector<double> lecture_constants() {
  const auto matrix_of = [](int l, int m) {
    Sh<double, 3> unit;
    unit(l, m) = 1;
    return irradiance_matrix(unit).rows;
  };
  const auto square = matrix_of(2, 2), linear = matrix_of(1, 1), pole = matrix_of(2, 0), constant = matrix_of(0, 0);
  return {square[0][0], linear[0][3], pole[2][2], constant[3][3], -pole[3][3]};
}

void add_extracted_lights(ViewData& data, const Sh<RgbD>& radiance) {
  std::vector<Vec3> directions;
  std::vector<RgbD> irradiance, ambient = {mean_radiance(radiance)};
  std::vector<double> shares;
  const double all_light = 4 * kPi * luminance(mean_radiance(radiance));
  for (int count = 1; count <= kMostLights; ++count) {
    ExtractedLights found = extract_lights(radiance, {.lights = count, .refine = true});
    found.lights.resize(static_cast<std::size_t>(count), {.direction = {0, 0, 1}, .irradiance = {}});
    for (const ExtractedLight& light : found.lights) {
      directions.push_back(light.direction);
      irradiance.push_back(light.irradiance);
      shares.push_back(all_light > 0 ? std::max(0.0, luminance(light.irradiance)) / all_light : 0);
    }
    ambient.push_back(found.ambient);
  }
  add_uniform(data, "light_directions", directions);
  add_uniform(data, "light_irradiance", irradiance);
  add_uniform(data, "light_shares", shares);
  add_uniform(data, "light_ambient", ambient);
}

}  // namespace

void add_uniform(ViewData& data, std::string name, const std::vector<double>& numbers) {
  data.uniforms.push_back({std::move(name), 1, {numbers.begin(), numbers.end()}});
}

void add_uniform(ViewData& data, std::string name, const std::vector<Vec3>& vectors) {
  ViewUniform uniform{std::move(name), 3, {}};
  for (const Vec3& v : vectors) {
    for (const double x : {v.x, v.y, v.z}) uniform.values.push_back(static_cast<float>(x));
  }
  data.uniforms.push_back(std::move(uniform));
}

void add_uniform(ViewData& data, std::string name, const std::vector<RgbD>& colors) {
  std::vector<Vec3> vectors;
  for (const RgbD& c : colors) vectors.push_back({c.r, c.g, c.b});
  add_uniform(data, std::move(name), vectors);
}

void add_light_uniforms(ViewData& data, const Sh<RgbD>& radiance) {
  add_uniform(data, "sh", std::vector<RgbD>(radiance.values().begin(), radiance.values().end()));
  add_uniform(data, "cosine_factors", cosine_factors(radiance.bands()));
  add_uniform(data, "lecture_constants", lecture_constants());
  add_uniform(data, "mean_radiance", std::vector{mean_radiance(radiance)});
  const double bright = luminance(mean_radiance(radiance));
  add_uniform(data, "negative_tint", std::vector{RgbD(0.05 * bright, 0.2 * bright, 2 * bright)});

  const auto constants = irradiance_over_pi_constants(with_bands<3>(radiance));
  ViewUniform shading{"shading_constants", 4, {}};
  for (const auto* group : {&constants.linear, &constants.quadratic}) {
    for (const auto& vector : *group) shading.values.insert(shading.values.end(), vector.begin(), vector.end());
  }
  shading.values.insert(shading.values.end(), constants.last.begin(), constants.last.end());
  data.uniforms.push_back(std::move(shading));

  const AmbientCube<RgbD> cube = ambient_cube(irradiance_over_pi(radiance));
  add_uniform(data, "cube_sides", std::vector<RgbD>(cube.sides.begin(), cube.sides.end()));

  const auto vectors = vector_irradiance(radiance);
  add_uniform(data, "vector_irradiance", std::vector<Vec3>(vectors.begin(), vectors.end()));
  add_extracted_lights(data, radiance);
}

}  // namespace zonal
