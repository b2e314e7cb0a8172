#include "zonal/view/ambient_table.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/parallel.h"
#include "zonal/light/dfg.h"
#include "zonal/light/lobe.h"
#include "zonal/light/phong_reflectance.h"
#include "zonal/view/control.h"

namespace zonal {
namespace {

constexpr double kSmoothest = 0.01;  // roughness: below it a table of n.v sees a mirror

Rgb reflectance(AmbientBrdf brdf, double n_dot_v, double parameter) {
  const auto plain = [](double value) { return Rgb(static_cast<float>(value), 0, 0); };
  const double exponent = std::pow(control_named("shininess").greatest, parameter);
  switch (brdf) {
    case AmbientBrdf::kLambert:
      return plain(1);
    case AmbientBrdf::kPhong:
      return plain(phong_reflectance(n_dot_v, exponent));
    case AmbientBrdf::kBlinnPhong:
      return plain(blinn_phong_reflectance(n_dot_v, exponent));
    case AmbientBrdf::kGgx:
      break;
  }
  const SplitSum split = ggx_split_sum(n_dot_v, alpha_from_roughness(std::max(parameter, kSmoothest)));
  return {static_cast<float>(split.scale), static_cast<float>(split.bias), 0};
}

}  // namespace

Image<Rgb> ambient_reflectance_picture(const Run& run) {
  Image<Rgb> picture(kAmbientColumns, kAmbientBrdfs * kAmbientRows);
  for_each_block(run, "ambient reflectance", picture.height(), 4, [&](Block block) {
    for (int y = block.begin; y < block.end; ++y) {
      const auto brdf = static_cast<AmbientBrdf>(y / kAmbientRows);
      const double parameter = (y % kAmbientRows) / (kAmbientRows - 1.0);
      for (int x = 0; x < picture.width(); ++x) {
        picture(x, y) = reflectance(brdf, (x + 0.5) / picture.width(), parameter);
      }
    }
  });
  return picture;
}

}  // namespace zonal
