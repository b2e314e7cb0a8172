#include "zonal/light/ambient_reflectance.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/light/dfg.h"
#include "zonal/light/lobe.h"
#include "zonal/math/quadrature.h"

namespace zonal {
namespace {

constexpr double kCosines[] = {1e-3, 0.05, 0.2, 0.5, 0.8, 0.99, 1.0};

TEST(AmbientReflectance, OfALambertianSurfaceIsItsAlbedo) {
  const Brdf matte = lambert_brdf({1, 0.5, 0.18});
  int compared = 0;
  for (const double n_dot_v : kCosines) {
    const Reflectance found = ambient_reflectance(matte, n_dot_v);
    EXPECT_NEAR(found.value.r, 1, 1e-12) << n_dot_v;
    EXPECT_NEAR(found.value.g, 0.5, 1e-12) << n_dot_v;
    EXPECT_NEAR(found.value.b, 0.18, 1e-12) << n_dot_v;
    EXPECT_LT(found.error, 1e-6);
    ++compared;
  }
  EXPECT_EQ(compared, 7);
  const ReflectanceTable table = ambient_reflectance_table(matte, 32);
  ASSERT_EQ(table.values.size(), 32u);
  for (const RgbD value : table.values) EXPECT_NEAR(value.r, 1, 1e-12);
}

TEST(AmbientReflectance, PhongHasItsClosedForms) {
  int compared = 0;
  for (const double s : {0.0, 1.0, 2.5, 10.0, 100.0, 1e4, 1e6}) {
    const Brdf phong = phong_brdf(s);
    const Reflectance facing = ambient_reflectance(phong, 1, 1e-9);
    EXPECT_NEAR(facing.value.g, 1, facing.error) << s;
    // v in the surface: (s+2)/2pi times int cos^s sin^2 dpsi times int cos(chi) dchi over half a circle, which is 2.
    const double grazing =
        (s + 2) / kPi * std::sqrt(kPi) / 4 * std::exp(std::lgamma((s + 1) / 2) - std::lgamma(s / 2 + 2));
    const Reflectance along = ambient_reflectance(phong, 1e-9, 1e-9);
    // 1e-9 above the surface the value is larger by about the cosine times half the lobe.
    EXPECT_NEAR(along.value.g, grazing, along.error + 2e-9 * (1 + std::sqrt(s))) << s;
    compared += 2;
  }
  // s = 1: the product of two clamped cosines gamma apart, 2/3 (sin(gamma) + (pi - gamma) cos(gamma)).
  for (const double n_dot_v : kCosines) {
    const double gamma = std::acos(n_dot_v);
    const Reflectance found = ambient_reflectance(phong_brdf(1), n_dot_v, 1e-10);
    EXPECT_NEAR(found.value.r, 3 / (2 * kPi) * 2 / 3 * (std::sin(gamma) + (kPi - gamma) * n_dot_v), found.error);
    ++compared;
  }
  EXPECT_EQ(compared, 21);
}

TEST(AmbientReflectance, BlinnPhongReflectsAllAtNormalIncidence) {
  int compared = 0;
  for (const double s : {0.0, 1.0, 3.0, 20.0, 500.0, 1e5}) {
    const Reflectance found = ambient_reflectance(blinn_phong_brdf(s), 1, 1e-9);
    EXPECT_NEAR(found.value.g, 1, found.error) << s;
    ++compared;
  }
  EXPECT_EQ(compared, 6);
}

TEST(AmbientReflectance, OfGgxIsTheSplitSum) {
  int compared = 0;
  for (const double alpha : {0.0025, 0.01, 0.09, 0.25, 0.64, 1.0}) {
    for (const double n_dot_v : {0.01, 0.1, 0.4, 0.95, 1.0}) {
      const SplitSum split = ggx_split_sum(n_dot_v, alpha);
      const Reflectance found = ambient_reflectance(ggx_brdf(alpha, {1, 0, 0.04}), n_dot_v, 1e-6);
      EXPECT_LT(found.error, 1.1e-6) << "reached what was asked for";
      const double allowed = found.error + 3e-6;  // the split sum states 3e-6
      EXPECT_NEAR(found.value.r, split.scale + split.bias, allowed) << alpha << ' ' << n_dot_v;
      EXPECT_NEAR(found.value.g, split.bias, allowed) << alpha << ' ' << n_dot_v;
      EXPECT_NEAR(found.value.b, 0.04 * split.scale + split.bias, allowed) << alpha << ' ' << n_dot_v;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 30);
  const Reflectance rough = ambient_reflectance(ggx_brdf(1), 1, 1e-10);
  EXPECT_NEAR(rough.value.r, 1 - std::log(2.0), rough.error);
}

TEST(AmbientReflectance, OfGgxIsTheRedPlusGreenOfTheTable) {
  constexpr int kSize = 8;
  const Image<Rgb> dfg = dfg_table(kSize);
  int compared = 0;
  for (const int row : {2, 7}) {
    const double alpha = alpha_from_roughness((row + 0.5) / kSize);
    const ReflectanceTable table = ambient_reflectance_table(ggx_brdf(alpha), kSize);
    for (int x = 0; x < kSize; ++x, ++compared) {
      EXPECT_NEAR(table.values[static_cast<std::size_t>(x)].g, dfg(x, row).r + dfg(x, row).g, table.error + 3e-6);
    }
  }
  EXPECT_EQ(compared, 2 * kSize);
}

// A second opinion for the separable masking, which the split sum does not have: the sum over theta and phi about the
// normal, in no way aware of the mirror direction, for a lobe wide enough for it.
TEST(AmbientReflectance, SeparableMaskingAgreesWithASumAboutTheNormalAndIsDarker) {
  const Quadrature polar = gauss_legendre(200, 0, kPi / 2);
  int compared = 0;
  for (const double alpha : {0.4, 0.8}) {
    const Brdf separable = ggx_brdf(alpha, {1, 1, 1}, Masking::kSeparable);
    for (const double n_dot_v : {0.1, 0.5, 0.9, 1.0}) {
      const double a2 = alpha * alpha, sin_v = std::sqrt(1 - n_dot_v * n_dot_v);
      const auto g1 = [&](double c) { return 2 / (1 + std::sqrt(1 + a2 * (1 / (c * c) - 1))); };
      double sum = 0;
      for (std::size_t i = 0; i < polar.size(); ++i) {
        const double c = std::cos(polar.nodes[i]), s = std::sin(polar.nodes[i]);
        constexpr int kSteps = 400;  // periodic and smooth
        for (int k = 0; k < kSteps; ++k) {
          const double phi = 2 * kPi * (k + 0.5) / kSteps;
          const double hx = s * std::cos(phi) + sin_v, hy = s * std::sin(phi), hz = c + n_dot_v;
          const double cosine2 = hz * hz / (hx * hx + hy * hy + hz * hz), root = cosine2 * (a2 - 1) + 1;
          sum +=
              polar.weights[i] * s * 2 * kPi / kSteps * a2 / (kPi * root * root) * g1(c) * g1(n_dot_v) / (4 * n_dot_v);
        }
      }
      const Reflectance found = ambient_reflectance(separable, n_dot_v, 1e-8);
      EXPECT_NEAR(found.value.g, sum, found.error + 1e-9) << alpha << ' ' << n_dot_v;
      const Reflectance correlated = ambient_reflectance(ggx_brdf(alpha), n_dot_v, 1e-8);
      if (n_dot_v < 1) {
        EXPECT_LT(found.value.g, correlated.value.g - 1e-4) << alpha << ' ' << n_dot_v;
      } else {
        EXPECT_NEAR(found.value.g, correlated.value.g, 2e-8) << "nothing masks the normal";
      }
      ++compared;
    }
  }
  EXPECT_EQ(compared, 8);
}

TEST(AmbientReflectance, NoSurfaceReflectsMoreThanArrives) {
  const Brdf surfaces[] = {lambert_brdf({1, 1, 1}),
                           phong_brdf(0),
                           phong_brdf(7),
                           phong_brdf(3000),
                           blinn_phong_brdf(12),
                           blinn_phong_brdf(800),
                           ggx_brdf(0.01),
                           ggx_brdf(0.3),
                           ggx_brdf(1),
                           ggx_brdf(0.01, {1, 1, 1}, Masking::kSeparable),
                           ggx_brdf(0.7, {1, 1, 1}, Masking::kSeparable)};
  int compared = 0;
  for (const Brdf& surface : surfaces) {
    const ReflectanceTable table = ambient_reflectance_table(surface, 12);
    for (const RgbD value : table.values) {
      EXPECT_LE(value.g, 1 + table.error) << compared;
      EXPECT_GT(value.g, 0) << compared;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 11 * 12);
}

TEST(AmbientReflectance, AJumpIsResolvedToAFewTimesTheStatedError) {
  int compared = 0;
  // All that arrives from within w of the viewer, who looks straight down, and nothing else: f = 1/(pi sin^2 w) there.
  for (const double w : {0.1, 0.5, 1.2}) {
    const Brdf disc = [w](Vec3 l, Vec3 v) {
      const double f = dot(l, v) > std::cos(w) ? 1 / (kPi * std::sin(w) * std::sin(w)) : 0;
      return RgbD(f, f, f);
    };
    const Reflectance found = ambient_reflectance(disc, 1, 1e-5);
    EXPECT_LT(found.error, 1e-3) << w;
    EXPECT_NEAR(found.value.g, 1, 5 * found.error) << w;
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

TEST(AmbientReflectance, ATableIsItsEntriesOnAnyNumberOfThreads) {
  const Brdf surface = ggx_brdf(0.2, {0.9, 0.5, 0.1});
  const ReflectanceTable one = ambient_reflectance_table(surface, 9, 1e-6, {.threads = 1});
  for (const int threads : {2, 7}) {
    const ReflectanceTable many = ambient_reflectance_table(surface, 9, 1e-6, {.threads = threads});
    EXPECT_EQ(one.values, many.values);
    EXPECT_EQ(one.error, many.error);
  }
  for (std::size_t i = 0; i < 9; ++i) {
    const Reflectance entry = ambient_reflectance(surface, (static_cast<double>(i) + 0.5) / 9);
    EXPECT_EQ(entry.value, one.values[i]);
    EXPECT_LE(entry.error, one.error);
  }
}

TEST(AmbientReflectance, LightAndViewerStandAboveTheSurface) {
  std::atomic<int> seen = 0, wrong = 0;
  const Brdf watch = [&](Vec3 l, Vec3 v) {
    ++seen;
    if (!(l.z > 0 && v.z > 0 && v.y == 0 && std::abs(length(l) - 1) < 1e-14 && std::abs(length(v) - 1) < 1e-14))
      ++wrong;
    return RgbD(0.1, 0.1, 0.1);
  };
  for (const double n_dot_v : kCosines) (void)ambient_reflectance(watch, n_dot_v);
  EXPECT_GT(seen, 7 * 1000);
  EXPECT_EQ(wrong, 0);
}

TEST(AmbientReflectance, RefusesWhatHasNoMeaning) {
  const Brdf matte = lambert_brdf({1, 1, 1});
  for (const double n_dot_v : {0.0, -0.5, 1.0001, std::nan("")}) {
    EXPECT_THROW((void)ambient_reflectance(matte, n_dot_v), Error) << n_dot_v;
  }
  for (const double tolerance : {0.0, 1e-13, 2.0, std::nan("")}) {
    EXPECT_THROW((void)ambient_reflectance(matte, 1, tolerance), Error) << tolerance;
    EXPECT_THROW((void)ambient_reflectance_table(matte, 4, tolerance), Error) << tolerance;
  }
  for (const int size : {0, -1, 5000}) EXPECT_THROW((void)ambient_reflectance_table(matte, size), Error);
  const Brdf broken = [](Vec3 l, Vec3) { return RgbD(1, l.x > 0.5 ? std::nan("") : 1, 1); };
  EXPECT_THROW((void)ambient_reflectance(broken, 0.7), Error);
  EXPECT_THROW((void)ambient_reflectance_table(broken, 4), Error);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)ambient_reflectance_table(matte, 4, 1e-6, {.stop = stop.get_token()}), Error);
  EXPECT_THROW((void)lambert_brdf({1.1, 0, 0}), Error);
  EXPECT_THROW((void)phong_brdf(-1), Error);
  EXPECT_THROW((void)blinn_phong_brdf(std::nan("")), Error);
  EXPECT_THROW((void)ggx_brdf(0), Error);
  EXPECT_THROW((void)ggx_brdf(0.5, {0, -0.1, 0}), Error);
}

}  // namespace
}  // namespace zonal
