#include "zonal/light/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "zonal/light/project.h"
#include "zonal/light/synthetic.h"
#include "zonal/sh/eval.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

Sh<RgbD> random_coefficients(int bands) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Sh<RgbD> sh(bands);
  for (int l = 0; l < bands; ++l) {
    for (RgbD& c : sh.band(l)) c = 1.0 / (1 + l) * RgbD{normal(random), normal(random), normal(random)};
  }
  return sh;
}

TEST(Render, IsTheFunctionInEveryProjection) {
  int texels = 0;
  for (const int bands : {1, 3, 20}) {
    const Sh<RgbD> sh = random_coefficients(bands);
    for (const Layout layout : all_layouts()) {
      const ImageSize size = image_size(layout, 13);
      const Environment picture = render(sh, {layout}, size);
      const Mapping mapping({layout}, size);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          const auto toward = mapping.direction({x + 0.5, y + 0.5});
          const RgbD expected = toward ? evaluate(sh, *toward) : RgbD{};
          // 1e-6 of the greatest possible value from interpolation, and floats.
          ASSERT_NEAR(picture.radiance(x, y).g, expected.g, 1e-5) << name_of(layout) << " " << x << "," << y;
          ++texels;
        }
      }
    }
  }
  EXPECT_GT(texels, 3 * 14 * 169);
}

TEST(RingReader, StaysWithinItsStatedError) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  const Sh<RgbD> sh = random_coefficients(40);
  for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
    const RingReader reader(sh, tolerance, {});
    EXPECT_LE(reader.error_bound(), tolerance);
    double worst = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec3 d =
          i < 2 ? Vec3{0, 0, i == 0 ? 1.0 : -1.0} : normalize({normal(random), normal(random), normal(random)});
      float out[3], unused;
      reader.read(&d.x, &d.y, &d.z, 1, out, &unused);
      worst = std::max(worst, std::abs(out[0] - evaluate(sh, d).r));
    }
    EXPECT_LT(worst, reader.error_bound() + 1e-5) << "floats of a function of size ten";
    EXPECT_GT(worst, 0);
  }
}

TEST(Project, TakesTheSameCoefficientsFromEveryFullProjection) {
  const Environment panorama = gradient({Layout::kEquirect}, {256, 128});
  const Sh<RgbD> expected = project(panorama, 4);
  int projections = 0;
  for (const Layout layout : all_layouts()) {
    if (layout == Layout::kFisheye) continue;
    const Sh<RgbD> got = project(gradient({layout}, image_size(layout, 128)), 4);
    // Point samples with texel areas: right to the square of the texel size.
    for (std::size_t i = 0; i < got.size(); ++i)
      EXPECT_NEAR(got[i].r, expected[i].r, 2e-3) << name_of(layout) << " " << i;
    ++projections;
  }
  EXPECT_EQ(projections, static_cast<int>(all_layouts().size()) - 1);
}

TEST(Project, OfALinearSkyIsItsFourCoefficients) {
  const Sh<Rgb, 3> sh = project<3>(gradient({Layout::kEquirect}, {512, 256}));
  const double unit = std::sqrt(4 * kPi / 3);
  EXPECT_NEAR(sh(0, 0).r, std::sqrt(4 * kPi), 1e-6);
  EXPECT_NEAR(sh(1, 1).g, unit, 1e-4);
  EXPECT_NEAR(sh(1, -1).b, unit / 2, 1e-4);
  EXPECT_NEAR(sh(1, 0).r, 0, 1e-6);
}

}  // namespace
}  // namespace zonal
