#include <array>

#include "zonal/gl/reference_lookups_test.h"
#include "zonal/gl/scene_fixture_test.h"
#include "zonal/gl/target.h"
#include "zonal/image/tonemap.h"
#include "zonal/light/reference.h"
#include "zonal/light/synthetic.h"

namespace zonal {
namespace {

// The rays of the camera, found anew: they must meet the ball where the shaders say it is.
TEST_F(SlowScene, ABallIsSeenWhereRaysMeetIt) {
  const ViewState state = state_of("technique=blinn-newell");
  const double yaw = radians(state.camera.yaw_deg), pitch = radians(state.camera.pitch_deg);
  const Vec3 back = {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
  const Vec3 right = {-std::sin(yaw), std::cos(yaw), 0}, up = cross(back, right), eye = state.camera.distance * back;
  const double half_height = std::tan(radians(state.camera.fov_deg) / 2);
  const Image<Rgb> normals = scene_->values(state, Measured::kNormal, kSize, kSize);
  const Image<Rgb> places = scene_->values(state, Measured::kTextureCoordinates, kSize, kSize);
  int met = 0, missed = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double sx = half_height * (2 * (x + 0.5) / kSize - 1), sy = half_height * (1 - 2 * (y + 0.5) / kSize);
      const Vec3 ray = normalize(sx * right + sy * up - back);
      const double b = dot(eye, ray), square = b * b - (dot(eye, eye) - 1);
      if (std::abs(square) < 0.05) continue;  // the ball is made of flat pieces
      if (square < 0) {
        EXPECT_TRUE(std::isnan(normals(x, y).r));
        ++missed;
        continue;
      }
      const Vec3 hit = eye + (-b - std::sqrt(square)) * ray, n = {normals(x, y).r, normals(x, y).g, normals(x, y).b};
      EXPECT_LT(angle_between(hit, normalize(n)), 0.02) << x << " " << y;
      double turn = std::atan2(hit.y, hit.x) / (2 * kPi);
      if (turn < 0) turn += 1;
      EXPECT_LT(std::abs(std::remainder(places(x, y).r - turn, 1)), 0.02);
      EXPECT_NEAR(places(x, y).g, std::acos(hit.z) / kPi, 0.02);
      ++met;
    }
  }
  EXPECT_GT(met, 4000);
  EXPECT_GT(missed, 2000);
}

TEST_F(SlowScene, TheBackgroundIsThePanoramaBehindTheObject) {
  const ViewState state = state_of("technique=blinn-newell&fov=70");
  const Image<Rgb> drawn = scene_->values(state, Measured::kBackground, kSize, kSize);
  const double yaw = radians(state.camera.yaw_deg), pitch = radians(state.camera.pitch_deg);
  const Vec3 back = {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
  const Vec3 right = {-std::sin(yaw), std::cos(yaw), 0}, up = cross(back, right);
  const double half_height = std::tan(radians(35));
  const Rotation light_from_world = transpose(light_rotation(state));
  const auto sample = lookup(panorama_);
  double error = 0, total = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double sx = half_height * (2 * (x + 0.5) / kSize - 1), sy = half_height * (1 - 2 * (y + 0.5) / kSize);
      const RgbD truth = sample(light_from_world * normalize(sx * right + sy * up - back));
      const Rgb is = drawn(x, y);
      error += (is.r - truth.r) * (is.r - truth.r) + (is.g - truth.g) * (is.g - truth.g);
      total += truth.r * truth.r + truth.g * truth.g;
    }
  }
  EXPECT_GT(total, 1000);
  EXPECT_LT(std::sqrt(error / total), 0.005);  // near a pole, places are floats
}

TEST_F(SlowScene, ColoursAreTheLibrarysToneCurve) {
  const ViewState state = state_of("technique=irradiance-map&exposure_ev=1");
  const DrawTarget target(kSize, kSize);
  target.bind();
  scene_->draw(state, kSize, kSize);
  const Image<Rgb> shown = target.read();
  const Image<Rgb> light = scene_->values(state, Measured::kTechnique, kSize, kSize);
  const Image<Rgb> behind = scene_->values(state, Measured::kBackground, kSize, kSize);
  int object = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const bool covered = !std::isnan(light(x, y).r);
      object += covered;
      const Rgb8 expected = tonemap(covered ? light(x, y) : behind(x, y), {.exposure_ev = 1, .white = 8});
      const auto near = [](float drawn, std::uint8_t byte) { return std::abs(255 * drawn - byte) < 0.51; };
      ASSERT_TRUE(near(shown(x, y).r, expected.r) && near(shown(x, y).g, expected.g) && near(shown(x, y).b, expected.b))
          << x << " " << y;
    }
  }
  EXPECT_GT(object, 4000);
}

