#pragma once

#include <array>
#include <chrono>

#include "apps/viewer/panels.h"
#include "apps/viewer/viewer.h"
#include "apps/viewer/window.h"

namespace zonal {

/// The viewer in its window: panels on the left, the picture on the right. Left drag goes around the object, right drag
/// turns the light, the wheel zooms; arrow keys and + - move the eye as well. F1 shows all of it.
class ViewerWindow {
 public:
  /// Throws Error{kUsage} where no window can be opened.
  ViewerWindow(ViewerOptions, ImageSize);

  /// Until it is closed, or the run is stopped.
  void run(const Run&);
  /// Draws a frame, which is then not yet shown. Returns whether another one is wanted at once.
  bool draw_frame();
  /// One frame, shown.
  bool frame();

  ScreenWindow& window() { return window_; }
  Viewer& viewer() { return viewer_; }
  /// Of the last frame.
  const WidgetPlaces& places() const { return panels_.places; }
  const FisheyePanel& fisheye_panel() const { return panels_.fisheye; }

  // What a person does, as the window passes it on. Positions in the window's units.
  void pointer_moved(double x, double y);
  void button(int button, bool pressed);
  void scrolled(double steps);
  void key(int key, bool pressed);
  void dropped(const std::vector<std::filesystem::path>&);

 private:
  struct Area {
    int left = 0, bottom = 0;  // in pixels of the framebuffer
    ImageSize size;
  };
  Area picture_area() const;
  double panel_width() const;
  /// Closes what lies over the picture and gives it the keys.
  void leave();

  ScreenWindow window_;
  Viewer viewer_;
  PanelState panels_;
  std::string titled_;  // what the window's title names
  double x_ = 0, y_ = 0;
  std::array<bool, 3> held_ = {};
  int frames_owed_ = 3;  // the panels settle over some frames after each event
  std::chrono::steady_clock::time_point opened_ = std::chrono::steady_clock::now();
};

/// Opens the window and returns when it is closed.
void run_viewer(ViewerOptions, const Run& = {});

}  // namespace zonal
