#include "zonal/light/fisheye_means.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "zonal/base/error.h"
#include "zonal/light/fisheye_pixels.h"
#include "zonal/light/fisheye_published.h"
#include "zonal/light/lobe.h"
#include "zonal/light/reference.h"
#include "zonal/light/resample.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

/// A photograph of size 2 radius + 1 of a sky without symmetry.
Environment photograph(int radius) {
  const int size = 2 * radius + 1;
  Environment e{Image<Rgb>(size, size), {Layout::kFisheye, {.radius_x_px = static_cast<double>(radius)}}};
  const Mapping mapping(e.projection, {size, size});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const auto d = mapping.texel_direction(x, y);
      if (!d) continue;
      const auto value = [&](double k) {
        return static_cast<float>(1.5 + std::sin(k * d->x) + 0.4 * std::cos(3 * d->y) * d->z);
      };
      e.radiance(x, y) = {value(1), value(2), value(3)};
    }
  }
  return e;
}

double worst(const std::vector<RgbD>& a, const std::vector<RgbD>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const RgbD d = a[i] - b[i];
    most = std::max({most, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
  }
  return most;
}

std::vector<Vec3> directions() {
  std::vector<Vec3> all;
  for (int i = 0; i < 60; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 60, side = std::sqrt(1 - z * z), azimuth = 2.4 * i;
    all.push_back({side * std::cos(azimuth), side * std::sin(azimuth), z});
  }
  return all;
}

/// The article's two loops, in double, word for word of its formulas.
RgbD as_written(const Environment& e, int center, int radius, double shininess, Rgb ground, Vec3 q) {
  RgbD sum;
  double weights = 0;
  for (int ys = center - radius; ys <= center + radius; ++ys) {
    for (int xs = center - radius; xs <= center + radius; ++xs) {
      const double s = static_cast<double>(xs - center) / radius, t = static_cast<double>(center - ys) / radius;
      const double r = std::sqrt(s * s + t * t), py = std::cos(r * kPi / 2);
      const double l = r > 0 ? std::sqrt(1 - py * py) / r : 0;
      const double pq = s * l * q.y + py * q.z + t * l * q.x;
      if (pq <= 0) continue;
      const double theta = std::acos(std::min(pq, 1.0));
      const double weight = std::pow(pq, shininess) * (theta > 0 ? std::sin(theta) / theta : 1);
      weights += weight;
      sum += weight * RgbD(r >= 1 ? ground : e.radiance(xs, ys));
    }
  }
  return (1 / weights) * sum;
}

TEST(FisheyeMeans, ArePublishedOnes) {
  constexpr int kRadius = 20;
  const Environment e = photograph(kRadius);
  const Rgb ground{0.2f, 0.5f, 0.1f};
  int compared = 0;
  for (const double shininess : {1.0, 2.5, 60.0}) {
    const std::vector<RgbD> means = fisheye_means(
        e, {shininess, ground, FisheyeWeights::kAngleToLobe, FisheyeGround::kSquareCorners}, directions());
    for (std::size_t i = 0; i < means.size(); ++i, ++compared) {
      const RgbD written = as_written(e, kRadius, kRadius, shininess, ground, directions()[i]);
      // Single precision, raised to the exponent.
      EXPECT_NEAR(means[i].r, written.r, 2e-6 * (1 + shininess)) << shininess << " " << i;
      EXPECT_NEAR(means[i].g, written.g, 2e-6 * (1 + shininess)) << shininess << " " << i;
      EXPECT_NEAR(means[i].b, written.b, 2e-6 * (1 + shininess)) << shininess << " " << i;
    }
  }
  EXPECT_EQ(compared, 180);
}

TEST(FisheyeMeans, CorrectedAreThoseOfAPhongLobeOverSkyAndGround) {
  const Environment e = photograph(20);
  const Rgb ground{0.2f, 0.5f, 0.1f};
  int compared = 0;
  for (const double shininess : {0.0, 1.0, 10.0}) {
    const auto sky = convolve_at(e, Lobe::phong(shininess), directions());
    Environment ones = e;
    for (Rgb& texel : ones.radiance.values()) texel = {1, 1, 1};
    const auto share = convolve_at(ones, Lobe::phong(shininess), directions());
    const auto means = fisheye_means(e, {.shininess = shininess, .ground = ground}, directions());
    std::vector<RgbD> expected;
    for (std::size_t i = 0; i < means.size(); ++i) {
      expected.push_back(sky[i] + RgbD(1 - share[i].r, 1 - share[i].g, 1 - share[i].b) * RgbD(ground));
      ++compared;
    }
    EXPECT_LT(worst(means, expected), 2e-5) << shininess;  // single precision
  }
  EXPECT_EQ(compared, 180);
}

TEST(FisheyeMeans, AConstantStaysInEveryForm) {
  Environment e = photograph(16);
  for (Rgb& texel : e.radiance.values()) texel = {0.5f, 0.5f, 0.5f};
  int forms = 0;
  for (const auto weights : {FisheyeWeights::kAngleToLobe, FisheyeWeights::kSolidAngle}) {
    for (const auto ground_by : {FisheyeGround::kSquareCorners, FisheyeGround::kWhole}) {
      const auto means = fisheye_means(e, {4, {0.5f, 0.5f, 0.5f}, weights, ground_by}, directions());
      EXPECT_LT(worst(means, std::vector<RgbD>(60, RgbD(0.5, 0.5, 0.5))), 1e-5);
      ++forms;
    }
  }
  EXPECT_EQ(forms, 4);
}

TEST(FisheyeMeans, SameBitsOnAnyThreadsAndNearlyOnAnyInstructionSet) {
  const Environment e = photograph(12);
  const FisheyeMeansOptions published{
      7, {0.2f, 0.2f, 0.2f}, FisheyeWeights::kAngleToLobe, FisheyeGround::kSquareCorners};
  zonal::Run one;
  one.threads = 1;
  const auto expected = fisheye_means(e, published, directions(), one);
  int runs = 0;
  for (const int threads : {2, 7}) {
    zonal::Run run;
    run.threads = threads;
    EXPECT_EQ(fisheye_means(e, published, directions(), run), expected);
    ++runs;
  }
  for (const Isa isa : available_isas()) {
    zonal::Run run;
    run.isa = isa;
    EXPECT_LT(worst(fisheye_means(e, published, directions(), run), expected), 1e-5);
    ++runs;
  }
  EXPECT_GE(runs, 3);
}

TEST(FisheyeMeans, NothingToCountIsGround) {
  // A lobe so sharp, around the nadir: the square's corners weigh less than float can tell.
  const Environment e = photograph(12);
  const Rgb ground{0.25f, 0.5f, 0.75f};
  const std::vector<Vec3> nadir = {{0, 0, -1}};
  const auto mean =
      fisheye_means(e, {5000, ground, FisheyeWeights::kAngleToLobe, FisheyeGround::kSquareCorners}, nadir);
  EXPECT_EQ(mean[0], RgbD(ground));
}

TEST(FisheyeMeans, RefusesWhatItCannotDo) {
  Environment e = photograph(12);
  const std::vector<Vec3> up = {{0, 0, 1}};
  int refused = 0;
  const auto refuses = [&](const FisheyeMeansOptions& options) {
    try {
      fisheye_means(e, options, up);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
      EXPECT_FALSE(error.hint().empty());
      ++refused;
    }
  };
  refuses({.shininess = -1});
  refuses({.shininess = 20000});
  refuses({.shininess = std::nan("")});
  e.projection.lens.model = LensModel::kEquisolid;
  refuses({.weights = FisheyeWeights::kAngleToLobe});
  refuses({.ground_by = FisheyeGround::kSquareCorners});
  EXPECT_EQ(fisheye_means(e, {}, up).size(), 1u);  // the corrected sum takes every lens
  e.projection = {Layout::kEquirect};
  refuses({});
  EXPECT_EQ(refused, 6);

  e = photograph(12);
  std::stop_source stop;
  stop.request_stop();
  zonal::Run run;
  run.stop = stop.get_token();
  EXPECT_THROW(fisheye_means(e, {}, up, run), Error);
}

}  // namespace
}  // namespace zonal
