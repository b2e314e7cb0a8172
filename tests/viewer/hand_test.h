#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace zonal {

/// A hand at the mouse and the keyboard: events of the X server itself, through xdotool, to the window whose title ends
/// as given. Positions in the window's units, the origin at the top left. Nothing waits for the window: its events keep
/// their order.
class Hand {
 public:
  static constexpr int kLeft = 1, kRight = 3, kWheelUp = 4, kWheelDown = 5;

  static bool exists() { return std::system("command -v xdotool >/dev/null") == 0; }
  explicit Hand(const std::string& title_end)
      : window_(answer(fmt::format("xdotool search --sync --onlyvisible --name '{}$'", title_end))) {}

  void move(double x, double y) const {
    act(fmt::format("mousemove --window {} {} {}", window_, static_cast<int>(x), static_cast<int>(y)));
  }
  void press(int button) const { act(fmt::format("mousedown {}", button)); }
  void release(int button) const { act(fmt::format("mouseup {}", button)); }
  void click(int button, int times = 1) const { act(fmt::format("click --repeat {} --delay 1 {}", times, button)); }
  void key_down(const std::string& key) const { act("keydown " + key); }
  void key_up(const std::string& key) const { act("keyup " + key); }
  void key(const std::string& keys) const { act("key " + keys); }
  void write(const std::string& text) const { act(fmt::format("type --delay 1 '{}'", text)); }
  void resize(int width, int height) const { act(fmt::format("windowsize {} {} {}", window_, width, height)); }
  std::string title() const { return answer("xdotool getwindowname " + window_); }

 private:
  static void act(const std::string& what) {
    if (std::system(("xdotool " + what).c_str()) != 0) ++failures;
  }
  static std::string answer(const std::string& command) {
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return text;
    for (int c; (c = std::fgetc(pipe)) != EOF && c != '\n';) text += static_cast<char>(c);
    pclose(pipe);
    return text;
  }

  std::string window_;

 public:
  static inline int failures = 0;  ///< of xdotool itself
};

}  // namespace zonal
