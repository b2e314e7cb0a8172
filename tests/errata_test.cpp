// docs/errata.md: where a printed formula is said to be wrong, it is evaluated as printed here, beside what the library
// does.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <set>
#include <sstream>

#include "zonal/light/brdf.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/project_function.h"
#include "zonal/sh/window.h"
#include "zonal/sh/zonal_lights.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

double random_value() {
  static std::mt19937 random(5);
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

TEST(Errata, CosineRecurrenceSubtracts) {
  // y_2,2 = 1/4 sqrt(15/pi) C(2), with C(1) = x and S(1) = y.
  const Vec3 d = normalize({1, 2, 0.5});
  Sh<double, 3> one;
  one(2, 2) = 1;
  const double k = std::sqrt(15 / kPi) / 4, truth = evaluate(one, d);
  EXPECT_NEAR(k * (d.x * d.x - d.y * d.y), truth, 1e-15);
  EXPECT_GT(std::abs(k * (d.x * d.x + d.y * d.y) - truth), 0.5) << "as printed";
}

TEST(Errata, CoefficientsOfConesAndSmoothCones) {
  const double a = radians(30), c = std::cos(a), s = std::sin(a);
  const std::vector<double> cone = cone_zonal(a, 6), smooth = smooth_cone_zonal(a, 6);
  const double band3 = std::sqrt(7.0) / 8 * std::sqrt(kPi) * (1 - c * c);
  EXPECT_NEAR(band3 * (5 * c * c - 1), cone[3], 1e-15);
  EXPECT_GT(std::abs(band3 * (7 * c * c - 3) - cone[3]), 0.05) << "as printed";

  const double q = std::sqrt(kPi) / (a * a * a);
  EXPECT_NEAR(q * std::sqrt(3.0) / 4 * (a * a * a + 3 * a * c * c - 3 * c * s), smooth[1], 1e-13);
  EXPECT_NEAR(q * std::sqrt(3.0) / 4 * (a * a * a + 3 * a * c * c + 3 * c * s), 14.01, 0.005) << "as printed";
  const auto band2 = [&](int power) {
    return q * std::sqrt(5.0) / 9 * (3 * a * std::pow(c, power) - 9 * a * c - 6 * a - 2 * c * c * s + 14 * s);
  };
  EXPECT_NEAR(band2(3), smooth[2], 1e-13);
  EXPECT_NEAR(band2(2), 0.6303, 5e-5) << "as printed";

  // Without sin(theta) the integral that starts the section is another one: y_0 times 2 pi a.
  EXPECT_NEAR(cone_zonal(radians(60), 1)[0], 0.886, 5e-4);
  EXPECT_NEAR(std::sqrt(1 / (4 * kPi)) * 2 * kPi * radians(60), 1.856, 5e-4) << "as printed";
}

TEST(Errata, AmbientLightOfTheFit) {
  // Ambient 0.7 and a directional light of 1.3, three bands; both normalised to reflect one.
  const Vec3 d = normalize({1, -1, 1});
  const Sh<double> unit = irradiance_over_pi(project_function([](Vec3) { return 1.0; }, 3, 0));
  Sh<double> light(3);
  basis<double>(3, d, light.values());
  light = irradiance_over_pi((16 * kPi / 17) * light);
  const Sh<double> probe = 0.7 * unit + 1.3 * light;
  double with_light = 0;
  for (std::size_t i = 1; i < 9; ++i) with_light += probe[i] * light[i];
  const double c = 867 / (316 * kPi) * with_light, rest = probe[0] - c * 8 * std::sqrt(kPi) / 17;
  EXPECT_NEAR(c, 1.3, 1e-14);
  EXPECT_NEAR(rest / (2 * std::sqrt(kPi)), 0.7, 1e-14);
  EXPECT_NEAR(rest * std::sqrt(kPi) / 2, 2.199, 5e-4) << "as printed";

  // The Hessian: 2 [[A, B], [B, C]] of these two.
  double aa = 0, ab = 0, bb = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    aa += light[i] * light[i];
    ab += light[i] * unit[i];
    bb += unit[i] * unit[i];
  }
  EXPECT_NEAR(aa, 508 * kPi / 867, 1e-14);
  EXPECT_NEAR(ab, 16 * kPi / 17, 1e-14);
  EXPECT_NEAR(bb, 4 * kPi, 1e-14);
  const double middle = aa + bb, root = std::hypot(aa - bb, 2 * ab);
  EXPECT_NEAR(middle - root, 2.16, 0.005);
  EXPECT_NEAR(middle + root, 26.65, 0.005);
}

TEST(Errata, JacobianOfNormalisationHasCubes) {
  const Vec3 s = {1, 2, 3};
  const double size = length(s), step = 1e-6;
  const double slope = (normalize({s.x, s.y + step, s.z}).x - normalize({s.x, s.y - step, s.z}).x) / (2 * step);
  EXPECT_NEAR(-s.x * s.y / (size * size * size), slope, 1e-9);
  EXPECT_NEAR(-s.x * s.y / size, -0.5345, 5e-5) << "as printed, without the cube";
  EXPECT_NEAR(slope, -0.0382, 5e-5);
}

TEST(Errata, SquaredLaplacianSumsWholeBands) {
  Sh<double> sh(6);
  for (double& c : sh.values()) c = random_value();
  const auto from = [&](bool whole) {
    double sum = 0;
    for (int l = 1; l < 6; ++l) {
      for (int m = whole ? -l : -1; m <= l; ++m) sum += std::pow(l * (l + 1) * sh(l, m), 2);
    }
    return sum;
  };
  EXPECT_NEAR(squared_laplacian(sh) / from(true), 1, 1e-14);
  EXPECT_LT(from(false), 0.9 * from(true)) << "as printed";
}

