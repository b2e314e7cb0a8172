#include "zonal/light/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stop_token>

#include "zonal/base/error.h"
#include "zonal/light/orient.h"
#include "zonal/light/synthetic.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

constexpr Layout kFullSphere[] = {Layout::kEquirect,          Layout::kCubeStack,
                                  Layout::kCubeRow,           Layout::kCubeCross,
                                  Layout::kCubeCrossVertical, Layout::kCubeCrossVerticalUnrotated,
                                  Layout::kOctahedral,        Layout::kOctahedralEqualArea,
                                  Layout::kMirrorBall,        Layout::kSphereMap,
                                  Layout::kAngular,           Layout::kDualParaboloid};

Mapping mapping_of(const Environment& e) { return Mapping(e.projection, {e.radiance.width(), e.radiance.height()}); }

/// Σ radiance * solid angle.
RgbD energy(const Environment& e) {
  const Mapping mapping = mapping_of(e);
  RgbD sum;
  for (int y = 0; y < e.radiance.height(); ++y) {
    for (int x = 0; x < e.radiance.width(); ++x) sum += mapping.solid_angle(x, y) * RgbD(e.radiance(x, y));
  }
  return sum;
}

template <class F>
int for_each_centre(const Environment& e, const F& f) {
  const Mapping mapping = mapping_of(e);
  int count = 0;
  for (int y = 0; y < e.radiance.height(); ++y) {
    for (int x = 0; x < e.radiance.width(); ++x) {
      if (const auto d = mapping.direction(center_of({x, y}))) f(e.radiance(x, y), *d, x, y), ++count;
    }
  }
  return count;
}

Environment noise(const Projection& p, ImageSize size) {
  Environment e = furnace(p, size);
  std::mt19937 random(2);
  std::exponential_distribution<float> value(1);
  for (Rgb& c : e.radiance.values()) c = {value(random), value(random), value(random)};
  return e;
}

TEST(Resample, SameProjectionSizeAndNoRotationReturnTheSameBits) {
  for (const Layout layout : kFullSphere) {
    const Environment e = noise({layout}, image_size(layout, 20));
    EXPECT_EQ(resample(e, {layout}, 20).radiance, e.radiance) << name_of(layout);
  }
  const Environment ball = noise({Layout::kMirrorBall}, {40, 40});
  EXPECT_EQ(resample(ball, {Layout::kSphereMap}, 40).radiance, ball.radiance);
}

TEST(Resample, ConstantStaysConstantThroughEveryPair) {
  long compared = 0;
  for (const Layout from : kFullSphere) {
    const Environment e = furnace({from}, image_size(from, 48), {0.3f, 1, 7});
    for (const Layout to : kFullSphere) {
      const Environment r = resample(e, {to}, from == to ? 32 : 24);
      compared += for_each_centre(r, [&](Rgb c, Vec3, int x, int y) {
        ASSERT_NEAR(c.r, 0.3f, 1e-6f * 0.3f) << name_of(from) << " to " << name_of(to) << " at " << x << " " << y;
        ASSERT_NEAR(c.g, 1, 1e-6f) << name_of(from) << " to " << name_of(to);
        ASSERT_NEAR(c.b, 7, 7e-6f) << name_of(from) << " to " << name_of(to);
      });
    }
  }
  EXPECT_GT(compared, 100000);
}

/// Worst error of the linear sky after a conversion, in units of the square of the larger texel's angle.
struct LinearError {
  double worst = 0, worst_in_texels = 0;
};

LinearError linear_error(const Projection& from, ImageSize from_size, const Projection& to, ImageSize to_size) {
  const Environment r = resample(gradient(from, from_size), to, to_size);
  const Mapping mapping = mapping_of(r);
  LinearError e;
  const int count = for_each_centre(r, [&](Rgb c, Vec3 d, int x, int y) {
    const double error = std::abs(c.r - (1 + d.x + 0.5 * d.y));
    double side = std::sqrt(mapping.solid_angle(x, y));
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      const auto next = mapping.direction(center_of({x + dx, y + dy}));
      if (next && mapping.chart(center_of({x + dx, y + dy})) == mapping.chart(center_of({x, y}))) {
        side = std::max(side, length(*next - d));
      }
    }
    e.worst = std::max(e.worst, error);
    e.worst_in_texels = std::max(e.worst_in_texels, error / (side * side));
  });
  EXPECT_GT(count, 1000);
  return e;
}

