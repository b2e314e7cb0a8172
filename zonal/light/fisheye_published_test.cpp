#include "zonal/light/fisheye_published.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "zonal/light/fisheye_means.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

const std::filesystem::path kFile = ZONAL_SOURCE_DIR "/../shared/reference/vectors/irradiance_program.json";

struct Sky {
  std::string name;
  std::function<double(Vec3)> radiance;
  double ambient;
};

/// A lobe of 50 at its greatest that falls to 1/e at 6 degrees, at azimuth 0.3 from the photograph's right. (The
/// published figures do not say how their sun looks: this is the one that repeats all of them.)
Sky with_sun(const std::string& zenith_deg) {
  const double t = radians(std::stod(zenith_deg)), azimuth = 0.3;
  const Vec3 sun{std::sin(t) * std::sin(azimuth), std::sin(t) * std::cos(azimuth), std::cos(t)};
  const double width = 1 - std::cos(radians(6));
  return {"sky .2 + sun " + zenith_deg + "deg zenith",
          [=](Vec3 d) { return 0.2 + 50 * std::exp((dot(d, sun) - 1) / width); }, 0.1};
}

const std::vector<Sky>& nine_skies() {
  const auto one = [](Vec3) { return 1.0; };
  static const std::vector<Sky> kSkies = {
      {"constant 1, ambient 0", one, 0},
      {"constant 1, ambient 1", one, 1},
      {"constant 1, ambient 0.3", one, 0.3},
      {"overcast (1+2cos)/3, amb 0.2", [](Vec3 d) { return (1 + 2 * d.z) / 3; }, 0.2},
      {"horizon-bright 1-0.8cos, amb 0.2", [](Vec3 d) { return 1 - 0.8 * d.z; }, 0.2},
      {"half sky x>0, amb 0", [](Vec3 d) { return d.y > 1e-9    ? 1.0
                                                  : d.y < -1e-9 ? 0.0
                                                                : 0.5; }, 0},
      with_sun("20"),
      with_sun("60"),
      with_sun("80")};
  return kSkies;
}

/// With a pixel in the centre. A little beyond the circle the sky goes on, for the pixels that the rim cuts.
Environment photograph(const Sky& sky, int radius) {
  const int size = 2 * radius + 1;
  Environment e{Image<Rgb>(size, size), {Layout::kFisheye, {.radius_x_px = static_cast<double>(radius)}}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double s = static_cast<double>(x - radius) / radius, t = static_cast<double>(radius - y) / radius;
      const double r = std::hypot(s, t), angle = r * kPi / 2, side = r > 0 ? std::sin(angle) / r : 0;
      if (r > 1.05) continue;
      const float value = static_cast<float>(sky.radiance({t * side, s * side, std::cos(angle)}));
      e.radiance(x, y) = {value, value, value};
    }
  }
  return e;
}

std::vector<Vec3> above_horizon(int size_px) {
  std::vector<Vec3> all = published_paraboloid_directions(size_px);
  std::erase_if(all, [](const Vec3& q) { return !(q.z > 1e-12); });
  return all;
}

/// In per cent of the exact map's maximum.
struct Error {
  double rms = 0, most = 0;
};
Error error_of(const std::vector<RgbD>& got, const std::vector<RgbD>& exact) {
  double sum = 0, most = 0, full = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double d = got[i].r - exact[i].r;
    sum += d * d;
    most = std::max(most, std::abs(d));
    full = std::max(full, exact[i].r);
  }
  return {100 * std::sqrt(sum / static_cast<double>(exact.size())) / full, 100 * most / full};
}

struct Errors {
  Error published, ground_alone, weights_alone;  // weights alone: of the means over the sky, without any ground
};

/// Of a sky for one shininess: a photograph of radius 100, a map of 25 x 25 pixels.
Errors errors_of(const Sky& sky, double shininess) {
  const Environment coarse = photograph(sky, 100), fine = photograph(sky, 200);
  const Sky white{"", [](Vec3) { return 1.0; }, 0};
  const Environment whole = photograph(white, 200);
  const std::vector<Vec3> toward = above_horizon(25);
  const float ambient = static_cast<float>(sky.ambient);
  const auto means = [&](const Environment& e, FisheyeWeights weights, FisheyeGround ground_by, float ground) {
    return fisheye_means(e, {shininess, {ground, ground, ground}, weights, ground_by}, toward);
  };
  using enum FisheyeWeights;
  using enum FisheyeGround;
  const auto exact = means(fine, kSolidAngle, kWhole, ambient);
  Errors errors;
  errors.published = error_of(means(coarse, kAngleToLobe, kSquareCorners, ambient), exact);
  errors.ground_alone = error_of(means(coarse, kSolidAngle, kSquareCorners, ambient), exact);
  auto right = means(fine, kSolidAngle, kWhole, 0), wrong = means(fine, kAngleToLobe, kWhole, 0);
  const auto share = means(whole, kSolidAngle, kWhole, 0);
  for (std::size_t i = 0; i < share.size(); ++i) {
    right[i] = (1 / share[i].r) * right[i];
    wrong[i] = (1 / share[i].r) * wrong[i];
  }
  errors.weights_alone = error_of(wrong, right);
  return errors;
}

