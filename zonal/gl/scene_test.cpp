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
// At a cube's corner three texels meet; which of them stands for the fourth is not the same everywhere.
constexpr double kCorner = 0.02;
constexpr Case kTechniques[] = {
    {"technique=lambert&ambient_light=0", kFloat, kFloat},
    {"technique=lambert&ambient_light=1", kFloat, kFloat},
    // The table's steps in n.v and in the parameter: most where a smooth surface is grazed.
    {"technique=lambert&ambient_light=2&ambient_brdf=0", kFloat, kFloat},
    {"technique=lambert&ambient_light=2&ambient_brdf=1&shininess=7&f0=0.6", 1e-3, 3e-3, 97},
    {"technique=lambert&ambient_light=2&ambient_brdf=2&shininess=90", 2.5e-3, 0.01, 97},
    {"technique=lambert&ambient_light=2&roughness=0.6&f0=0.3", 1e-3, 1e-3, 97},
    {"technique=blinn-newell", 4 * kHalf, kPole},
    {"technique=sphere-map&viewpoint=0", 0.01, 0.02},  // the rim, a few texels for half the light
    {"technique=sphere-map&viewpoint=1", 0.03, 0.08},  // the same, and as much of it as the turned light shows
    {"technique=cube-map", kHalf, 4 * kHalf},
    {"technique=dual-paraboloid", 0.005, 0.01},  // the rims of the discs
    {"technique=highlight-map", kHalf, 4 * kHalf},
    {"technique=highlight-map&highlight_source=1", kHalf, 4 * kHalf},
    {"technique=highlight-map&highlight_source=2", kHalf, 4 * kHalf},
    {"technique=uniform-blur&blur_level=0", 4 * kHalf, kPole},
    {"technique=uniform-blur&blur_level=3", kHalf, kHalf},
    {"technique=phong&shininess=512", 0.005, 0.01},
    {"technique=phong&shininess=1", 0.005, 0.02},  // 8 texels a face
    {"technique=split-sum&roughness=1&f0=0.5", 0.02, 0.05},
    // Between the texels of small maps, in light with a hard edge.
    {"technique=reflection-space&f0=0.7&roughness=0.5", 0.04, 0.15, 29},
    {"technique=reflection-space&reflection_by=1&roughness=0.7", 0.05, 0.15, 29},
    {"technique=irradiance-map", kHalf, 0.01},
    {"technique=fisheye-maps", kHalf, 4 * kHalf},
    {"technique=fisheye-maps&sky_outside=1&sky_ground=1", kHalf, 4 * kHalf},
    {"technique=fisheye-maps&sky_outside=2&sky_form=1&sky_ground=2&sky_grey=0.7", kHalf, 4 * kHalf},
    {"technique=fisheye-maps&sky_form=2", kHalf, kCorner},
    {"technique=fisheye-maps&sky_weights=1", kHalf, 4 * kHalf},
    {"technique=fisheye-maps&sky_weights=1&sky_outside=2&sky_form=1", kHalf, 4 * kHalf},
    {"technique=fisheye-maps&sky_weights=1&sky_outside=1&sky_form=2&sky_ground=2", kHalf, kCorner},
    {"technique=fisheye-maps&sky_map=1&shininess=512", kHalf, 4 * kHalf},
    {"technique=fisheye-maps&sky_map=1&shininess=512&sky_outside=2&sky_weights=1", kHalf, 4 * kHalf},
    {"technique=fisheye-maps&sky_map=1&shininess=1&sky_outside=2&sky_form=2", kHalf, kCorner},
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
      {"technique=fisheye-maps", kHalf, 0.01},
      {"technique=fisheye-maps&sky_map=1&shininess=30", kHalf, kHalf},
      {"technique=phong&shininess=5", kHalf, kHalf},
      {"technique=phong&shininess=100", kHalf, kHalf},
      {"technique=split-sum&roughness=0.5&f0=0.2", kHalf, kHalf},
      {"technique=split-sum&roughness=1&f0=1", kHalf, kHalf},
      {"technique=reflection-space&f0=0.3&roughness=0.4", kHalf, kHalf},
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

// What n = v = r loses, and what maps for a few eyes give back of it, at the roughnesses of the maps and between them.
// The fixture's light has hard edges, which maps of few texels blur: bounds are a tenth above what was measured.
TEST_F(SlowScene, ReflectionSpaceIsNearerToTheTruthThanTheSplitSum) {
  struct Bound {
    double roughness, error, of_split_sum;
  };
  scene_->set_light(view_data(panorama_, {.panorama_px = 64, .cube_px = 32, .reference_rows = 32}));
  const auto error = [](double roughness, int by) {
    const std::string settings = "technique=reflection-space&yaw=70&pitch=-30&roughness=" + std::to_string(roughness);
    return scene_->difference(parse_state(settings + "&reflection_by=" + std::to_string(by)), 40, 30).rms;
  };
  for (const Bound& bound :
       {Bound{0.3, 0.095, 0.75}, {0.5, 0.065, 0.4}, {0.6, 0.062, 0.46}, {0.7, 0.034, 0.26}, {1, 0.026, 0.16}}) {
    const double blended = error(bound.roughness, 0), split_sum = error(bound.roughness, 2);
    std::printf("roughness %.2f: maps %.4f, nearest %.4f, split sum %.4f\n", bound.roughness, blended,
                error(bound.roughness, 1), split_sum);
    EXPECT_LT(blended, bound.error) << bound.roughness;
    EXPECT_LT(blended, bound.of_split_sum * split_sum) << bound.roughness;
  }
  EXPECT_LT(error(0.5, 0), error(0.5, 1)) << "blending eyes is better than the nearest one";
  scene_->set_light(data_);
}

}  // namespace
}  // namespace zonal
