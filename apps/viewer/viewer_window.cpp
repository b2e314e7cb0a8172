#include "apps/viewer/viewer_window.h"

#include <epoxy/gl.h>
// After the loader, whose names it would declare again.
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "apps/viewer/orbit_input.h"
#include "zonal/view/light_turn.h"

namespace zonal {
namespace {

constexpr double kPanelWidth = 340;  // before the screen's scale
constexpr int kSettling = 3;         // frames
constexpr int kLeft = 0, kRight = 1, kMiddle = 2;

}  // namespace

ViewerWindow::ViewerWindow(ViewerOptions options, ImageSize size)
    : window_("Zonal", size), viewer_(std::move(options), [] { ScreenWindow::wake(); }) {
  window_.set_events({.pointer_moved = [this](double x, double y) { pointer_moved(x, y); },
                      .button = [this](int index, bool pressed) { button(index, pressed); },
                      .scrolled = [this](double steps) { scrolled(steps); },
                      .key = [this](int code, bool pressed) { key(code, pressed); },
                      .dropped = [this](const std::vector<std::filesystem::path>& paths) { dropped(paths); }});
}

double ViewerWindow::panel_width() const { return std::min(kPanelWidth * window_.scale(), 0.5 * window_.size().width); }

ViewerWindow::Area ViewerWindow::picture_area() const {
  const ImageSize pixels = window_.framebuffer_size(), units = window_.size();
  const double pixels_a_unit = units.width > 0 ? static_cast<double>(pixels.width) / units.width : 1;
  const int left = static_cast<int>(std::lround(panel_width() * pixels_a_unit));
  return {left, 0, {std::max(0, pixels.width - left), pixels.height}};
}

void ViewerWindow::pointer_moved(double x, double y) {
  const double dx = x - x_, dy = y - y_;
  x_ = x, y_ = y;
  const ImageSize size = window_.size();
  if (held_[kLeft]) {
    OrbitCamera camera = viewer_.state().camera;
    orbit(camera, dx, dy, size.height);
    viewer_.set_camera(camera);
  }
  if (held_[kRight] && (dx != 0 || dy != 0)) {
    const ImageSize picture = {static_cast<int>(size.width - panel_width()), size.height};
    viewer_.drag_light(dragged_light(light_turn(viewer_.state()), viewer_.state().camera, dx, dy, picture));
  }
}

void ViewerWindow::button(int button, bool pressed) {
  if (button < kLeft || button > kMiddle) return;
  const bool was_held = std::exchange(held_[static_cast<std::size_t>(button)], pressed);
  if (button == kRight && was_held && !pressed) viewer_.release_light();
}

void ViewerWindow::scrolled(double steps) {
  OrbitCamera camera = viewer_.state().camera;
  zoom(camera, steps);
  viewer_.set_camera(camera);
}

void ViewerWindow::key(int key, bool pressed) {
  if (!pressed) return;
  constexpr double kStep = 20;  // as if dragged by so many pixels of a window 720 high: 5 degrees
  constexpr int kHeight = 720;
  OrbitCamera camera = viewer_.state().camera;
  switch (key) {
    case GLFW_KEY_LEFT:
      orbit(camera, kStep, 0, kHeight);
      break;
    case GLFW_KEY_RIGHT:
      orbit(camera, -kStep, 0, kHeight);
      break;
    case GLFW_KEY_UP:
      orbit(camera, 0, kStep, kHeight);
      break;
    case GLFW_KEY_DOWN:
      orbit(camera, 0, -kStep, kHeight);
      break;
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      zoom(camera, 1);
      break;
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      zoom(camera, -1);
      break;
    case GLFW_KEY_F1:
      panels_.help = !panels_.help;
      return;
    case GLFW_KEY_ESCAPE:
      leave();
      return;
    default:
      return;
  }
  viewer_.set_camera(camera);
}

void ViewerWindow::leave() {
  if (panels_.help) {
    panels_.help = false;
  } else {
    viewer_.dismiss_messages();
  }
  ImGui::SetWindowFocus(nullptr);
}

void ViewerWindow::dropped(const std::vector<std::filesystem::path>& paths) {
  if (!paths.empty()) viewer_.open(paths);
}

bool ViewerWindow::draw_frame() {
  const Area area = picture_area();
  if (area.size.width < 1 || area.size.height < 1) return false;  // made an icon
  viewer_.set_time(std::chrono::duration<double>(std::chrono::steady_clock::now() - opened_).count());
  const bool wants_more = viewer_.advance(area.size);

  if (viewer_.light_name() != titled_) {
    titled_ = viewer_.light_name();
    window_.set_title(titled_ + " - Zonal");
  }
  const ImageSize pixels = window_.framebuffer_size();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, pixels.width, pixels.height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  if (viewer_.picture().size().width > 0) viewer_.picture().show(area.left, area.bottom);

  window_.begin_panels();
  panels_.places.begin_frame();
  const auto width = static_cast<float>(panel_width());
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({width, static_cast<float>(window_.size().height)});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus |
                                      ImGuiWindowFlags_NoFocusOnAppearing;  // the keys are the picture's at first
  ImGui::Begin("panels", nullptr, kFlags);
  constexpr ImGuiTreeNodeFlags kOpen = ImGuiTreeNodeFlags_DefaultOpen;
  // A fisheye photograph, or what may be one as nobody can tell what else it is, comes first and open.
  const std::optional<Photograph>& photograph = viewer_.photograph();
  const bool asks = photograph && (photograph->said.is_fisheye || !photograph->picture->layout_is_known);
  const auto fisheye = [&] {
    if (asks && panels_.fisheye.shown != photograph->small) ImGui::SetNextItemOpen(true);
    if (ImGui::CollapsingHeader("Fisheye photograph")) draw_fisheye_panel(viewer_, panels_.fisheye);
  };
  if (asks) fisheye();
  if (ImGui::CollapsingHeader("Technique", kOpen)) draw_technique_panel(viewer_, panels_);
  if (ImGui::CollapsingHeader("Controls", kOpen)) {
    draw_highlight_panel(viewer_, panels_.paint);
    draw_control_panel(viewer_, panels_);
  }
  if (ImGui::CollapsingHeader("Picture", kOpen)) draw_picture_panel(viewer_, panels_);
  if (ImGui::CollapsingHeader("Light and object", kOpen)) draw_light_panel(viewer_, panels_);
  if (!asks) fisheye();
  ImGui::End();
  constexpr float kMargin = 10;
  const auto whole = static_cast<float>(window_.size().width), high = static_cast<float>(window_.size().height);
  draw_notices(viewer_, panels_, width + kMargin, kMargin, whole - width - 2 * kMargin);
  draw_help_button(panels_, whole, high);
  draw_help(panels_, whole, high);
  window_.end_panels();
  return wants_more;
}

bool ViewerWindow::frame() {
  const bool wants_more = draw_frame();
  window_.show();
  return wants_more;
}

void ViewerWindow::run(const Run& run) {
  constexpr double kMovingS = 1.0 / 10, kPatienceS = 0.5;
  const std::stop_callback on_stop(run.stop, [] { ScreenWindow::wake(); });
  bool wants_more = true;
  while (!window_.is_closed() && !run.stop.stop_requested()) {
    if (wants_more || frames_owed_ > 0) {
      window_.poll();
    } else if (viewer_.state().technique->moves) {
      window_.wait(kMovingS);
    } else {
      // Woken by events and by the background; while that works, also to show how far it is.
      window_.wait(viewer_.progress().empty() ? 0 : kPatienceS);
    }
    if (window_.take_activity()) frames_owed_ = kSettling;
    if (frames_owed_ > 0) --frames_owed_;
    wants_more = frame();
  }
}

void run_viewer(ViewerOptions options, const Run& run) {
  ViewerWindow window(std::move(options), {1280, 800});
  window.run(run);
}

}  // namespace zonal
