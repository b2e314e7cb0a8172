#include "apps/viewer/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/io/environment_file.h"
#include "zonal/io/file.h"
#include "zonal/io/picture.h"
#include "zonal/io/png.h"
#include "zonal/view/light_turn.h"
#include "zonal/view/opening_exposure.h"

namespace zonal {
namespace {

constexpr double kFrameMs = 40;           // of drawing, so that with the panels there are about 20 frames a second
constexpr std::size_t kMostMessages = 6;  // more would hide the picture

}  // namespace

bool is_mesh_path(const std::filesystem::path& path) {
  std::string end = path.extension().string();
  std::ranges::transform(end, end.begin(), [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return end == ".obj" || end == ".ply" || end == ".gltf" || end == ".glb";
}

Viewer::Viewer(ViewerOptions options, std::function<void()> wake)
    : state_(std::move(options.state)),
      mesh_options_(options.mesh),
      exposure_is_given_(state_.controls.contains("exposure_ev")),
      light_work_(wake, options.run),
      mesh_work_(wake, options.run),
      live_work_(wake, options.run),
      highlight_work_(wake, options.run) {
  if (options.highlight) highlight_.replace(std::move(*options.highlight));
  open_mesh(state_.mesh);
  open_light(std::move(options.light_name), std::move(options.light));
}

bool Viewer::guarded(const std::function<void()>& act) {
  try {
    act();
    return true;
  } catch (const Error& e) {
    say({e.what(), e.hint()});
  } catch (const std::exception& e) {
    say({fmt::format("this is an error of the program: {}", e.what()), "please report it with what you did"});
  }
  return false;
}

void Viewer::stale(bool other_cost) {
  picture_.invalidate(other_cost);
  difference_.reset();
  difference_failed_ = false;
}

void Viewer::set_technique(const Technique& technique) {
  if (state_.technique == &technique) return;
  state_.technique = &technique;
  find_used();
  if (live_) {  // its data are those that the other technique looks at
    live_.reset();
    upload_light();
  }
  stale(true);
}

void Viewer::set_control(std::string_view name, double value) {
  if (state_.value(name) == value) return;
  if (!guarded([&] { state_.set(name, value); })) return;
  if (name == "exposure_ev") exposure_is_given_ = true;
  stale(name == "compare");
}

void Viewer::set_camera(const OrbitCamera& camera) {
  state_.camera = camera;
  stale();
}

void Viewer::set_time(double seconds) {
  // What moves does so once a second: a new picture for the same second would be the old one.
  const bool another = std::floor(seconds) != std::floor(state_.time_s);
  state_.time_s = seconds;
  if (another && state_.technique->moves) stale();
}

void Viewer::set_settings(const std::string& text) {
  guarded([&] {
    ViewState state = parse_state(text);
    const Technique& technique = *state.technique;
    if (state.mesh != state_.mesh) open_mesh(state.mesh);
    state.technique = state_.technique;
    state.mesh = state_.mesh;
    exposure_is_given_ = state.controls.contains("exposure_ev");
    state_ = std::move(state);
    set_technique(technique);
    stale(true);
  });
}

void Viewer::open(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::filesystem::path> pictures, meshes;
  for (const std::filesystem::path& path : paths) (is_mesh_path(path) ? meshes : pictures).push_back(path);
  if (!meshes.empty()) open_mesh(meshes.back().string());
  if (meshes.size() > 1) {
    say({fmt::format("{} meshes: one is shown at a time", meshes.size()),
         "the last of them is " + meshes.back().filename().string(), false});
  }
  if (pictures.empty()) return;
  open_light(environment_name(pictures), [pictures](const Run& run) { return load_light_picture(pictures, run); });
}

void Viewer::open_light(std::string name, LightLoader loader) {
  light_work_.replace("light: " + name, [this, name, loader = std::move(loader)](const Run& run) {
    run.progress("reading", 0);
    return lit_by(photograph_of(name, loader(run)), run);
  });
}

std::function<void()> Viewer::lit_by(Photograph photograph, const Run& run) {
  if (!photograph.tells_light()) {
    return [this, photograph = std::move(photograph)] {
      photograph_ = photograph;
      say({photograph.name + ": neither its shape nor its name says how it shows the sphere",
           "if it is a fisheye photograph, say so in the panel; else start with zonal view --from", false});
    };
  }
  const ViewDataOptions sizes;
  auto data = std::make_shared<const ViewData>(view_data(light_of(photograph, sizes.panorama_px, run), sizes, run));
  photograph.applied = photograph.said;
  return [this, photograph = std::move(photograph), data] {
    photograph_ = photograph;
    use_light(data, photograph.name);
  };
}

void Viewer::set_photograph(const PhotographSettings& settings) {
  if (!photograph_) return;
  photograph_->said = settings;
  light_work_.replace("light: " + photograph_->name,
                      [this, photograph = *photograph_](const Run& run) { return lit_by(photograph, run); });
}

void Viewer::open_mesh(const std::string& shape_or_file) {
  mesh_work_.replace("mesh: " + std::filesystem::path(shape_or_file).filename().string(),
                     [this, shape_or_file, options = mesh_options_](const Run& run) {
                       auto loaded = std::make_shared<const LoadedMesh>(mesh_of(shape_or_file, options, run));
                       return [this, shape_or_file, loaded] {
                         scene_.set_mesh(loaded->mesh);
                         has_mesh_ = true;
                         state_.mesh = shape_or_file;
                         mesh_name_ =
                             fmt::format("{}, {} triangles", std::filesystem::path(shape_or_file).filename().string(),
                                         loaded->mesh.indices.size() / 3);
                         for (const std::string& note : loaded->notes) say({note, {}, false});
                         stale(true);
                       };
                     });
}

void Viewer::set_mesh_up(MeshUp up) {
  mesh_options_.up = up;
  if (has_mesh_) open_mesh(state_.mesh);
}

void Viewer::use_light(std::shared_ptr<const ViewData> data, std::string name) {
  light_ = std::move(data);
  live_.reset();
  light_name_ = std::move(name);
  if (!exposure_is_given_) state_.set("exposure_ev", opening_exposure_ev(*light_));
  find_used();
  upload_light();
}

void Viewer::use_live(std::shared_ptr<const LiveLight> live) {
  live_ = std::move(live);
  upload_light();
}

void Viewer::upload_light() {
  if (light_) {
    scene_.set_light(live_ ? live_->data : *light_);
    upload_highlight();
  }
  stale();
}

void Viewer::upload_highlight() { scene_.set_texture(own_highlight_texture(highlight_.picture())); }

void Viewer::paint_highlight(double u, double v, const Brush& brush) {
  highlight_.stroke_to(u, v, brush);
  upload_highlight();
  stale();
}

void Viewer::replace_highlight(Image<Rgb> picture) {
  highlight_.replace(std::move(picture));
  upload_highlight();
  stale();
}

void Viewer::open_highlight(std::filesystem::path path) {
  std::string title = "highlight: " + path.filename().string();
  highlight_work_.replace(std::move(title), [this, path = std::move(path)](const Run& run) {
    auto picture = std::make_shared<Image<Rgb>>(own_highlight(load_picture(path, {}, run).pixels));
    return [this, picture] {
      replace_highlight(std::move(*picture));
      set_control("highlight_source", control_named("highlight_source").greatest);
    };
  });
}

void Viewer::find_used() {
  if (!light_) return;
  used_ = names_used(*state_.technique, *light_);
  live_possible_ = can_be_live(used_, *light_);
}

void Viewer::drag_light(const Turn& turn) {
  guarded([&] { set_light_turn(state_, turn); });
  stale();
  dragging_light_ = true;
  if (!light_) return;
  // Timed for every technique, shown where the technique looks at nothing else.
  live_work_.follow("turning the light",
                    [this, whole = light_, used = used_, fits = live_possible_, state = state_](const Run& run) {
                      auto live = std::make_shared<const LiveLight>(live_light(*whole, used, state, run));
                      return [this, whole, live, fits, technique = state.technique] {
                        live_times_ = live->times;
                        ++live_turns_;
                        if (fits && dragging_light_ && whole == light_ && technique == state_.technique) use_live(live);
                      };
                    });
}

void Viewer::release_light() {
  dragging_light_ = false;
  if (!live_) return;
  live_.reset();
  upload_light();
}

void Viewer::save_screenshot(std::filesystem::path path) { screenshot_ = std::move(path); }

std::vector<WorkProgress> Viewer::progress() const {
  std::vector<WorkProgress> all;
  for (const BackgroundWork* work : {&light_work_, &mesh_work_, &highlight_work_}) {
    if (std::optional<WorkProgress> progress = work->progress()) all.push_back(std::move(*progress));
  }
  return all;
}

void Viewer::cancel() {
  light_work_.cancel();
  mesh_work_.cancel();
  highlight_work_.cancel();
}

void Viewer::say(ViewerMessage message) {
  const auto same = [&](const ViewerMessage& old) { return old.text == message.text; };
  std::erase_if(messages_, same);
  messages_.push_back(std::move(message));
  while (messages_.size() > kMostMessages) messages_.pop_front();
}

void Viewer::collect(BackgroundWork& work) {
  const std::optional<WorkResult> result = work.collect();
  if (!result) return;
  if (result->deliver) {
    guarded(result->deliver);
  } else {
    say({result->title + ": " + (result->cancelled ? "cancelled" : result->message), result->hint, !result->cancelled});
    if (&work == &light_work_ && photograph_) photograph_->said = photograph_->applied;
  }
}

ViewState Viewer::drawn_state() const {
  ViewState state = state_;
  if (live_) set_light_turn(state, turn_of(world_from_light(state_) * transpose(live_->world_from_light)));
  return state;
}

void Viewer::draw(ImageSize size) {
  const bool drawn = guarded([&] { picture_.advance(scene_, drawn_state(), size, kFrameMs); });
  const Technique* technique = state_.technique;
  if (drawn) {
    last_drawn_ = technique;
  } else if (last_drawn_ != nullptr && last_drawn_ != technique) {
    set_technique(*last_drawn_);
  }
}

/// Small first, for a sum over the panorama at each pixel takes its time; as finely as a frame's time allows.
void Viewer::measure() {
  constexpr ImageSize kSmall = {48, 27}, kFine = {320, 180};
  constexpr double kTimes = 320 * 180 / (48.0 * 27);
  difference_failed_ = !guarded([&] {
    const auto start = std::chrono::steady_clock::now();
    difference_ = scene_.difference(drawn_state(), kSmall.width, kSmall.height);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (kTimes * ms < 10 * kFrameMs) difference_ = scene_.difference(drawn_state(), kFine.width, kFine.height);
  });
}

void Viewer::write_screenshot() {
  const std::filesystem::path path = std::exchange(screenshot_, {});
  guarded([&] {
    const std::vector<std::byte> png = encode_png(picture_.read());
    write_file(path, png);
    say({fmt::format("wrote {}", path.string()), {}, false});
  });
}

bool Viewer::advance(ImageSize size) {
  collect(light_work_);
  collect(mesh_work_);
  collect(live_work_);
  collect(highlight_work_);
  if (!light_ || !has_mesh_) return false;
  const bool was_done = picture_.done() && size == picture_.size();
  if (!was_done) draw(size);
  if (!was_done || !picture_.done()) return true;
  // In frames of their own, when nobody waits for one.
  const bool measured = difference_ || difference_failed_;
  if (dragging_light_ || (measured && picture_.is_smooth())) {
    if (screenshot_.empty()) return false;
    write_screenshot();
  } else if (measured) {
    smooth();
  } else {
    measure();
  }
  return true;
}

void Viewer::smooth() {
  // Half of a frame's time: a hand that begins to move is not held up.
  guarded([&] { picture_.smooth(scene_, drawn_state(), kFrameMs / 2); });
}

bool Viewer::idle() const {
  const bool works = light_work_.busy() || mesh_work_.busy() || live_work_.busy() || highlight_work_.busy();
  return !works && light_ && has_mesh_ && picture_.is_smooth() && (difference_ || difference_failed_);
}

}  // namespace zonal
