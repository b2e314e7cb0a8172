#include "zonal/image/deghost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/image/merge_exposures.h"
#include "zonal/image/synthetic_bracket_test.h"

namespace zonal {
namespace {

constexpr int kWidth = 240, kHeight = 180, kSize = 28;

struct Place {
  int x, y;
};

bool inside(Place p, int x, int y, int margin = 0) {
  return x >= p.x - margin && x < p.x + kSize + margin && y >= p.y - margin && y < p.y + kSize + margin;
}

/// The scene with a bright and a dark square in it.
Image<Rgb> scene_with(Place bright, Place dark) {
  Image<Rgb> scene = sample::scene(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (inside(bright, x, y)) scene(x, y) = {20, 20, 20};
      if (inside(dark, x, y)) scene(x, y) = {0.02f, 0.02f, 0.02f};
    }
  }
  return scene;
}

/// Where the squares are in exposure k.
Place bright_at(int k) { return {20 + 36 * k, 30}; }
Place dark_at(int k) { return {160 - 36 * k, 110}; }

struct Moving {
  std::vector<Image<Rgb>> moments;
  Exposures bracket;
};

Moving moving_scene() {
  Moving m;
  const std::vector<double> times = sample::five_times();
  for (int k = 0; k < 5; ++k) {
    m.moments.push_back(scene_with(bright_at(k), dark_at(k)));
    m.bracket.push_back(
        {"", times[k], CodedPicture(sample::photograph(m.moments[k], {sample::srgb_camera, 1.0}, times[k]))});
  }
  return m;
}

/// How many texels of a part are off by more than a third of a stop.
template <class Part>
std::pair<int, int> ghosts(const Image<Rgb>& merged, const Image<Rgb>& truth, Part part) {
  int off = 0, all = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (!part(x, y)) continue;
      ++all;
      off += std::abs(std::log2(merged(x, y).g / truth(x, y).g)) > 1.0 / 3;
    }
  }
  return {off, all};
}

TEST(Deghost, RemovesWhatMoved) {
  const Moving scene = moving_scene();
  const Deghosting deghosting = deghost(scene.bracket, Response::srgb());
  const Image<Rgb>& moment = scene.moments[deghosting.reference];
  const Image<Rgb> plain = merge_exposures(scene.bracket, Response::srgb()).radiance,
                   clean = merge_exposures(scene.bracket, Response::srgb(), {.masks = deghosting.masks}).radiance;
  // Where something stood in another moment than the one that is shown, and the reference shows what is there now.
  const Image<Rgb> reference =
      sample::photograph(moment, {sample::srgb_camera}, scene.bracket[deghosting.reference].seconds);
  const auto moved = [&](int x, int y) {
    if (reference(x, y).g < 16.0f / 255 || reference(x, y).g > 239.0f / 255) return false;
    for (int k = 0; k < 5; ++k) {
      if (k != deghosting.reference && (inside(bright_at(k), x, y) || inside(dark_at(k), x, y))) return true;
    }
    return false;
  };
  const auto [before, area] = ghosts(plain, moment, moved);
  const auto [after, same_area] = ghosts(clean, moment, moved);
  EXPECT_GT(area, 2000);
  EXPECT_EQ(area, same_area);
  EXPECT_GT(before, area / 5);
  // A texel that a mask's smooth rim does not reach, now and then.
  EXPECT_LT(after, area / 200);
}

TEST(Deghost, LeavesStillScenesAlone) {
  const Exposures bracket =
      sample::bracket(sample::scene(kWidth, kHeight), {sample::srgb_camera, 1.0}, sample::nine_times());
  const Deghosting deghosting = deghost(bracket, Response::srgb());
  ASSERT_EQ(deghosting.left_out.size(), 9u);
  for (const double share : deghosting.left_out) EXPECT_LT(share, 1e-3);
  for (const Image<std::uint8_t>& mask : deghosting.masks) {
    EXPECT_EQ(mask.width(), kWidth);
    EXPECT_EQ(mask.height(), kHeight);
  }
}

TEST(Deghost, MeasuresTheNoise) {
  int measured = 0;
  for (const double noise : {2.0, 6.0}) {
    const Exposures bracket =
        sample::bracket(sample::scene(kWidth, kHeight), {sample::srgb_camera, noise}, sample::nine_times());
    const Deghosting deghosting = deghost(bracket, Response::srgb());
    EXPECT_NEAR(deghosting.noise_codes / noise, 1, 0.2);
    // Six codes are not little against a code of 13, the darkest that is compared.
    for (const double share : deghosting.left_out) EXPECT_LT(share, 0.01) << noise;
    ++measured;
  }
  EXPECT_EQ(measured, 2);
}

TEST(Deghost, TheReferenceIsTheBestExposed) {
  const Exposures bracket =
      sample::bracket(Image<Rgb>(32, 32, {0.2f, 0.2f, 0.2f}), {sample::srgb_camera}, {0.01, 1, 30});
  EXPECT_EQ(deghost(bracket, Response::srgb()).reference, 1);
}

TEST(Deghost, BlackAndTinyPicturesAreSafe) {
  const Exposures black = sample::bracket(Image<Rgb>(1, 1), {sample::srgb_camera}, {1, 2});
  const Deghosting deghosting = deghost(black, Response::srgb());
  EXPECT_EQ(deghosting.noise_codes, 1);
  EXPECT_EQ(deghosting.masks[1](0, 0), 255);
}

}  // namespace
}  // namespace zonal
