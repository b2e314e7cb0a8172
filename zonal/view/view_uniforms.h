#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "zonal/sh/sh.h"
#include "zonal/view/view_data.h"

namespace zonal {

void add_uniform(ViewData&, std::string name, const std::vector<double>& numbers);
void add_uniform(ViewData&, std::string name, const std::vector<Vec3>& vectors);
void add_uniform(ViewData&, std::string name, const std::vector<RgbD>& colors);

template <int N>
RgbD mean_radiance(const Sh<RgbD, N>& radiance) {
  return (1 / std::sqrt(4 * kPi)) * radiance(0, 0);
}

/// All that the coefficients of six bands give: themselves, cosine factors, shader constants, ambient cube, vector
/// irradiance, extracted lights.
void add_light_uniforms(ViewData&, const Sh<RgbD>& radiance);

}  // namespace zonal
