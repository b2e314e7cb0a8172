#include "zonal/gl/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "zonal/base/error.h"
#include "zonal/gl/context.h"
#include "zonal/gl/target.h"
#include "zonal/gl/technique_reference_test.h"
#include "zonal/image/tonemap.h"
#include "zonal/light/sample.h"

namespace zonal {
namespace {

constexpr int kSize = 96;

/// One context, one light and one scene for all tests of this file.
class SlowScene : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    try {
      context_ = std::make_unique<OffscreenContext>();
    } catch (const Error&) {
      return;
    }
    panorama_ = lopsided_environment(small_view_data().panorama_px);
    data_ = view_data(panorama_, small_view_data());
    scene_ = std::make_unique<Scene>();
    scene_->set_light(data_);
  }
  static void TearDownTestSuite() {
    scene_.reset();
    context_.reset();
  }
  void SetUp() override {
    if (!context_) GTEST_SKIP() << "no OpenGL without a display";
    scene_->set_mesh(mesh_shape("sphere"));
  }

  /// A view in which no axis is along another: camera and light turned by odd angles.
  static ViewState state_of(const std::string& settings) {
    return parse_state("yaw=203&pitch=24&light_yaw_deg=41&" + settings);
  }

  /// The surface points under the pixels, as the shaders have them; every `stride`-th of those that are covered.
  struct Pixel {
    int x, y;
    SurfacePoint point;
  };
  static std::vector<Pixel> pixels(const ViewState& state, int stride) {
    const Image<Rgb> normals = scene_->values(state, Measured::kNormal, kSize, kSize);
    const Image<Rgb> positions = scene_->values(state, Measured::kPosition, kSize, kSize);
    const Image<Rgb> places = scene_->values(state, Measured::kTextureCoordinates, kSize, kSize);
    const Vec3 eye = camera_matrices(state.camera, 1).eye;
    const auto vector = [](Rgb c) { return Vec3{c.r, c.g, c.b}; };
    std::vector<Pixel> list;
    int seen = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        if (std::isnan(normals(x, y).r) || seen++ % stride != 0) continue;
        const Vec3 position = vector(positions(x, y));
        list.push_back({x, y, {position, normalize(vector(normals(x, y))), normalize(eye - position), places(x, y).r,
                               places(x, y).g}});
      }
    }
    return list;
  }

  struct Error2 {
    double rms = 0;    ///< over that of the reference
    double worst = 0;  ///< over the largest value of the reference
    int count = 0;
  };
  static Error2 compare(const Image<Rgb>& drawn, const std::vector<Pixel>& at, const PointLight& reference) {
    double error = 0, total = 0, largest = 0, worst = 0;
    for (const Pixel& pixel : at) {
      const RgbD truth = reference(pixel.point), is(drawn(pixel.x, pixel.y)), d = is - truth;
      error += d.r * d.r + d.g * d.g + d.b * d.b;
      total += truth.r * truth.r + truth.g * truth.g + truth.b * truth.b;
      largest = std::max(largest, max_channel(truth));
      worst = std::max({worst, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
    }
    return {std::sqrt(error / total), worst / largest, static_cast<int>(at.size())};
  }

  static inline std::unique_ptr<OffscreenContext> context_;
  static inline std::unique_ptr<Scene> scene_;
  static inline Environment panorama_;
  static inline ViewData data_;
};

struct Case {
  const char* settings;
  double rms, worst;  // most of what it may be off by
  int stride = 7;
};

constexpr double kHalf = 1.0 / 2048;  // a half float's rounding
// Of lookups between texels the worst pixel is at an edge of the picture, where a float's rounding of the place shows.
constexpr Case kTechniques[] = {
    {"technique=lambert&ambient_light=0", 1e-5, 1e-5},
    {"technique=lambert&ambient_light=1", 1e-5, 1e-5},
    {"technique=lambert&ambient_light=2&roughness=0.6&f0=0.3", 3e-3, 3e-3, 97},  // between the table's entries
    {"technique=blinn-newell", kHalf, 4 * kHalf},
    {"technique=sphere-map&viewpoint=0", 1e-2, 0.1},
    {"technique=sphere-map&viewpoint=1", 1e-2, 0.1},
    {"technique=cube-map", kHalf, 4 * kHalf},
    {"technique=dual-paraboloid", 1e-2, 0.1},
    {"technique=highlight-map", 1e-3, 1e-3},
    {"technique=uniform-blur&blur_level=0", kHalf, 4 * kHalf},
    {"technique=uniform-blur&blur_level=3", kHalf, 4 * kHalf},
    {"technique=phong&shininess=512", 1e-2, 2e-2},
    {"technique=phong&shininess=64", 1e-2, 2e-2},
    {"technique=phong&shininess=1", 1e-2, 2e-2},
    {"technique=split-sum&roughness=1&f0=0.5", 1e-2, 2e-2},
    {"technique=irradiance-map", 1e-3, 2e-3},
    {"technique=vector-irradiance", 1e-5, 1e-5},
    {"technique=sh-bands&bands=1", 1e-5, 1e-5},
    {"technique=sh-bands&bands=2", 1e-5, 1e-5},
    {"technique=sh-bands&bands=3", 1e-5, 1e-5},
    {"technique=sh-bands&bands=5&window_kind=1&window_strength=0.5", 1e-5, 1e-5},
    {"technique=sh-bands&bands=6&window_kind=2&window_strength=1", 1e-5, 1e-5},
    {"technique=sh-bands&bands=6&window_kind=3&window_strength=0.2", 1e-5, 1e-5},
    {"technique=sh-polynomial", 1e-5, 1e-5},
    {"technique=sh-constants", 1e-5, 1e-5},
    {"technique=extracted-lights&light_count=0", 1e-5, 1e-5},
    {"technique=extracted-lights&light_count=1", 1e-5, 1e-5},
    {"technique=extracted-lights&light_count=2", 1e-5, 1e-5},
    {"technique=extracted-lights&light_count=3", 1e-5, 1e-5},
    {"technique=ambient-cube", 1e-5, 1e-5},
};

TEST_F(SlowScene, EveryTechniqueShowsWhatTheLibrarySays) {
  int compared = 0;
  for (const char* mesh : {"sphere", "torus-knot"}) {
    scene_->set_mesh(mesh_shape(mesh));
    for (const Case& one : kTechniques) {
      const ViewState state = state_of(one.settings);
      const Image<Rgb> drawn = scene_->values(state, Measured::kTechnique, kSize, kSize);
      const Error2 error = compare(drawn, pixels(state, one.stride), technique_reference(panorama_, state));
      std::printf("%s %s: rms %.2g worst %.2g of %d\n", mesh, one.settings, error.rms, error.worst, error.count);
      EXPECT_LT(error.rms, one.rms) << mesh << " " << one.settings;
      EXPECT_LT(error.worst, one.worst) << mesh << " " << one.settings;
      compared += error.count;
    }
  }
  EXPECT_GT(compared, 10000);
}

TEST_F(SlowScene, ExactAnswersAreSumsOverTheTexels) {
  constexpr Case kCases[] = {
      {"technique=irradiance-map", 1e-3, 2e-3},
      {"technique=blinn-newell", kHalf, 4 * kHalf},
      {"technique=phong&shininess=5", 1e-3, 1e-3},
      {"technique=phong&shininess=100", 1e-3, 1e-3},
      {"technique=split-sum&roughness=0.5&f0=0.2", 1e-3, 1e-3},
      {"technique=split-sum&roughness=1&f0=1", 1e-3, 1e-3},
  };
  int compared = 0;
  for (const Case& one : kCases) {
    const ViewState state = state_of(one.settings);
    const Image<Rgb> drawn = scene_->values(state, Measured::kExact, kSize, kSize);
    const Error2 error = compare(drawn, pixels(state, one.stride), exact_reference(panorama_, state));
    std::printf("%s: rms %.2g worst %.2g of %d\n", one.settings, error.rms, error.worst, error.count);
    EXPECT_LT(error.rms, one.rms) << one.settings;
    EXPECT_LT(error.worst, one.worst) << one.settings;
    compared += error.count;
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace zonal