// The eye looks at where the two pictures of a dual paraboloid meet: each must not show light of the other.
TEST_F(SlowScene, ParaboloidsDoNotBleedIntoEachOther) {
  const Environment sides = paint({Layout::kEquirect}, image_size(Layout::kEquirect, 64), [](Vec3 d) {
    return d.y > 0 ? Rgb{1, 0, 0} : Rgb{0, 0, 1};
  });
  scene_->set_light(view_data(sides, small_view_data()));
  int seen = 0;
  for (const double yaw : {90.0, -90.0}) {
    ViewState state = parse_state("technique=dual-paraboloid&pitch=0");
    state.camera = {.yaw_deg = yaw, .pitch_deg = 0, .distance = 1.2, .fov_deg = 40};
    const Image<Rgb> drawn = scene_->values(state, Measured::kTechnique, kSize, kSize);
    for (const Rgb& value : drawn.values()) {
      if (std::isnan(value.r)) continue;
      EXPECT_LT(yaw > 0 ? value.b : value.r, 1e-6);
      ++seen;
    }
  }
  scene_->set_light(data_);
  EXPECT_GT(seen, kSize * kSize);
}

// A sun of more than a half float holds comes back as bright as it is, in another unit.
TEST_F(SlowScene, ASunBeyondHalfFloatsStaysFinite) {
  Environment sky = paint({Layout::kEquirect}, image_size(Layout::kEquirect, 64), [](Vec3) { return Rgb{1, 1, 1}; });
  sky.radiance(64, 20) = {3e6f, 2e6f, 1e6f};
  const ViewData data = view_data(sky, small_view_data());
  EXPECT_EQ(data.unit, 128);
  scene_->set_light(data);
  const ViewState state = parse_state("technique=irradiance-map&albedo=1&yaw=0");
  const Image<Rgb> drawn = scene_->values(state, Measured::kTechnique, kSize, kSize);
  sky.radiance(64, 20) = {3e6f, 2e6f, 1e6f};
  const Error2 error = compare(drawn, pixels(state, 11), [&](const SurfacePoint& p) {
    return 1 / data.unit * convolve_at(sky, Lobe::cosine(), std::array{p.normal})[0];
  });
  const Image<Rgb> mirrored =
      scene_->values(parse_state("technique=blinn-newell"), Measured::kBackground, kSize, kSize);
  scene_->set_light(data_);
  EXPECT_LT(error.rms, 0.002);
  EXPECT_GT(error.count, 300);
  for (const Rgb& value : mirrored.values()) ASSERT_TRUE(std::isfinite(value.r));
}

TEST_F(SlowScene, TheDifferenceIsThatOfThePictures) {
  const ViewState state = state_of("technique=ambient-cube");
  const Image<Rgb> is = scene_->values(state, Measured::kTechnique, 64, 36);
  const Image<Rgb> truth = scene_->values(state, Measured::kExact, 64, 36);
  double error = 0, total = 0;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < is.values().size(); ++i) {
    const Rgb a = is.values()[i], b = truth.values()[i];
    if (std::isnan(a.r)) continue;
    for (const auto c : {&Rgb::r, &Rgb::g, &Rgb::b}) {
      error += (a.*c - b.*c) * (a.*c - b.*c);
      total += b.*c * b.*c;
    }
    ++count;
  }
  const Difference difference = scene_->difference(state, 64, 36);
  EXPECT_EQ(difference.pixels, count);
  EXPECT_GT(count, 300);
  EXPECT_NEAR(difference.rms, std::sqrt(error / total), 1e-4 * difference.rms);
  EXPECT_GT(difference.rms, 0.001);
}

TEST_F(SlowScene, LightsAreMarkedWhereTheyAre) {
  ViewState state = parse_state("technique=extracted-lights&light_count=1&pitch=0&fov=20");
  const auto& uniform = *std::ranges::find(data_.uniforms, "light_directions", &ViewUniform::name);
  const Vec3 toward = {uniform.values[0], uniform.values[1], uniform.values[2]};
  // From the other side, past the object: the light is in the middle of the picture, behind the ball.
  state.camera = {.yaw_deg = degrees(std::atan2(-toward.y, -toward.x)),
                  .pitch_deg = -degrees(std::asin(toward.z)),
                  .distance = 3,
                  .fov_deg = 20};
  const DrawTarget target(kSize, kSize);
  const auto center = [&] {
    target.bind();
    scene_->draw(state, kSize, kSize);
    return target.read();
  };
  scene_->set_mesh({{{{0, 0, 0}}, {{0, 0, 0}}, {{0, 0, 0}}}, {0, 1, 2}});  // nothing in the way
  const Image<Rgb> marked = center();
  state.set("light_count", 0);
  const Image<Rgb> plain = center();
  int differ = 0;
  double x_sum = 0, y_sum = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (marked(x, y) == plain(x, y)) continue;
      ++differ;
      x_sum += x + 0.5;
      y_sum += y + 0.5;
    }
  }
  ASSERT_GT(differ, 100);
  EXPECT_LT(differ, kSize * kSize / 4);
  EXPECT_NEAR(x_sum / differ, kSize / 2.0, 3);
  EXPECT_NEAR(y_sum / differ, kSize / 2.0, 3);
}

}  // namespace
}  // namespace zonal
