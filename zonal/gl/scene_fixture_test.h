#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/gl/context.h"
#include "zonal/gl/scene.h"
#include "zonal/gl/technique_reference_test.h"
#include "zonal/view/own_highlight.h"

namespace zonal {

inline constexpr int kSize = 96;

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
    set_own_highlight(data_, painted_highlight());
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
    return parse_state("yaw=103&pitch=24&light_yaw_deg=111&light_pitch_deg=-37&light_roll_deg=52&" + settings);
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
        list.push_back(
            {x,
             y,
             {position, normalize(vector(normals(x, y))), normalize(eye - position), places(x, y).r, places(x, y).g}});
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

}  // namespace zonal
