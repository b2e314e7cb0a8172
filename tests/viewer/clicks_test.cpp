// A person at the window: events of the X server, made by xdotool, at the places where the panels say their items are.
#include "tests/viewer/hand_test.h"
#include "tests/viewer/window_fixture_test.h"
// After the loader of OpenGL, whose names it would declare again.
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <array>
#include <map>
#include <optional>

#include "zonal/io/picture.h"
#include "zonal/view/light_turn.h"

namespace zonal {
namespace {

class ViewerClicksTest : public ViewerWindowTest {
 protected:
  void SetUp() override {
    if (!Hand::exists()) GTEST_SKIP() << "no xdotool";
    Hand::failures = 0;
    hand_.emplace(" - Zonal");
    viewer().set_settings("technique=irradiance-map");
    resize(kWidth, kHeight);  // small: the panels are what counts
    point(kMiddleX, kMiddleY);
    hand_->key("Escape");  // what was clicked last has the keys
    rest();
  }
  void TearDown() override { EXPECT_EQ(Hand::failures, 0) << "xdotool could not do something"; }

  static constexpr int kWidth = 800, kHeight = 600;
  static constexpr double kMiddleX = 570, kMiddleY = 300;  // of the picture

  void resize(int width, int height) {
    hand_->resize(width, height);
    EXPECT_TRUE(frames_until([&] { return window().window().size() == ImageSize{width, height}; }));
  }

  static double value(std::string_view control) { return viewer().state().value(control); }
  static std::optional<WidgetPlace> place_of(const std::string& name) { return window().places().find(name); }

  // Each of these waits until the panels know of it: a person is slower than a frame, and this version of them takes
  // one state of mouse and keys for each frame.
  void point(double x, double y) {
    hand_->move(x, y);
    const ImGuiIO& io = ImGui::GetIO();
    EXPECT_TRUE(frames_until([&] { return std::abs(io.MousePos.x - x) < 1.5 && std::abs(io.MousePos.y - y) < 1.5; }));
    window().frame();  // and what is under it
  }
  void hold(int button) {
    hand_->press(button);
    EXPECT_TRUE(frames_until([&] { return ImGui::GetIO().MouseDown[button == Hand::kLeft ? 0 : 1]; }));
  }
  void let_go(int button) {
    hand_->release(button);
    EXPECT_TRUE(frames_until([&] { return !ImGui::GetIO().MouseDown[button == Hand::kLeft ? 0 : 1]; }));
  }
  void strike(const std::string& key, int glfw_key, bool with_control = false) {
    if (with_control) hand_->key_down("ctrl");
    hand_->key_down(key);
    const ImGuiIO& io = ImGui::GetIO();
    EXPECT_TRUE(frames_until([&] { return io.KeysDown[glfw_key] && io.KeyCtrl == with_control; })) << key;
    hand_->key_up(key);
    if (with_control) hand_->key_up("ctrl");
    EXPECT_TRUE(frames_until([&] { return !io.KeysDown[glfw_key] && !io.KeyCtrl; })) << key;
  }