TEST(SlowResample, LinearSkyThroughEveryPair) {
  const auto size = [](Layout layout) {
    switch (layout) {
      case Layout::kEquirect:
        return image_size(layout, 512);
      case Layout::kOctahedral:
      case Layout::kOctahedralEqualArea:
        return image_size(layout, 768);
      case Layout::kMirrorBall:
      case Layout::kSphereMap:
      case Layout::kAngular:
        return image_size(layout, 1024);
      case Layout::kDualParaboloid:
        return image_size(layout, 512);
      default:
        return image_size(layout, 256);
    }
  };
  // One cube of each kind of orientation: how the faces lie in the picture changes nothing.
  constexpr Layout kKinds[] = {Layout::kEquirect,   Layout::kCubeStack,           Layout::kCubeCrossVertical,
                               Layout::kOctahedral, Layout::kOctahedralEqualArea, Layout::kMirrorBall,
                               Layout::kAngular,    Layout::kDualParaboloid};
  int pairs = 0;
  for (const Layout from : kKinds) {
    for (const Layout to : kKinds) {
      const LinearError e = linear_error({from}, size(from), {to}, size(to));
      const bool rim = to == Layout::kMirrorBall || to == Layout::kSphereMap;  // a rim texel is degrees wide
      EXPECT_LT(e.worst, rim ? 2e-3 : 1.1e-5) << name_of(from) << " to " << name_of(to);
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 64);
}

TEST(SlowResample, LinearSkyErrsWithTheSquareOfTheTexel) {
  int pairs = 0;
  for (const Layout from : kFullSphere) {
    for (const Layout to : {Layout::kEquirect, Layout::kCubeStack, Layout::kOctahedral, Layout::kAngular}) {
      if (from == to) continue;
      const LinearError e = linear_error({from}, image_size(from, 192), {to}, image_size(to, 64));
      // The mean over a square of side s falls short by s²/12, straight lines between texels not larger by s²/8 each
      // way.
      EXPECT_LT(e.worst_in_texels, 0.4) << name_of(from) << " to " << name_of(to);
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 44);
}

TEST(SlowResample, EnergyIsKept) {
  int pairs = 0;
  for (const Layout from : kFullSphere) {
    Environment e = noise({from}, image_size(from, 96));
    const RgbD before = energy(e);
    for (const Layout to : kFullSphere) {
      const RgbD after = energy(resample(e, {to}, 48));
      // Noise is the worst case: each of ~20000 texels is weighed wrong by up to 10 % at random.
      EXPECT_NEAR(luminance(after) / luminance(before), 1, 6e-3) << name_of(from) << " to " << name_of(to);
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 144);
}

TEST(SlowResample, AOneTexelSunKeepsItsEnergy) {
  std::mt19937 random(4);
  int compared = 0;
  for (const Layout from : kFullSphere) {
    Environment e = furnace({from}, image_size(from, 64));
    const Mapping mapping = mapping_of(e);
    int x = 0, y = 0;
    do {
      x = static_cast<int>(random() % e.radiance.width()), y = static_cast<int>(random() % e.radiance.height());
    } while (!mapping.direction(center_of({x, y})));
    e.radiance(x, y) = {1e6f, 2e6f, 3e6f};
    const double before = luminance(energy(e));
    for (const Layout to : kFullSphere) {
      if (from == to) continue;
      for (const int size : {16, 40, 100}) {
        const double after = luminance(energy(resample(e, {to}, size)));
        // Texel coordinates up to 400 are floats: their rounding moves 3e-5 of a texel to its neighbour.
        EXPECT_NEAR(after / before, 1, 4e-5)
            << name_of(from) << " to " << name_of(to) << " " << size << " at " << x << " " << y;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 12 * 11 * 3);
}

TEST(Resample, NeverNegativeWhereTheSourceIsNot) {
  long compared = 0;
  for (const Layout from : kFullSphere) {
    Environment e = furnace({from}, image_size(from, 40), {0, 0, 0});
    std::mt19937 random(6);
    for (Rgb& c : e.radiance.values()) {
      if (random() % 7 == 0) c = {1e5f, 1, 1e-3f};
    }
    for (const Layout to : kFullSphere) {
      compared += for_each_centre(resample(e, {to}, 50), [&](Rgb c, Vec3, int, int) {
        ASSERT_GE(std::min({c.r, c.g, c.b}), 0) << name_of(from) << " to " << name_of(to);
      });
    }
  }
  EXPECT_GT(compared, 300000);
}

TEST(Resample, RotationTurnsTheLight) {
  const Environment e = gradient({}, {256, 128});
  const Rotation turn = turned(30, 40, 50);
  const Environment r = resample(e, {Layout::kCubeStack}, 64, {.world_from_source = turn});
  const int compared = for_each_centre(r, [&](Rgb c, Vec3 d, int, int) {
    const Vec3 source = transpose(turn) * d;
    ASSERT_NEAR(c.r, 1 + source.x + 0.5 * source.y, 5e-4);
  });
  EXPECT_EQ(compared, 6 * 64 * 64);
  // A sun at +X, turned a quarter to the left, stands at +Y.
  const Environment sky = sun({}, {256, 128}, {.toward_sun = {1, 0, 0}, .diameter_deg = 10});
  const Environment left = resample(sky, {}, {256, 128}, {.world_from_source = turned(90)});
  EXPECT_GT(left.radiance(64, 64).r, 1e4f);
  EXPECT_LT(left.radiance(128, 64).r, 2);
}

TEST(Resample, SameBitsForAnyNumberOfThreads) {
  const Environment e = noise({}, {200, 100});
  zonal::Run one, two, seven;
  one.threads = 1, two.threads = 2, seven.threads = 7;
  const auto a = resample(e, {Layout::kOctahedral}, 90, {}, one);
  EXPECT_EQ(a.radiance, resample(e, {Layout::kOctahedral}, 90, {}, two).radiance);
  EXPECT_EQ(a.radiance, resample(e, {Layout::kOctahedral}, 90, {}, seven).radiance);
}

TEST(Resample, EveryInstructionSetAgrees) {
  const Environment e = noise({}, {256, 128});
  zonal::Run baseline;
  baseline.isa = Isa::kBaseline;
  const auto expected = resample(e, {Layout::kCubeStack}, 40, {}, baseline);
  for (const Isa isa : available_isas()) {
    zonal::Run run;
    run.isa = isa;
    const auto r = resample(e, {Layout::kCubeStack}, 40, {}, run);
    float worst = 0;
    for (std::size_t i = 0; i < r.radiance.size(); ++i) {
      worst = std::max(worst, std::abs(r.radiance.values()[i].g - expected.radiance.values()[i].g));
    }
    EXPECT_LT(worst, 1e-3f) << name_of(isa);  // positions differ by 1e-4 texels, texels by about 4
  }
}

TEST(Resample, FisheyeFillsWhatItDoesNotShow) {
  const Projection fisheye{Layout::kFisheye, {}};
  Environment e = furnace(fisheye, {64, 64}, {2, 2, 2});
  const auto down = [&](const ResampleOptions& options) {
    return resample(e, {Layout::kCubeStack}, 16, options).radiance(8, 3 * 16 + 8).r;  // sampler face -Y: world -Z
  };
  EXPECT_NEAR(down({}), 2, 1e-6);
  EXPECT_NEAR(down({.uncovered = Uncovered::kNearest}), 2, 1e-6);
  EXPECT_NEAR(down({.uncovered = Uncovered::kConstant, .ground = {5, 5, 5}}), 5, 1e-6);
  EXPECT_EQ(down({.uncovered = Uncovered::kBlack}), 0);
  EXPECT_NEAR(coverage(fisheye, {64, 64}), 0.5, 1e-4);
  EXPECT_NEAR(coverage({}, {64, 32}), 1, 1e-12);
  EXPECT_NEAR(rim_mean(e).g, 2, 1e-6);
}

TEST(Resample, ThereAndBackThroughAFisheye) {
  const Environment e = gradient({}, {256, 128});
  const Projection fisheye{Layout::kFisheye, {.fov_deg = 200}};
  const Environment back = resample(resample(e, fisheye, 300), {}, 128);
  int compared = 0;
  for_each_centre(back, [&](Rgb c, Vec3 d, int, int) {
    if (d.z < 0) return;
    ASSERT_NEAR(c.r, 1 + d.x + 0.5 * d.y, 1e-3);
    ++compared;
  });
  EXPECT_EQ(compared, 256 * 64);
}

TEST(Resample, BadSizesAndCancel) {
  const Environment e = furnace({}, {32, 16});
  EXPECT_THROW(resample(e, {Layout::kCubeStack}, ImageSize{10, 11}), Error);
  std::stop_source stop;
  stop.request_stop();
  zonal::Run run;
  run.stop = stop.get_token();
  try {
    resample(e, {Layout::kCubeStack}, 8, {}, run);
    FAIL() << "ran to the end";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kCancelled);
  }
}

TEST(Resample, TinyPictures) {
  int compared = 0;
  for (const Layout from : kFullSphere) {
    for (const int size : {1, 2, 3}) {
      Environment e;
      try {
        e = furnace({from}, image_size(from, size), {3, 3, 3});
      } catch (const Error&) {
        continue;  // this layout does not come so small
      }
      for (const Layout to : {Layout::kEquirect, Layout::kCubeCross, Layout::kOctahedral}) {
        compared += for_each_centre(resample(e, {to}, 4), [&](Rgb c, Vec3, int, int) { ASSERT_NEAR(c.r, 3, 1e-5); });
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace zonal
