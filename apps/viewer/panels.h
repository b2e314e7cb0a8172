#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/viewer/circle_drag.h"
#include "apps/viewer/picture_texture.h"
#include "apps/viewer/viewer.h"
#include "apps/viewer/widget_places.h"
#include "zonal/gl/texture.h"

namespace zonal {

// The parts of the window beside the picture. They draw what the viewer knows and call its verbs; what they keep
// themselves is what a person is typing.

/// The photograph in its panel, and what a person does to its circle before the light follows.
struct FisheyePanel {
  std::optional<GpuTexture> picture;
  std::shared_ptr<const Image<Rgb8>> shown;  ///< what the texture is of
  PhotographSettings edited;
  bool is_edited = false;  ///< something is held, or typed into
  bool is_round = true;
  CircleHandle held = CircleHandle::kNone;
  PixelPoint grabbed;
  PixelCircle before;                  ///< the circle when it was grabbed
  float left = 0, top = 0, scale = 0;  ///< where the picture is: units of the window, and so many a pixel of it
};

/// The brush as a person has set it.
struct PaintState {
  float radius = 0.12f, brightness = 3, color[3] = {1, 1, 1};
  bool erases = false;
  std::string path;
  int shown_edition = -1;  // of the viewer's highlight
  PictureTexture shown;
};

/// What has no place in the viewer.
struct PanelState {
  FisheyePanel fisheye;
  std::string light_path, mesh_path, screenshot_path = "zonal-view.png", settings;
  bool settings_are_typed = false;
  PaintState paint;
  bool help = false;  ///< whether it is shown
  WidgetPlaces places;
};

/// All techniques in their chapters, and what the chosen one is.
void draw_technique_panel(Viewer&, PanelState&);
/// Sliders, lists and marks as the table of controls has them: the common ones, those of the technique.
void draw_control_panel(Viewer&, PanelState&);
/// A disc to paint a highlight on, where the settings ask for a person's own.
void draw_highlight_panel(Viewer&, PaintState&);
/// The light and the object: names, files, turning, how long a turn takes.
void draw_light_panel(Viewer&, PanelState&);
/// A picture as a fisheye photograph: the circle of its lens to drag and to type, the lens, the ground.
void draw_fisheye_panel(Viewer&, FisheyePanel&);
/// The difference to the exact answer, time of drawing, screenshot, settings.
void draw_picture_panel(Viewer&, PanelState&);
/// Progress with a way to stop it, and messages, over the picture.
void draw_notices(Viewer&, PanelState&, float left, float top, float width);
/// A button in a corner of the picture that opens and closes what draw_help() shows.
void draw_help_button(PanelState&, float right, float bottom);
/// What mouse and keys do, in the middle of a window of this size, while the state says so.
void draw_help(PanelState&, float width, float height);

}  // namespace zonal