  /// The item, brought to where a pointer reaches it as a person would: by the wheel.
  WidgetPlace reach(const std::string& name) {
    const auto where = [&] { return window().places().find(name); };
    std::optional<WidgetPlace> place;
    const bool seen = frames_until([&] {
      // Lists that just opened, and panels that were just scrolled, find their place over some frames.
      const std::optional<WidgetPlace> before = where();
      for (int i = 0; i < 2; ++i) window().frame();
      place = where();
      if (!place || place != before) return false;
      if (place->visible) return true;
      point(place->around.x(), place->around.y());
      hand_->click(place->item.y() > place->around.y() ? Hand::kWheelDown : Hand::kWheelUp);
      for (int i = 0; i < 30 && where() == place; ++i) {  // the wheel's event is on its way
        window().window().wait(0.005);
        window().frame();
      }
      return false;
    });
    if (!seen) keep_window("lost");
    EXPECT_TRUE(seen) << "there is no item '" << name << "' to be reached";
    return place.value_or(WidgetPlace());
  }
  void click(const std::string& name) {
    WidgetPlace place;
    do {  // until it stays under the pointer
      place = reach(name);
      point(place.item.x(), place.item.y());
    } while (place_of(name) && place_of(name) != place);
    hold(Hand::kLeft);
    let_go(Hand::kLeft);
  }
  /// From its middle past one of its ends; true when it got there.
  bool drag_to(const std::string& slider, bool greatest, double expected) {
    const WidgetPlace place = reach(slider);
    point(place.item.x(), place.item.y());
    hold(Hand::kLeft);
    hand_->move(greatest ? place.item.right + 30 : place.item.left - 5, place.item.y());
    const bool there = frames_until([&] { return value(slider) == expected; });
    let_go(Hand::kLeft);
    point(kMiddleX, kMiddleY);
    return there;
  }
  bool choose(const std::string& control, int choice) {
    click(control);
    click(fmt::format("{}/{}", control, choice));
    const bool chosen = frames_until([&] { return value(control) == choice && place_of(control).has_value(); });
    point(kMiddleX, kMiddleY);
    return chosen;
  }
  void write_into(const std::string& field, const std::string& text) {
    click(field);
    const bool typed = frames_until([] { return ImGui::GetIO().WantTextInput; });
    if (!typed) keep_window("no_text");
    EXPECT_TRUE(typed) << field;
    strike("a", GLFW_KEY_A, true);
    hand_->write(text);
    strike("Return", GLFW_KEY_ENTER);
    point(kMiddleX, kMiddleY);
  }

