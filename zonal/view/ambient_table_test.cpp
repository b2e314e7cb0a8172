#include "zonal/view/ambient_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/light/ambient_reflectance.h"
#include "zonal/light/lobe.h"

namespace zonal {
namespace {

Brdf brdf_of(AmbientBrdf kind, double parameter, double f0) {
  if (kind == AmbientBrdf::kLambert) return lambert_brdf({1, 1, 1});
  if (kind == AmbientBrdf::kPhong) return phong_brdf(std::pow(512, parameter));
  if (kind == AmbientBrdf::kBlinnPhong) return blinn_phong_brdf(std::pow(512, parameter));
  return ggx_brdf(alpha_from_roughness(parameter), {f0, f0, f0});
}

TEST(AmbientTable, HoldsTheReflectanceOfEachBrdf) {
  const Image<Rgb> table = ambient_reflectance_picture();
  ASSERT_EQ(table.height(), 64);
  int compared = 0;
  for (const AmbientBrdf kind :
       {AmbientBrdf::kLambert, AmbientBrdf::kPhong, AmbientBrdf::kBlinnPhong, AmbientBrdf::kGgx}) {
    for (const int row : {3, 9, 15}) {
      for (const int column : {1, 20, 63}) {
        const Rgb texel = table(column, static_cast<int>(kind) * kAmbientRows + row);
        // Only GGX knows a reflectance at normal incidence other than 1.
        const double f0 = kind == AmbientBrdf::kGgx ? 0.3 : 1;
        const Reflectance truth =
            ambient_reflectance(brdf_of(kind, row / 15.0, f0), (column + 0.5) / kAmbientColumns, 1e-5);
        EXPECT_NEAR(f0 * texel.r + texel.g, truth.value.g, 2e-5)
            << static_cast<int>(kind) << " " << row << " " << column;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 36);
}

}  // namespace
}  // namespace zonal
