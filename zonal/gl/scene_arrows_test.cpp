#include <array>

#include "zonal/gl/scene_fixture_test.h"
#include "zonal/gl/target.h"

namespace zonal {
namespace {

constexpr int kWide = 320, kHigh = 180;
constexpr double kTip = 1.15, kLongest = 1.3;  // what the picture shows, and shaders/arrow_vertex.glsl draws

struct PixelPlace {
  double x, y;
};

/// A point of the world, by the library's camera.
PixelPlace projected(const ViewState& state, Vec3 p) {
  const Matrix4 m = camera_matrices(state.camera, static_cast<double>(kWide) / kHigh).clip_from_world;
  const auto row = [&](std::size_t i) { return m[i] * p.x + m[4 + i] * p.y + m[8 + i] * p.z + m[12 + i]; };
  return {kWide * (0.5 + 0.5 * row(0) / row(3)), kHigh * (0.5 - 0.5 * row(1) / row(3))};
}

double along(PixelPlace p, PixelPlace from, PixelPlace to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  return ((p.x - from.x) * dx + (p.y - from.y) * dy) / std::hypot(dx, dy);
}

class SlowSceneArrows : public SlowScene {
 protected:
  static const std::vector<float>& uniform(std::string_view name) {
    return std::ranges::find(data_.uniforms, name, &ViewUniform::name)->values;
  }
  /// Toward the only light of its fit, in the world.
  static Vec3 toward_light(const ViewState& state) {
    const std::vector<float>& all = uniform("light_directions");
    return Rotation::about_z(radians(state.value("light_yaw_deg"))) * Vec3{all[0], all[1], all[2]};
  }
  static Image<Rgb> drawn(const ViewState& state) {
    const DrawTarget target(kWide, kHigh);
    target.bind();
    scene_->draw(state, kWide, kHigh);
    return target.read();
  }
  struct Shown {
    PixelPlace place;
    Rgb color;
  };
  /// The pixels of the arrow, with what is shown there: where the view without lights looks otherwise. Beside the
  /// object only, which without lights is lit otherwise.
  static std::vector<Shown> arrow(const ViewState& state) {
    ViewState none = state;
    none.set("light_count", 0);
    const Image<Rgb> with = drawn(state), without = drawn(none);
    const Image<Rgb> surface = scene_->values(state, Measured::kNormal, kWide, kHigh);
    std::vector<Shown> list;
    for (int y = 0; y < kHigh; ++y) {
      for (int x = 0; x < kWide; ++x) {
        const bool covered = !std::isnan(surface(x, y).r);
        if (!covered && !(with(x, y) == without(x, y))) list.push_back({{x + 0.5, y + 0.5}, with(x, y)});
      }
    }
    return list;
  }
  /// A view in which the light comes from the right of the eye, turned by `before_deg` toward it.
  static ViewState beside(double before_deg) {
    ViewState state = parse_state("technique=extracted-lights&light_count=1&light_yaw_deg=40");
    const Vec3 light = toward_light(state);
    state.camera.yaw_deg = degrees(std::atan2(light.y, light.x)) - 90 + before_deg;
    state.camera.pitch_deg = 0;
    return state;
  }
  static Mesh wall_facing(Vec3 eye) {
    const Vec3 n = normalize(eye), side = 3 * normalize(cross({0, 0, 1}, n)), up = cross(n, side);
    Mesh wall;
    for (const Vec3& p : {-side - up, side - up, side + up, -1.0 * side + up}) {
      const auto f = [](double x) { return static_cast<float>(x); };
      wall.vertices.push_back({{f(p.x), f(p.y), f(p.z)}, {f(n.x), f(n.y), f(n.z)}});
    }
    wall.indices = {0, 1, 2, 0, 2, 3};
    return wall;
  }
  static void hide_object() { scene_->set_mesh({{{{0, 0, 0}}, {{0, 0, 0}}, {{0, 0, 0}}}, {0, 1, 2}}); }
};

TEST_F(SlowSceneArrows, AnArrowPointsFromItsLightToTheObject) {
  hide_object();
  const double length = kLongest * std::sqrt(uniform("light_shares")[0]);
  ASSERT_GT(length, 0.1);
  int seen = 0;
  for (const double before_deg : {-15.0, 0.0, 20.0}) {
    const ViewState state = beside(before_deg);
    const Vec3 light = toward_light(state);
    const PixelPlace tip = projected(state, kTip * light), tail = projected(state, (kTip + length) * light);
    const double pixels = std::hypot(tail.x - tip.x, tail.y - tip.y);
    double least = 1e9, most = -1e9;
    int at_tip = 0, at_tail = 0;
    const std::vector<Shown> arrow = this->arrow(state);
    for (const Shown& shown : arrow) {
      const double place = along(shown.place, tip, tail);
      least = std::min(least, place);
      most = std::max(most, place);
      (place < pixels / 2 ? at_tip : at_tail) += 1;
      const double off = std::hypot(shown.place.x - tip.x, shown.place.y - tip.y);
      EXPECT_LT(off * off - place * place, 0.2 * 0.2 * pixels * pixels + 2 * pixels) << "it is slender";
    }
    EXPECT_GT(pixels, 8);
    EXPECT_NEAR(least, 0, 2) << before_deg;  // the last pixels of a tip are thinner than a pixel
    EXPECT_NEAR(most, pixels, 1.5) << before_deg;
    EXPECT_GT(at_tip, 1.1 * at_tail) << "the head is toward the object";
    seen += static_cast<int>(arrow.size());
  }
  EXPECT_GT(seen, 100);
}

TEST_F(SlowSceneArrows, ItIsOfTheHueOfItsLight) {
  hide_object();
  const std::vector<float>& light = uniform("light_irradiance");
  const float most = std::max({light[0], light[1], light[2]});
  Rgb brightest;
  for (const Shown& shown : arrow(beside(10))) {
    if (shown.color.r + shown.color.g + shown.color.b > brightest.r + brightest.g + brightest.b)
      brightest = shown.color;
  }
  const auto linear = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
  const float facing = std::max({linear(brightest.r), linear(brightest.g), linear(brightest.b)});
  EXPECT_GT(facing, 0.7f);
  EXPECT_NEAR(linear(brightest.r) / facing, light[0] / most, 0.01);
  EXPECT_NEAR(linear(brightest.g) / facing, light[1] / most, 0.01);
  EXPECT_NEAR(linear(brightest.b) / facing, light[2] / most, 0.01);
}

// A wall through the middle hides an arrow behind it, and nothing of one before it.
TEST_F(SlowSceneArrows, ItHasDepth) {
  for (const double before_deg : {-25.0, 25.0}) {
    const ViewState state = beside(before_deg);
    ViewState none = state;
    none.set("light_count", 0);
    hide_object();
    const Image<Rgb> alone = drawn(state), sky = drawn(none);
    scene_->set_mesh(wall_facing(camera_matrices(state.camera, 1).eye));
    const Image<Rgb> with = drawn(state);
    int arrow = 0, seen = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
      if (alone.values()[i] == sky.values()[i]) continue;
      ++arrow;
      seen += with.values()[i] == alone.values()[i];
    }
    EXPECT_GT(arrow, 50);
    EXPECT_EQ(seen, before_deg > 0 ? arrow : 0);
  }
  scene_->set_mesh(mesh_shape("sphere"));
}

// On the line of sight an arrow on its axis would be behind the object, or a disc: it stands beside, at the right.
TEST_F(SlowSceneArrows, ALightOnTheLineOfSightIsSeen) {
  const double length = kLongest * std::sqrt(uniform("light_shares")[0]);
  for (const double side : {-1.0, 1.0}) {
    ViewState state = beside(90 * side);
    const Vec3 light = toward_light(state);
    state.camera.pitch_deg = side * degrees(std::asin(light.z));
    state.camera.yaw_deg -= 0.5 * side;  // so that the light is a little to the right
    const auto axes = camera_matrices(state.camera, 1).eye_from_world;
    const Vec3 tip = (side < 0 ? 1.3 : 1.0) * kTip * Vec3{axes[0], axes[3], axes[6]};
    const PixelPlace from = projected(state, tip), to = projected(state, tip + length * light);
    double least = 1e9, most = -1e9;
    int count = 0;
    for (const Shown& shown : arrow(state)) {
      if (shown.place.x < kWide * 0.6) continue;  // the ring, where the light is in front
      least = std::min(least, along(shown.place, from, to));
      most = std::max(most, along(shown.place, from, to));
      ++count;
    }
    EXPECT_GT(count, 20) << side;
    const double pixels = std::hypot(to.x - from.x, to.y - from.y), upright = kHigh * length / 2.33;  // 2 tan(20°) 3.2
    EXPECT_GT(pixels, 0.25 * upright) << "seen from the side, not end-on";
    EXPECT_NEAR(least, 0, 3) << side;
    EXPECT_GT(most, pixels - 2) << side;
  }
}

TEST_F(SlowSceneArrows, NothingOfThemIsMeasured) {
  ViewState state = beside(28);
  const Image<Rgb> background = scene_->values(state, Measured::kBackground, kWide, kHigh);
  const Image<Rgb> normals = scene_->values(state, Measured::kNormal, kWide, kHigh);
  const Difference marked = scene_->difference(state, kWide, kHigh);
  EXPECT_FALSE(arrow(state).empty());
  std::int64_t covered = 0;
  for (const Rgb& n : normals.values()) covered += !std::isnan(n.r);
  EXPECT_EQ(marked.pixels, covered);
  state.set("light_count", 0);
  EXPECT_EQ(scene_->values(state, Measured::kBackground, kWide, kHigh), background);
}

}  // namespace
}  // namespace zonal