TEST(FisheyePublished, DirectionsAreTheArticles) {
  const std::vector<Vec3> upper = published_paraboloid_directions(5), lower = published_paraboloid_directions(5, true);
  ASSERT_EQ(upper.size(), 25u);
  EXPECT_EQ(upper[12], (Vec3{0, 0, 1}));     // the zenith in the middle
  EXPECT_EQ(upper[14], (Vec3{0, 1, 0}));     // on the right edge the photograph's right, on the horizon
  EXPECT_EQ(upper[2], (Vec3{1, 0, 0}));      // at the top its up
  EXPECT_NEAR(upper[0].z, -1.0 / 3, 1e-15);  // the corners: 109.47 degrees
  int compared = 0;
  for (std::size_t i = 0; i < upper.size(); ++i, ++compared) {
    EXPECT_NEAR(length(upper[i]), 1, 1e-15);
    EXPECT_EQ(lower[i], (Vec3{upper[i].x, upper[i].y, -upper[i].z}));
  }
  EXPECT_EQ(compared, 25);
}

TEST(FisheyePublished, OutsideOfTheCircleIsWhatWasAsked) {
  const Environment e = photograph(nine_skies()[4], 20);
  PublishedOptions options{.shininess = 2, .ground = {0.3f, 0.2f, 0.1f}, .size_px = 15};
  const Image<Rgb> ground = published_paraboloid(e, options);
  options.outside = FisheyeOutside::kExtended;
  const Image<Rgb> extended = published_paraboloid(e, options);
  options.outside = FisheyeOutside::kTwo;
  const Image<Rgb> two = published_paraboloid(e, options);
  ASSERT_EQ(two.width(), 30);
  int inside = 0, outside = 0;
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 15; ++x) {
      EXPECT_EQ(two(x, y), extended(x, y));
      if (published_paraboloid_directions(15)[static_cast<std::size_t>(15 * y + x)].z > 0) {
        EXPECT_EQ(ground(x, y), extended(x, y));
        ++inside;
      } else {
        EXPECT_EQ(ground(x, y), options.ground);
        EXPECT_GT(extended(x, y).b, options.ground.b);  // it sees some of the sky
        ++outside;
      }
    }
  }
  EXPECT_EQ(inside + outside, 225);
  EXPECT_GT(outside, 40);
  // Horizon, corners of both: the same directions but for the side. The nadir sees the ground's corners only.
  EXPECT_EQ(two(15 + 7, 7), options.ground);
}

TEST(FisheyePublished, GreyLevelsAreRoundedAndTheGroundIsCut) {
  const Environment e = photograph(nine_skies()[4], 12);
  const PublishedOptions exact{.ground = {0.3f, 0.2f, 0.999f}, .size_px = 9};
  PublishedOptions rounded = exact;
  rounded.grey_levels = true;
  const Image<Rgb> values = published_paraboloid(e, exact), levels = published_paraboloid(e, rounded);
  int compared = 0;
  for (int y = 1; y < 8; ++y) {
    for (int x = 1; x < 8; ++x) {
      const bool outside = values(x, y) == exact.ground;
      if (!outside) {
        EXPECT_FLOAT_EQ(255 * levels(x, y).g, std::round(255 * values(x, y).g));
      }
      ++compared;
    }
  }
  EXPECT_EQ(compared, 49);
  // 76.5, 51 and 254.7 of 255, as integers.
  EXPECT_FLOAT_EQ(255 * levels(0, 0).r, 76);
  EXPECT_FLOAT_EQ(255 * levels(0, 0).g, 51);
  EXPECT_FLOAT_EQ(255 * levels(0, 0).b, 254);
}

TEST(FisheyePublished, FirstVersionIsTheDiscOfTheSameMeansWhereItsWindowIsTheSquare) {
  // In the zenith both programs sum over the same pixels with the same weights, but for the square's last row and
  // column.
  const Environment e = photograph(nine_skies()[3], 30);
  const PublishedOptions options{.shininess = 20, .ground = {0.1f, 0.1f, 0.1f}, .size_px = 61};
  const Image<Rgb> disc = first_published_disc(e, options);
  const std::vector<Vec3> zenith = {{0, 0, 1}};
  const auto mean = fisheye_means(
      e, {options.shininess, options.ground, FisheyeWeights::kAngleToLobe, FisheyeGround::kSquareCorners}, zenith);
  EXPECT_NEAR(disc(30, 30).r, mean[0].r, 1e-6);
  EXPECT_EQ(disc(0, 0), options.ground);
  // Right and left, top and bottom alike: the sky is symmetric, and so is a window of an odd number of pixels.
  EXPECT_NEAR(disc(50, 30).g, disc(10, 30).g, 1e-6);
  EXPECT_NEAR(disc(30, 50).g, disc(30, 10).g, 1e-6);
  EXPECT_NEAR(disc(30, 50).g, disc(50, 30).g, 1e-6);
}