TEST(Errata, CubeSumsAreDividedByOneFace) {
  constexpr int kSize = 64;
  double sum = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double u = (2 * x + 1.0) / kSize - 1, v = (2 * y + 1.0) / kSize - 1;
      sum += 6 * 4 / std::pow(1 + u * u + v * v, 1.5);
    }
  }
  EXPECT_NEAR(sum / (kSize * kSize), 4 * kPi, 1e-4 * 4 * kPi);
  EXPECT_LT(sum / (6 * kSize * kSize), 4 * kPi / 5) << "as printed";
}

TEST(Errata, ReflectedLightOfASmallSourceNeedsTheBrdf) {
  const Vec3 v = normalize({1, 0, 1}), l = normalize({-1, 0.3, 0.8});
  const Brdf glossy = phong_brdf(20);
  const double radius = radians(1), irradiance_facing = kPi * std::pow(std::sin(radius), 2);
  // Over the disc: 400 directions spread evenly over its solid angle.
  const Vec3 side = normalize(cross(l, {0, 0, 1})), up = cross(side, l);
  double exact = 0;
  constexpr int kRings = 20, kSteps = 20;
  for (int i = 0; i < kRings; ++i) {
    const double c = 1 - (1 - std::cos(radius)) * (i + 0.5) / kRings, s = std::sqrt(1 - c * c);
    for (int k = 0; k < kSteps; ++k) {
      const double phi = 2 * kPi * (k + 0.5) / kSteps;
      const Vec3 at = c * l + s * std::cos(phi) * side + s * std::sin(phi) * up;
      exact += glossy(at, v).g * at.z * 2 * kPi * (1 - std::cos(radius)) / (kRings * kSteps);
    }
  }
  EXPECT_NEAR(glossy(l, v).g * irradiance_facing * l.z / exact, 1, 0.01);
  EXPECT_GT(std::abs(irradiance_facing * l.z / exact - 1), 0.2) << "as printed";
}

TEST(Errata, BackOfTheDualParaboloidIsNotMirrored) {
  const Mapping mapping({Layout::kDualParaboloid}, {512, 256});
  // In that chapter's frame the front looks along +z, x to the right, y up; ours looks along +X.
  const Vec3 r = normalize({0.3, 0.4, -0.8});
  const auto p = mapping.position({r.z, -r.x, r.y});
  ASSERT_TRUE(p);
  const double u = p->x / 256 - 1, v = 1 - p->y / 256;
  const auto through =
      [&](double sign) {  // rows (1 0 -s s), (0 1 -s s), (0 0 -2s 2s) of (r, 1), s = 1 or as printed -1
        const double q = sign * 2 * (1 - r.z);
        return std::pair((r.x + sign * (1 - r.z)) / q, (r.y + sign * (1 - r.z)) / q);
      };
  EXPECT_NEAR(through(1).first, u, 1e-14);
  EXPECT_NEAR(through(1).second, v, 1e-14);
  EXPECT_NEAR(through(-1).first, 1 - u, 1e-14) << "as printed";
  EXPECT_NEAR(through(-1).second, 1 - v, 1e-14) << "as printed";
}

TEST(Errata, TexelsOfAFisheyeAndAPanorama) {
  // An equidistant fisheye of 180 degrees, radius 1000 texels: (pi/2)^2 sinc(zenith angle) to the unit of its disc.
  const Mapping fisheye({Layout::kFisheye, {LensModel::kEquidistant, 180}}, {2001, 2001});
  const double t = radians(60), x = 1000 + 1000.5 * 60 / 90;
  const double texel = fisheye.solid_angle(static_cast<int>(x), 1000) * 1000.5 * 1000.5;
  EXPECT_NEAR(texel, kPi * kPi / 4 * std::sin(t) / t, 2e-3);
  // As printed the angle is that to the normal q: 1 where the two coincide.
  EXPECT_GT(std::abs(kPi * kPi / 4 / texel - 1), 0.2);

  constexpr int kWidth = 64, kHeight = 32;
  double first = 0, corrected = 0;
  for (int j = 0; j < kHeight; ++j) {
    const double sine = std::sin((j + 0.5) * kPi / kHeight);
    first += 2 * kPi / (kWidth * kHeight) * sine * kWidth;
    corrected += 2 * kPi * kPi / (kWidth * kHeight) * sine * kWidth;
  }
  EXPECT_NEAR(corrected, 4 * kPi, 1e-3 * 4 * kPi);
  EXPECT_NEAR(first, 4, 0.01) << "the first reply";
}

// Every test that the page names is there.
TEST(Errata, NamesTestsThatExist) {
  const std::filesystem::path source = ZONAL_SOURCE_DIR;
  std::stringstream page;
  page << std::ifstream(source / "docs/errata.md").rdbuf();
  std::set<std::string> tests;
  const std::regex definition(R"(TEST(?:_F)?\((\w+),\s*(\w+)\))");
  for (const char* folder : {"zonal", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      std::stringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      const std::string words = text.str();
      for (std::sregex_iterator it(words.begin(), words.end(), definition), end; it != end; ++it) {
        tests.insert((*it)[1].str() + "." + (*it)[2].str());
      }
    }
  }
  const std::string words = page.str();
  const std::regex mention(R"(`(\w+\.\w+)`)");
  int named = 0;
  for (std::sregex_iterator it(words.begin(), words.end(), mention), end; it != end; ++it, ++named) {
    EXPECT_TRUE(tests.contains((*it)[1].str())) << (*it)[1].str();
  }
  EXPECT_GT(named, 30);
}

}  // namespace
}  // namespace zonal
