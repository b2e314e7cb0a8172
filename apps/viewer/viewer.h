#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/viewer/background_work.h"
#include "apps/viewer/highlight_painter.h"
#include "apps/viewer/live_light.h"
#include "apps/viewer/photograph.h"
#include "apps/viewer/scene_picture.h"
#include "zonal/gl/scene.h"
#include "zonal/light/orient.h"
#include "zonal/view/mesh_file.h"
#include "zonal/view/view_state.h"

namespace zonal {

/// Something that a person should read.
struct ViewerMessage {
  std::string text, hint;
  bool failure = true;
};

struct ViewerOptions {
  ViewState state;  ///< its mesh may be a file
  LightLoader light;
  std::string light_name;
  MeshLoadOptions mesh;
  Run run;  ///< threads, executor and instruction set of all that runs in the background
  std::optional<Image<Rgb>> highlight = {};  ///< a person's own, as own_highlight() gives it
};

/// What a window shows and what can be done with it, without the window: the settings, the scene, and the work behind
/// them. Needs a current context of OpenGL 4.1 for all its life. Failures become messages.
class Viewer {
 public:
  /// `wake` asks for another frame, from any thread.
  Viewer(ViewerOptions, std::function<void()> wake);

  const ViewState& state() const { return state_; }
  void set_technique(const Technique&);
  void set_control(std::string_view name, double value);
  void set_camera(const OrbitCamera&);
  /// Seconds since the window was opened, for techniques that move by themselves.
  void set_time(double seconds);
  /// Settings as a page keeps them in its address. What it cannot take is a message.
  void set_settings(const std::string& text);

  /// Images and meshes by their names' ends; six images are the faces of a cube. Newer files replace what still loads.
  void open(const std::vector<std::filesystem::path>&);
  void open_light(std::string name, LightLoader);
  /// The picture that the light is made of, or that was opened last and whose layout nobody can guess.
  const std::optional<Photograph>& photograph() const { return photograph_; }
  /// Makes the light of the same picture anew, as these say. Where that fails or is cancelled, the last ones stay.
  void set_photograph(const PhotographSettings&);
  /// A shape's name or a file.
  void open_mesh(const std::string& shape_or_file);
  void set_mesh_up(MeshUp);
  MeshUp mesh_up() const { return mesh_options_.up; }

  /// Between these the light turns for real, in the background, and the newest turn is shown when it is done.
  void drag_light(const Turn&);
  void release_light();
  /// Of the last one; nullopt before the first. See live_light().
  const std::optional<LiveTimes>& live_times() const { return live_times_; }
  int live_turns() const { return live_turns_; }
  bool is_turning() const { return live_work_.busy(); }
  /// Whether the technique shows it; if not, its lookups are turned in place of the light.
  bool is_live_possible() const { return live_possible_; }

  /// A person's own highlight: painted, the object follows at once, or a picture file, read in the background and then
  /// chosen.
  const HighlightPainter& highlight() const { return highlight_; }
  void paint_highlight(double u, double v, const Brush&);
  void end_highlight_stroke() { highlight_.end_stroke(); }
  void replace_highlight(Image<Rgb>);
  void open_highlight(std::filesystem::path);

  /// As soon as the picture is done and its edges are smooth.
  void save_screenshot(std::filesystem::path);

  /// What runs in the background, for the progress bars.
  std::vector<WorkProgress> progress() const;
  void cancel();

  /// Collects what is done and draws for a frame's time. Returns whether another frame is wanted at once.
  bool advance(ImageSize);
  const ScenePicture& picture() const { return picture_; }
  /// Whether everything is loaded, drawn, measured and smooth.
  bool idle() const;

  /// nullopt while it is not known.
  const std::optional<Difference>& difference() const { return difference_; }
  const std::string& light_name() const { return light_name_; }
  const std::string& mesh_name() const { return mesh_name_; }

  const std::deque<ViewerMessage>& messages() const { return messages_; }
  void say(ViewerMessage);
  void dismiss_messages() { messages_.clear(); }

 private:
  /// Returns whether it went well; if not, there is a message.
  bool guarded(const std::function<void()>&);
  void stale(bool other_cost = false);
  void collect(BackgroundWork&);
  /// The light of a photograph, computed; what to do with it in the window.
  std::function<void()> lit_by(Photograph, const Run&);
  void use_light(std::shared_ptr<const ViewData>, std::string name);
  void use_live(std::shared_ptr<const LiveLight>);
  void upload_light();
  void upload_highlight();
  void find_used();
  void draw(ImageSize);
  void measure();
  void smooth();
  void write_screenshot();
  /// What is drawn: turned by what the light's pixels are not turned by already.
  ViewState drawn_state() const;

  ViewState state_;
  MeshLoadOptions mesh_options_;
  std::string light_name_, mesh_name_;
  std::optional<Photograph> photograph_;
  std::shared_ptr<const ViewData> light_;  // null before the first is there
  std::shared_ptr<const LiveLight> live_;  // null unless the light is dragged
  std::optional<LiveTimes> live_times_;
  int live_turns_ = 0;
  std::vector<std::string> used_;  // of the light, by the technique
  bool live_possible_ = false, dragging_light_ = false, exposure_is_given_ = false, has_mesh_ = false;
  const Technique* last_drawn_ = nullptr;  // that the driver took
  Scene scene_;
  ScenePicture picture_;
  HighlightPainter highlight_;
  std::optional<Difference> difference_;
  bool difference_failed_ = false;
  std::filesystem::path screenshot_;
  std::deque<ViewerMessage> messages_;
  BackgroundWork light_work_, mesh_work_, live_work_, highlight_work_;  // last: their tasks end first
};

/// A path that a mesh reader is meant for, by its end.
bool is_mesh_path(const std::filesystem::path&);

}  // namespace zonal
