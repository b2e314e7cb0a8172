#include "zonal/report/marked_panorama.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

Image<Rgb> uniform(float radiance, int width = 1024) { return {width, width / 2, {radiance, radiance, radiance}}; }

bool is_bright(Rgb8 c) { return c.r > 200 && c.g > 160 && c.b < 110; }  // the core's yellow, softened at most
bool is_dark(Rgb8 c) { return c.r < 60 && c.g < 60 && c.b < 60; }

Vec3 direction_at(const Image<Rgb8>& picture, int x, int y) {
  return *Mapping({Layout::kEquirect}, {picture.width(), picture.height()}).direction(center_of({x, y}));
}

/// Pixels of the lines' colour that lie on the circle, and those that lie elsewhere.
struct Found {
  int on = 0, off = 0;
};

Found look_for_circle(const Image<Rgb8>& picture, const PanoramaMark& mark) {
  Found found;
  const double pixel = kPi / picture.height();
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (!is_bright(picture(x, y))) continue;
      const double off = std::abs(angle_between(direction_at(picture, x, y), mark.direction) - mark.half_angle);
      ++(off <= 2 * pixel ? found.on : found.off);
    }
  }
  return found;
}

TEST(MarkedPanorama, ACircleIsThatOfTheSphere) {
  // 20 degrees around: on the equator, across the seam, next to a pole, around a pole.
  const double radius = radians(20);
  const std::array<Vec3, 4> centers = {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, normalize(Vec3{0.3, 0.3, 1}), Vec3{0, 0, -1}};
  int circles = 0;
  for (const Vec3 center : centers) {
    const PanoramaMark mark{center, radius, 1};
    const std::array marks = {mark};
    const Image<Rgb8> picture = marked_panorama(uniform(1), marks);
    const Found found = look_for_circle(picture, mark);
    // The shortest is 2 pi 57 pixels long; a core is one or two pixels wide.
    EXPECT_GT(found.on, 500) << center.z;
    // The digit 1 is two strokes, together 15 pixels high and one or two wide.
    EXPECT_GT(found.off, 12) << center.z;
    EXPECT_LT(found.off, 60) << center.z;
    // Every direction on the circle has its pixel.
    const Mapping mapping({Layout::kEquirect}, {picture.width(), picture.height()});
    const Vec3 side = normalize(cross(center, Vec3{0.1, 0.9, 0.2}));
    for (int i = 0; i < 360; ++i) {
      const Vec3 out = Rotation::about(center, radians(i)) * side;
      const Texel t = mapping.nearest(std::cos(radius) * center + std::sin(radius) * out);
      const Rgb8 c = picture(t.x, t.y);
      EXPECT_TRUE(is_bright(c)) << i;
      ++circles;
    }
  }
  EXPECT_EQ(circles, 4 * 360);
}

TEST(MarkedPanorama, LinesShowOnBrightAndOnDark) {
  const std::array marks = {PanoramaMark{{1, 0, 0}, 0.3, 7}};
  for (const float radiance : {0.0f, 1e-3f, 1.0f, 1e6f}) {
    Image<Rgb> panorama = uniform(radiance);
    for (int y = 0; y < panorama.height(); ++y) panorama(0, y) = {1, 1, 1};  // something to expose for
    const Image<Rgb8> picture = marked_panorama(panorama, marks);
    const auto bright = std::ranges::count_if(picture.values(), is_bright);
    EXPECT_GT(bright, 500) << radiance;
    // On white there is a dark border as well.
    if (radiance > 0.5f) {
      EXPECT_GT(std::ranges::count_if(picture.values(), is_dark), 300) << radiance;
    }
  }
}

