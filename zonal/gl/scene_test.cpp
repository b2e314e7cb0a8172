#include "zonal/gl/scene.h"

#include "zonal/gl/scene_fixture_test.h"

namespace zonal {
namespace {

struct Case {
  const char* settings;
  double rms, worst;  // most of what it may be off by
  int stride = 7;
};

// Light is stored in half floats, which round by 2^-12 at most; places in a picture are floats (near a pole of a
// panorama, where a test card has edges, that shows); the rest is what lies between the texels of a filtered map.
constexpr double kFloat = 2e-6, kHalf = 1.0 / 2048, kPole = 0.005;
constexpr Case kTechniques[] = {
    {"technique=lambert&ambient_light=0", kFloat, kFloat},
    {"technique=lambert&ambient_light=1", kFloat, kFloat},
    {"technique=lambert&ambient_light=2&roughness=0.6&f0=0.3", 1e-3, 1e-3, 97},
    {"technique=blinn-newell", 4 * kHalf, kPole},
    {"technique=sphere-map&viewpoint=0", 0.01, 0.02},  // the rim, a few texels for half the light
    {"technique=sphere-map&viewpoint=1", 0.03, 0.08},  // the same, and as much of it as the turned light shows
    {"technique=cube-map", kHalf, 4 * kHalf},
    {"technique=dual-paraboloid", 0.005, 0.01},  // the rims of the discs
    {"technique=highlight-map", kHalf, 4 * kHalf},
    {"technique=highlight-map&highlight_source=1", kHalf, 4 * kHalf},
    {"technique=uniform-blur&blur_level=0", 4 * kHalf, kPole},
    {"technique=uniform-blur&blur_level=3", kHalf, kHalf},
    {"technique=phong&shininess=512", 0.005, 0.01},
    {"technique=phong&shininess=1", 0.005, 0.02},  // 8 texels a face
    {"technique=split-sum&roughness=1&f0=0.5", 0.02, 0.05},
    {"technique=reflection-space&f0=0.7", 0.04, 0.15, 29},
    {"technique=reflection-space&reflection_by=1", 0.05, 0.15, 29},
    {"technique=irradiance-map", kHalf, 0.01},
    {"technique=vector-irradiance", kFloat, kFloat},
    {"technique=vector-irradiance&vector_back=1", kFloat, kFloat},
    {"technique=near-lamp", kFloat, kFloat},
    {"technique=near-lamp&lamp_shape=1&lamp_radius=0.3&lamp_distance=5", kFloat, kFloat},
    {"technique=sh-bands&bands=1", kFloat, kFloat},
    {"technique=sh-bands&bands=3", kFloat, kFloat},
    {"technique=sh-bands&bands=3&turn_by=1", kFloat, kFloat},
    {"technique=sh-bands&bands=6&turn_by=1", kFloat, kFloat},
    {"technique=sh-bands&bands=5&window_kind=1&window_strength=0.5", kFloat, kFloat},
    {"technique=sh-bands&bands=6&window_kind=2&window_strength=1", kFloat, kFloat},
    {"technique=sh-bands&bands=6&window_kind=3&window_strength=0.2", kFloat, kFloat},
    {"technique=sh-polynomial", kFloat, kFloat},
    {"technique=homework&light_set=2", kFloat, kFloat},
    {"technique=homework&light_set=10", kFloat, kFloat},
    {"technique=sh-constants", kFloat, kFloat},
    {"technique=extracted-lights&light_count=0", kFloat, kFloat},
    {"technique=extracted-lights&light_count=1", kFloat, kFloat},
    {"technique=extracted-lights&light_count=2", kFloat, kFloat},
    {"technique=extracted-lights&light_count=3", kFloat, kFloat},
    {"technique=ambient-cube", kFloat, kFloat},
};

TEST_F(SlowScene, EveryTechniqueShowsWhatTheLibrarySays) {
  int compared = 0;
  for (const char* mesh : {"sphere", "torus-knot"}) {
    scene_->set_mesh(mesh_shape(mesh));
    for (const Case& one : kTechniques) {
      const ViewState state = state_of(one.settings);
      const Image<Rgb> drawn = scene_->values(state, Measured::kTechnique, kSize, kSize);
      const Error2 error = compare(drawn, pixels(state, one.stride), technique_reference(panorama_, state));
      EXPECT_LT(error.rms, one.rms) << mesh << " " << one.settings;
      EXPECT_LT(error.worst, one.worst) << mesh << " " << one.settings;
      compared += error.count;
    }
  }
  EXPECT_GT(compared, 10000);
}

TEST_F(SlowScene, ExactAnswersAreSumsOverTheTexels) {
  constexpr Case kCases[] = {
      {"technique=irradiance-map", kHalf, 0.01},
      {"technique=blinn-newell", 4 * kHalf, kPole},
      {"technique=bump&bump_depth=0", 4 * kHalf, kPole},
      {"technique=phong&shininess=5", kHalf, kHalf},
      {"technique=phong&shininess=100", kHalf, kHalf},
      {"technique=split-sum&roughness=0.5&f0=0.2", kHalf, kHalf},
      {"technique=split-sum&roughness=1&f0=1", kHalf, kHalf},
      {"technique=reflection-space&f0=0.3", kHalf, kHalf},
      {"technique=homework&light_set=5", kFloat, kFloat},
      {"technique=near-lamp", 1e-3, 1e-3},  // floats where the ball just sets
      {"technique=near-lamp&lamp_radius=0.2&lamp_distance=6", 1e-3, 1e-3},
      {"technique=near-lamp&lamp_shape=1&lamp_radius=1.2&lamp_distance=2.2", 1e-3, 1e-3, 31},  // against small squares
  };
  int compared = 0;
  for (const Case& one : kCases) {
    const ViewState state = state_of(one.settings);
    const Image<Rgb> drawn = scene_->values(state, Measured::kExact, kSize, kSize);
    const Error2 error = compare(drawn, pixels(state, one.stride), exact_reference(panorama_, state));
    EXPECT_LT(error.rms, one.rms) << one.settings;
    EXPECT_LT(error.worst, one.worst) << one.settings;
    compared += error.count;
  }
  EXPECT_GT(compared, 1000);
}

// The tangent frame comes from differences between pixels: from near, they are small.
TEST_F(SlowScene, BumpsBendTheNormalAlongTheTextureCoordinates) {
  constexpr Case kCases[] = {{"bump_depth=1", 0.04, 0.15},
                             {"bump_depth=2&bump_lookup=1", 0.04, 0.15},
                             {"bump_lookup=2", 0.04, 0.15},
                             {"bump_lookup=3", 0.04, 0.15},
                             {"bump_source=1", 0.04, 0.15}};
  int compared = 0;
  for (const Case& one : kCases) {
    ViewState state = state_of(std::string("technique=bump&") + one.settings);
    state.camera.fov_deg = 20;
    state.camera.distance = 1.4;
    const Image<Rgb> drawn = scene_->values(state, Measured::kTechnique, kSize, kSize);
    const Error2 error = compare(drawn, pixels(state, one.stride), technique_reference(panorama_, state));
    EXPECT_LT(error.rms, one.rms) << one.settings;
    EXPECT_LT(error.worst, one.worst) << one.settings;
    compared += error.count;
  }
  EXPECT_GT(compared, 5000);
}

// What n = v = r loses, and what maps for a few eyes give back of it, over eyes near and between those of the maps.
TEST_F(SlowScene, ReflectionSpaceIsNearerToTheTruthThanTheSplitSum) {
  double squares[3] = {};
  for (const char* eye : {"yaw=20&pitch=10", "yaw=70&pitch=-30", "yaw=150&pitch=50"}) {
    for (const int by : {0, 1, 2}) {
      const ViewState state = parse_state("technique=reflection-space&reflection_by=" + std::to_string(by) + "&" + eye);
      const double error = scene_->difference(state, 64, 48).rms;
      squares[by] += error * error;
    }
  }
  RecordProperty("blended", std::to_string(std::sqrt(squares[0] / 3)));
  RecordProperty("nearest", std::to_string(std::sqrt(squares[1] / 3)));
  RecordProperty("split_sum", std::to_string(std::sqrt(squares[2] / 3)));
  EXPECT_LT(squares[0], squares[1]);
  EXPECT_LT(std::sqrt(squares[0]), 0.6 * std::sqrt(squares[2]));
}

}  // namespace
}  // namespace zonal
