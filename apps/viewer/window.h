#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "zonal/sphere/projection.h"

struct GLFWwindow;

namespace zonal {

/// What a person does to a window. Positions in its own units, the origin at the top left.
struct WindowEvents {
  std::function<void(double x, double y)> pointer_moved;
  std::function<void(int button, bool pressed)> button;  ///< 0 left, 1 right, 2 middle
  std::function<void(double steps)> scrolled;            ///< away from the person is positive
  std::function<void(int key, bool pressed)> key;        ///< as GLFW numbers them
  std::function<void(const std::vector<std::filesystem::path>&)> dropped;
};

/// A window of the system with an OpenGL 4.1 context, which is current while it lives, and Dear ImGui in it. One at a
/// time, on the main thread.
class ScreenWindow {
 public:
  /// Throws Error{kUsage} where there is no display or no such OpenGL.
  ScreenWindow(const char* title, ImageSize);
  ~ScreenWindow();
  ScreenWindow(const ScreenWindow&) = delete;
  ScreenWindow& operator=(const ScreenWindow&) = delete;

  /// The panels get every event first, and keep those that are meant for them.
  void set_events(WindowEvents events) { events_ = std::move(events); }
  void set_title(const std::string&);
  bool is_closed() const;
  void close();
  /// In pixels, which may be smaller than the window's units.
  ImageSize framebuffer_size() const;
  ImageSize size() const;
  /// Of the left top corner on the screen, in the window's units.
  std::array<int, 2> position() const;
  /// How many units something is that takes one on a common screen.
  float scale() const;

  /// Sleeps until something happens, or `seconds` at most where they are positive; takes what happened.
  void wait(double seconds = 0);
  /// Takes what happened, if anything did.
  void poll();
  /// Ends a wait. From any thread.
  static void wake();
  /// Whether anything happened since the last call.
  bool take_activity();

  void begin_panels();
  void end_panels();
  void show();

 private:
  struct Callbacks;
  GLFWwindow* window_ = nullptr;
  WindowEvents events_;
  bool activity_ = true;
};

}  // namespace zonal