TEST(MarkedPanorama, EveryDigitIsAnother) {
  std::vector<Image<Rgb8>> drawn;
  for (int digit = 0; digit < 10; ++digit) {
    const std::array marks = {PanoramaMark{{1, 0, 0}, 0, digit}};
    drawn.push_back(marked_panorama(uniform(1), marks));
  }
  int compared = 0;
  for (int a = 0; a < 10; ++a) {
    for (int b = 0; b < a; ++b, ++compared) EXPECT_NE(drawn[a], drawn[b]) << a << " " << b;
  }
  EXPECT_EQ(compared, 45);
  // Two digits take about twice the ink of one.
  const std::array eight = {PanoramaMark{{1, 0, 0}, 0, 8}}, many = {PanoramaMark{{1, 0, 0}, 0, 888}};
  const auto ink = [](const auto& marks) {
    const Image<Rgb8> picture = marked_panorama(uniform(1), marks);
    return std::ranges::count_if(picture.values(), is_bright);
  };
  EXPECT_GT(ink(many) - ink(eight), 100);
}

TEST(MarkedPanorama, NumbersStandInsideAndApart) {
  // All places where there is little room, and several marks at one.
  std::vector<PanoramaMark> marks;
  for (const Vec3 d : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{-1, 0, 0}, Vec3{-1, 1e-9, 0}, Vec3{1, 0, 0}, Vec3{1, 0, 0}})
    marks.push_back({d, 0.02, static_cast<int>(marks.size()) + 10});
  const Image<Rgb> panorama = uniform(1);
  Image<Rgb8> picture = marked_panorama(panorama, marks);
  EXPECT_EQ(picture.width(), 1024);
  // Each number adds ink that the others do not cover.
  int changed = 0;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    std::vector<PanoramaMark> fewer = marks;
    fewer[i].number = 1;
    const Image<Rgb8> other = marked_panorama(panorama, fewer);
    changed += !std::ranges::equal(other.values(), picture.values());
  }
  EXPECT_EQ(changed, 6);
}

TEST(MarkedPanorama, WithoutMarksItIsThePictureAndSmallOnesAreEnlarged) {
  const Image<Rgb> small(100, 50, {0.25f, 0.25f, 0.25f});
  const Image<Rgb8> picture = marked_panorama(small, {});
  EXPECT_EQ(picture.width(), 1100);
  EXPECT_EQ(picture.height(), 550);
  EXPECT_EQ(std::ranges::count(picture.values(), picture(0, 0)), 1100 * 550);
  EXPECT_NE(picture(0, 0), Rgb8{});
  EXPECT_EQ(marked_panorama(Image<Rgb>(1, 1), {}).width(), 1024);
  // Shapes beyond reason are not enlarged beyond reason.
  EXPECT_EQ(marked_panorama(Image<Rgb>(1, 16384), {}).height(), 16384);
}

TEST(MarkedPanorama, ValuesThatAreNotFiniteAreDrawnToo) {
  Image<Rgb> panorama = uniform(1);
  panorama(3, 3) = {std::nanf(""), 1, 1};
  panorama(4, 3) = {INFINITY, -INFINITY, 1};
  const std::array marks = {PanoramaMark{{1, 0, 0}, 0.3, 7}};
  EXPECT_GT(std::ranges::count_if(marked_panorama(panorama, marks).values(), is_bright), 500);
}

TEST(MarkedPanorama, RefusesWhatCannotBeDrawn) {
  const auto with = [](PanoramaMark mark) { return marked_panorama(uniform(1), std::array{mark}); };
  EXPECT_THROW(marked_panorama({}, {}), std::logic_error);
  EXPECT_THROW(with({{0, 0, 0}, 0.1, 1}), std::logic_error);
  EXPECT_THROW(with({{1, 0, 0}, -0.1, 1}), std::logic_error);
  EXPECT_THROW(with({{1, 0, 0}, std::nan(""), 1}), std::logic_error);
  EXPECT_THROW(with({{1, 0, 0}, 0.1, -1}), std::logic_error);
  EXPECT_NO_THROW(with({{1, 0, 0}, kPi, 1}));
}

}  // namespace
}  // namespace zonal