  std::optional<Hand> hand_;
};

TEST_F(ViewerClicksTest, EveryTechniqueIsChosenFromTheList) {
  int chosen = 0;
  for (const Technique& technique : all_techniques()) {
    click("technique");
    click("technique/" + std::string(technique.id));
    ASSERT_TRUE(frames_until([&] { return viewer().state().technique == &technique; })) << technique.id;
    EXPECT_TRUE(frames_until([&] { return place_of("technique").has_value(); })) << "the list closes";
    for (const std::string_view control : technique.controls) {
      EXPECT_TRUE(frames_until([&] { return place_of(std::string(control)).has_value(); })) << control;
    }
    ++chosen;
  }
  EXPECT_EQ(chosen, static_cast<int>(all_techniques().size()));
}

/// Settings in which a control can be seen to do something; by itself the first technique that lists it.
const std::map<std::string_view, const char*> kSeenIn = {
    {"exposure_ev", "technique=irradiance-map"},
    {"ambient_brdf", "technique=lambert&ambient_light=2"},
    {"tone_curve", "technique=cube-map"},
    {"compare", "technique=ambient-cube"},
    {"difference_gain", "technique=ambient-cube&compare=2"},
    {"albedo", "technique=irradiance-map"},
    {"roughness", "technique=split-sum"},
    {"f0", "technique=split-sum"},
    {"shininess", "technique=phong"},
    {"lamp_shape", "technique=near-lamp&compare=2&difference_gain=32"},
    {"lamp_radius", "technique=near-lamp&compare=2&difference_gain=32"},
    {"window_kind", "technique=sh-bands&window_strength=1&bands=6"},
    {"window_strength", "technique=sh-bands&window_kind=1&bands=6"},
    {"sky_grey", "technique=fisheye-maps&sky_ground=2"},
    {"turn_by", "technique=sh-bands&light_yaw_deg=50&light_pitch_deg=30"},
};
/// Two ways to one picture; a colour for light below zero, of which this sky has none.
constexpr std::array<std::string_view, 2> kUnseen = {"turn_by", "tint_negative"};

TEST_F(ViewerClicksTest, EveryControlTurnsAndShows) {
  int turned = 0, seen = 0;
  for (const Control& control : all_controls()) {
    const std::string name(control.name);
    const auto lists = [&](const Technique& t) { return std::ranges::find(t.controls, name) != t.controls.end(); };
    const auto first = std::ranges::find_if(all_techniques(), lists);
    const auto known = kSeenIn.find(control.name);
    viewer().set_settings(known != kSeenIn.end()            ? known->second
                          : first != all_techniques().end() ? "technique=" + std::string(first->id)
                                                            : "technique=cube-map");
    std::vector<Image<Rgb8>> shown = {rest()};
    switch (control.kind) {
      case ControlKind::kSlider:
        for (const bool greatest : {false, true}) {
          const double end = greatest ? control.greatest : control.least;
          EXPECT_TRUE(drag_to(name, greatest, end)) << name << " does not reach " << end << ": " << value(name);
          shown.push_back(rest());
        }
        break;
      case ControlKind::kChoice:
        for (std::size_t i = 0; i < control.choices.size(); ++i) {
          EXPECT_TRUE(choose(name, static_cast<int>(i))) << name << " is not " << control.choices[i];
          shown.push_back(rest());
        }
        break;
      case ControlKind::kToggle:
        for (int i = 0; i < 2; ++i) {
          const double other = value(name) == 0 ? 1 : 0;
          click(name);
          EXPECT_TRUE(frames_until([&] { return value(name) == other; })) << name;
          shown.push_back(rest());
        }
        break;
    }
    ++turned;
    if (std::ranges::find(kUnseen, control.name) != kUnseen.end()) continue;
    double most = 0;  // two ends of a turn are one picture
    for (const Image<Rgb8>& picture : shown) most = std::max(most, changed(shown[0], picture));
    EXPECT_GT(most, 0.002) << name << " changes nothing";
    ++seen;
  }
  EXPECT_EQ(turned, static_cast<int>(all_controls().size()));
  EXPECT_EQ(seen, turned - static_cast<int>(kUnseen.size()));
  viewer().set_settings("technique=irradiance-map");
}

TEST_F(ViewerClicksTest, TheHandMovesTheEyeInThePicture) {
  const Image<Rgb8> before = rest();
  const OrbitCamera camera = viewer().state().camera;
  const auto eye = [] { return viewer().state().camera; };
  hand_->key("Right");
  EXPECT_TRUE(frames_until([&] { return eye().yaw_deg != camera.yaw_deg; })) << "Escape gave the keys to the picture";
  hand_->key("Up");
  EXPECT_TRUE(frames_until([&] { return eye().pitch_deg > camera.pitch_deg; }));
  viewer().set_camera(camera);
  hold(Hand::kLeft);
  hand_->move(kMiddleX + 100, kMiddleY + 60);
  EXPECT_TRUE(
      frames_until([&] { return eye().yaw_deg < camera.yaw_deg - 20 && eye().pitch_deg > camera.pitch_deg + 10; }));
  let_go(Hand::kLeft);
  point(kMiddleX, kMiddleY);
  const OrbitCamera dragged = eye();
  hand_->click(Hand::kWheelUp, 3);
  EXPECT_TRUE(frames_until([&] { return eye().distance < 0.75 * camera.distance; }));
  EXPECT_EQ(eye().yaw_deg, dragged.yaw_deg) << "not held any more";
  hand_->key("minus");
  EXPECT_TRUE(frames_until([&] { return eye().distance > 0.75 * camera.distance; }));
  EXPECT_GT(changed(before, rest()), 0.2);
  viewer().set_camera(camera);
  EXPECT_EQ(changed(before, rest()), 0);
}

TEST_F(ViewerClicksTest, TheRightButtonTurnsTheLight) {
  viewer().set_settings("technique=cube-map");
  const Image<Rgb8> before = rest();
  const OrbitCamera camera = viewer().state().camera;
  hold(Hand::kRight);
  hand_->move(kMiddleX, kMiddleY - kHeight / 6.0);
  EXPECT_TRUE(frames_until([&] { return light_turn(viewer().state()) != Turn(); }));
  hand_->move(kMiddleX + 80, kMiddleY - kHeight / 6.0);
  EXPECT_TRUE(frames_until([&] { return value("light_yaw_deg") != 0; }));
  let_go(Hand::kRight);
  // The eye is at -X: what is ahead, at +X, went up.
  const Vec3 ahead = world_from_light(viewer().state()) * Vec3{1, 0, 0};
  EXPECT_NEAR(degrees(std::asin(ahead.z)), 30, 0.1) << "a sixth of half a turn";
  EXPECT_LT(ahead.y, -0.1) << "and to the right";
  EXPECT_GT(changed(before, rest()), 0.3);
  EXPECT_EQ(viewer().state().camera.yaw_deg, camera.yaw_deg);
}

TEST_F(ViewerClicksTest, PathsAndSettingsAreTyped) {
  const Environment card = testcard({Layout::kEquirect}, image_size(Layout::kEquirect, 64));
  save_picture(card.radiance, folder_ / "card.hdr");
  write_into("light path", (folder_ / "card.hdr").string());
  EXPECT_TRUE(frames_until([&] { return viewer().light_name() == "card.hdr"; }));
  EXPECT_TRUE(frames_until([&] { return hand_->title() == "card.hdr - Zonal"; })) << hand_->title();
  write_into("mesh path",
             write("tent.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n").string());
  EXPECT_TRUE(frames_until([&] { return viewer().mesh_name() == "tent.obj, 4 triangles"; }));
  click("mesh up");
  EXPECT_TRUE(frames_until([&] { return viewer().mesh_up() == MeshUp::kY; }));
  click("mesh up");
  EXPECT_TRUE(frames_until([&] { return viewer().mesh_up() == MeshUp::kFormat; }));
  for (const std::string_view shape : mesh_shape_names()) {
    click("mesh/" + std::string(shape));
    EXPECT_TRUE(frames_until([&] { return viewer().state().mesh == shape; })) << shape;
  }
  viewer().open_mesh("sphere");
  viewer().open_light("sky", small_sky);
  EXPECT_TRUE(frames_until([&] { return viewer().light_name() == "sky" && viewer().state().mesh == "sphere"; }));
  write_into("settings", "technique=phong&shininess=77");
  EXPECT_TRUE(frames_until([&] { return viewer().state().technique->id == "phong" && value("shininess") == 77; }));
  write_into("light path", "nothing.hdr");
  EXPECT_TRUE(frames_until([&] { return is_told("nothing.hdr"); })) << "what cannot be opened is a message";
}

TEST_F(ViewerClicksTest, AScreenshotIsTakenWhereItSays) {
  const std::filesystem::path path = folder_ / "shot.png";
  write_into("screenshot path", path.string());
  click("screenshot");
  EXPECT_TRUE(frames_until([&] { return is_told("shot.png"); }));
  EXPECT_EQ(load_picture(path, {}).pixels.width(), viewer().picture().size().width);
  click("dismiss");
  EXPECT_TRUE(frames_until([&] { return viewer().messages().empty(); }));
}

TEST_F(ViewerClicksTest, WorkIsCancelledByItsButton) {
  viewer().open_light("endless", endless_light);
  EXPECT_TRUE(frames_until([&] { return place_of("cancel").has_value(); }));
  click("cancel");
  EXPECT_TRUE(frames_until([&] { return is_told("endless: cancelled"); }));
  EXPECT_TRUE(frames_until([&] { return !place_of("cancel"); })) << "and there is nothing more to cancel";
  hand_->key("Escape");
  EXPECT_TRUE(frames_until([&] { return viewer().messages().empty(); })) << "Escape takes messages away";
}

TEST_F(ViewerClicksTest, AWindowOfAnySizeIsDrawn) {
  for (const ImageSize size : {ImageSize{240, 160}, ImageSize{60, 40}, ImageSize{1, 1}, ImageSize{400, 900}}) {
    viewer().say({"something to read", "and what to do", false});
    resize(size.width, size.height);
    for (int i = 0; i < 3; ++i) window().frame();
    keep_window(fmt::format("size_{}x{}", size.width, size.height));
    hand_->key("F1");
    for (int i = 0; i < 3; ++i) window().frame();
    hand_->key("Escape");
  }
  resize(kWidth, kHeight);
  EXPECT_TRUE(frames_until([&] { return viewer().picture().size().height == kHeight && viewer().idle(); }));
}

TEST_F(ViewerClicksTest, HelpComesAndGoes) {
  const auto shown = [&] { return place_of("help/close").has_value(); };
  EXPECT_FALSE(shown());
  click("help");
  EXPECT_TRUE(frames_until(shown));
  keep_window("help");
  click("help/close");
  EXPECT_TRUE(frames_until([&] { return !shown(); }));
  hand_->key("F1");
  EXPECT_TRUE(frames_until(shown));
  hand_->key("Escape");
  EXPECT_TRUE(frames_until([&] { return !shown(); }));
  const double yaw = viewer().state().camera.yaw_deg;
  hand_->key("Left");
  EXPECT_TRUE(frames_until([&] { return viewer().state().camera.yaw_deg != yaw; }))
      << "the keys are the picture's again";
}

}  // namespace
}  // namespace zonal
