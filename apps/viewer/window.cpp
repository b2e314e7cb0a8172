#include "apps/viewer/window.h"

#include <epoxy/gl.h>
// After the loader, whose names it would declare again.
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <string>
#include <utility>

#include "apps/viewer/plain_text.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

[[noreturn]] void fail(const char* what) {
  const char* why = nullptr;
  glfwGetError(&why);
  throw Error(ErrorKind::kUsage, std::string(what) + (why != nullptr ? std::string(": ") + why : std::string()),
              "without a display, zonal view --screenshot FILE draws a picture and --html FILE writes a page");
}

}  // namespace

/// GLFW's events, to the panels and to whoever listens.
struct ScreenWindow::Callbacks {
  static ScreenWindow& of(GLFWwindow* window) {
    auto& self = *static_cast<ScreenWindow*>(glfwGetWindowUserPointer(window));
    self.activity_ = true;
    return self;
  }
  static void moved(GLFWwindow* window, double x, double y) {
    const ScreenWindow& self = of(window);
    if (self.events_.pointer_moved) self.events_.pointer_moved(x, y);
  }
  static void button(GLFWwindow* window, int button, int action, int mods) {
    const ScreenWindow& self = of(window);
    ImGui_ImplGlfw_MouseButtonCallback(window, button, action, mods);
    const bool pressed = action == GLFW_PRESS;
    // Releases are everyone's: a drag may end over a panel.
    if (self.events_.button && (!pressed || !ImGui::GetIO().WantCaptureMouse)) self.events_.button(button, pressed);
  }
  static void scrolled(GLFWwindow* window, double dx, double dy) {
    const ScreenWindow& self = of(window);
    ImGui_ImplGlfw_ScrollCallback(window, dx, dy);
    if (self.events_.scrolled && !ImGui::GetIO().WantCaptureMouse) self.events_.scrolled(dy);
  }
  static void key(GLFWwindow* window, int key, int code, int action, int mods) {
    const ScreenWindow& self = of(window);
    ImGui_ImplGlfw_KeyCallback(window, key, code, action, mods);
    // Help and the way out of everything are there whatever has the keys, but for a field that someone types in.
    const ImGuiIO& io = ImGui::GetIO();
    const bool everywhere = (key == GLFW_KEY_F1 || key == GLFW_KEY_ESCAPE) && !io.WantTextInput;
    if (self.events_.key && (everywhere || !io.WantCaptureKeyboard)) self.events_.key(key, action != GLFW_RELEASE);
  }
  static void character(GLFWwindow* window, unsigned code) {
    of(window);
    ImGui_ImplGlfw_CharCallback(window, code);
  }
  static void dropped(GLFWwindow* window, int count, const char** paths) {
    const ScreenWindow& self = of(window);
    if (self.events_.dropped) self.events_.dropped({paths, paths + count});
  }
  static void focused(GLFWwindow* window, int focus) {
    of(window);
    ImGui_ImplGlfw_WindowFocusCallback(window, focus);
  }
  static void entered(GLFWwindow* window, int inside) {
    of(window);
    ImGui_ImplGlfw_CursorEnterCallback(window, inside);
  }
  static void changed(GLFWwindow* window) { of(window); }
  static void resized(GLFWwindow* window, int, int) { of(window); }
};

ScreenWindow::ScreenWindow(const char* title, ImageSize size) {
  if (!glfwInit()) fail("no window can be opened");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(size.width, size.height, title, nullptr, nullptr);
  if (window_ == nullptr) {
    try {
      fail("no window with OpenGL 4.1 can be opened");
    } catch (...) {
      glfwTerminate();
      throw;
    }
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  glfwSetCursorPosCallback(window_, Callbacks::moved);
  glfwSetMouseButtonCallback(window_, Callbacks::button);
  glfwSetScrollCallback(window_, Callbacks::scrolled);
  glfwSetKeyCallback(window_, Callbacks::key);
  glfwSetCharCallback(window_, Callbacks::character);
  glfwSetDropCallback(window_, Callbacks::dropped);
  glfwSetWindowFocusCallback(window_, Callbacks::focused);
  glfwSetCursorEnterCallback(window_, Callbacks::entered);
  glfwSetWindowRefreshCallback(window_, Callbacks::changed);
  glfwSetFramebufferSizeCallback(window_, Callbacks::resized);

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // a viewer leaves no files behind
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  load_font(scale());
  ImGui::GetStyle().ScaleAllSizes(scale());
  ImGui_ImplGlfw_InitForOpenGL(window_, false);
  ImGui_ImplOpenGL3_Init("#version 410 core");
}

ScreenWindow::~ScreenWindow() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void ScreenWindow::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
bool ScreenWindow::is_closed() const { return glfwWindowShouldClose(window_); }
void ScreenWindow::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

ImageSize ScreenWindow::framebuffer_size() const {
  ImageSize size;
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  return size;
}

ImageSize ScreenWindow::size() const {
  ImageSize size;
  glfwGetWindowSize(window_, &size.width, &size.height);
  return size;
}

std::array<int, 2> ScreenWindow::position() const {
  std::array<int, 2> place = {};
  glfwGetWindowPos(window_, &place[0], &place[1]);
  return place;
}

float ScreenWindow::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  // Where a unit is more than a pixel, the system has scaled already.
  const int units = size().width, pixels = framebuffer_size().width;
  return pixels > 0 ? x * static_cast<float>(units) / static_cast<float>(pixels) : x;
}

void ScreenWindow::wait(double seconds) {
  if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwWaitEvents();
  }
}

void ScreenWindow::poll() { glfwPollEvents(); }
void ScreenWindow::wake() { glfwPostEmptyEvent(); }
bool ScreenWindow::take_activity() { return std::exchange(activity_, false); }

void ScreenWindow::begin_panels() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void ScreenWindow::end_panels() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void ScreenWindow::show() { glfwSwapBuffers(window_); }

}  // namespace zonal