TEST(FisheyePublished, IsReadAsATexture) {
  // A ramp along u and v: what a linear lookup reads is the coordinate itself, away from the border.
  constexpr int kSize = 32;
  Image<Rgb> ramp(2 * kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < 2 * kSize; ++x) {
      ramp(x, y) = {(static_cast<float>(x % kSize) + 0.5f) / kSize, (static_cast<float>(y) + 0.5f) / kSize,
                    x < kSize ? 0.0f : 1.0f};
    }
  }
  const Rgb ground{9, 9, 9};
  const Environment read = read_paraboloid(ramp, ground, {Layout::kEquirect}, {64, 32});
  const Mapping mapping({Layout::kEquirect}, {64, 32});
  int compared = 0;
  for (int y = 0; y < 32; ++y) {
    if (y == 15 || y == 16) continue;  // the horizon lies at the border
    for (int x = 0; x < 64; ++x, ++compared) {
      const Vec3 d = *mapping.direction({x + 0.5, y + 0.5});
      const Rgb got = read.radiance(x, y);
      EXPECT_NEAR(got.r, 0.5 + d.y / (2 * (1 + std::abs(d.z))), 1e-6);
      EXPECT_NEAR(got.g, 0.5 - d.x / (2 * (1 + std::abs(d.z))), 1e-6);
      EXPECT_EQ(got.b, d.z < 0 ? 1 : 0);
    }
  }
  EXPECT_EQ(compared, 30 * 64);
  Image<Rgb> one(kSize, kSize, Rgb{1, 1, 1});
  EXPECT_EQ(read_paraboloid(one, ground, {Layout::kEquirect}, {64, 32}).radiance(5, 31), ground);  // far below
}

TEST(SlowFisheyePublished, ErrsAsWasMeasured) {
  if (!std::filesystem::exists(kFile)) GTEST_SKIP() << "no reference vectors here";
  std::ifstream file(kFile);
  const nlohmann::json reference = nlohmann::json::parse(file);
  int compared = 0;
  for (const nlohmann::json& entry : reference.at("errors")) {
    const std::string name = entry.at("sky");
    const auto sky = std::ranges::find_if(nine_skies(), [&](const Sky& s) { return s.name == name; });
    ASSERT_NE(sky, nine_skies().end()) << name;
    const Errors errors = errors_of(*sky, entry.at("s"));
    // The exact maps come from different quadratures: each is right to some 1e-4 of its greatest value.
    EXPECT_NEAR(errors.published.rms, entry.at("published_rms_pct").get<double>(), 0.02) << name << entry.at("s");
    EXPECT_NEAR(errors.published.most, entry.at("published_max_pct").get<double>(), 0.02) << name << entry.at("s");
    EXPECT_NEAR(errors.ground_alone.rms, entry.at("sinc_zenith_square_rms_pct").get<double>(), 0.02) << name;
    EXPECT_NEAR(errors.ground_alone.most, entry.at("sinc_zenith_square_max_pct").get<double>(), 0.02) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 27);
}

/// Of the weights alone, over the sky alone: RMS and largest in per cent, for shininess 1, 10, 100.
TEST(SlowFisheyePublished, WeightsAloneErrAsWasMeasured) {
  struct Row {
    int sky;
    double rms[3], most[3];
  };
  const Row rows[] = {{3, {3.4, 1.3, 0.2}, {3.8, 1.6, 0.3}},
                      {4, {4.8, 1.8, 0.3}, {5.5, 2.2, 0.4}},
                      {5, {1.9, 0.3, 0.03}, {3.6, 0.7, 0.2}},
                      {7, {2.6, 1.5, 0.2}, {7.0, 6.3, 2.0}},
                      {8, {6.7, 1.4, 0.2}, {20.9, 6.6, 1.8}}};
  int compared = 0;
  for (const Row& row : rows) {
    for (int i = 0; i < 3; ++i, ++compared) {
      const Sky& sky = nine_skies()[static_cast<std::size_t>(row.sky)];
      const Error error = errors_of(sky, std::pow(10, i)).weights_alone;
      // One digit after the point, and the rim of a grid of pixels.
      EXPECT_NEAR(error.rms, row.rms[i], 0.12) << sky.name << " " << i;
      EXPECT_NEAR(error.most, row.most[i], 0.12) << sky.name << " " << i;
    }
  }
  EXPECT_EQ(compared, 15);
}

}  // namespace
}  // namespace zonal
