#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "apps/zonal/choices.h"
#include "apps/zonal/input_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "apps/zonal/view_screenshot.h"
#include "apps/zonal/view_sheet.h"
#include "apps/zonal/view_window.h"
#include "zonal/base/error.h"
#include "zonal/io/environment_file.h"
#include "zonal/io/file.h"
#include "zonal/io/picture.h"
#include "zonal/light/synthetic.h"
#include "zonal/view/opening_exposure.h"
#include "zonal/view/own_highlight.h"
#include "zonal/view/page.h"
#include "zonal/view/view_data.h"
#include "zonal/view/view_state.h"
#ifdef ZONAL_HAS_WEB
#include "apps/web/module.h"
#endif

namespace zonal {
namespace {

struct ViewOptions {
  InputOptions input;
  std::string technique, mesh, settings;
  std::filesystem::path screenshot, sheet, html, highlight;
  std::string size = "1280x720";
  MeshLoadOptions mesh_loading;
  bool list = false;
};

/// What to look at without a file.
Environment clear_day(const Run& run) {
  return daylight_sky({Layout::kEquirect}, image_size(Layout::kEquirect, 256), {}, run);
}

Environment panorama_of(const ViewOptions& options, Call& call) {
  if (options.input.paths.empty()) return clear_day(call.run);
  Input input = read_input(options.input, call);
  return whole_light(input, options.input, call).environment;
}

std::optional<MeshUp> mesh_up_named(std::string_view name) {
  if (name == "format") return MeshUp::kFormat;
  if (name == "y") return MeshUp::kY;
  if (name == "z") return MeshUp::kZ;
  return std::nullopt;
}

ViewState state_of(const ViewOptions& options) {
  std::string text = options.settings;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format("{}{}={}", text.empty() ? "" : "&", name, value);
  };
  // A highlight of one's own is to be seen, unless other settings say otherwise: those that come later count.
  if (!options.highlight.empty()) {
    text = "technique=highlight-map&highlight_source=2" + (text.empty() ? text : "&" + text);
  }
  add("technique", options.technique);
  ViewState state = parse_state(text);
  if (!options.mesh.empty()) state.mesh = options.mesh;  // a path may have any characters in it
  return state;
}

std::optional<Image<Rgb>> highlight_of(const ViewOptions& options, Call& call) {
  if (options.highlight.empty()) return std::nullopt;
  const Picture picture = load_picture(options.highlight, {}, call.run);
  for (const std::string& note : picture.notes) call.console.note(note);
  return own_highlight(picture.pixels);
}

void list_techniques(Call& call) {
  JsonValue::Array list;
  std::string_view group;
  for (const Technique& technique : all_techniques()) {
    if (technique.group != group) call.console.answer(fmt::format("{}", group = technique.group));
    call.console.answer(fmt::format("  {:18} {}", technique.id, technique.title));
    list.push_back(JsonValue::Object{{"id", std::string(technique.id)}, {"title", std::string(technique.title)}});
  }
  call.console.answer("Settings");
  for (const Control& control : all_controls()) {
    call.console.answer(fmt::format("  {:18} {}, {} to {}, {} at first", control.name, control.label,
                                    shortest(control.least), shortest(control.greatest), shortest(control.initial)));
  }
  call.console.field("techniques", list);
}

std::string light_name(const ViewOptions& options) {
  return options.input.paths.empty() ? "A clear day" : environment_name(options.input.paths);
}

void write_page(const ViewData& data, const ViewState& state, const ViewOptions& options, Call& call) {
  ViewPageOptions page = {.title = light_name(options),
                          .subtitle = "lit by all techniques, beside the exact answer",
                          .state = state,
                          .meshes = {}};
  if (std::ranges::find(mesh_shape_names(), state.mesh) == mesh_shape_names().end()) {
    page.state.mesh = "file";  // a path may have characters that an address cannot
    page.meshes.emplace_back(page.state.mesh, load_mesh(state.mesh, options.mesh_loading, call.run).mesh);
  }
#ifdef ZONAL_HAS_WEB
  page.module = web_module();
  page.notices = web_notices();
#endif
  const std::string html = view_page_html(data, page);
  write_file(options.html, html);
  call.console.wrote(options.html, html.size(), "a page to look at");
}

void open_window(const ViewOptions& options, const ViewState& state, Call& call) {
  const auto light = [&options, quiet = call.console.quiet](const Run& run) -> ViewLight {
    if (options.input.paths.empty()) return {clear_day(run), {}};
    Call background;  // notes and warnings go to the terminal as they do elsewhere
    background.console.quiet = quiet;
    background.run = run;
    // The picture as it is: the window lets people say more about a fisheye photograph.
    return {read_input(options.input, background).loaded.environment, resample_options_of(options.input)};
  };
  open_view_window(state, light_name(options), light, options.mesh_loading, highlight_of(options, call), call);
}

void run_view(const ViewOptions& options, Call& call) {
  if (options.list) return list_techniques(call);
  ViewState state = state_of(options);
  const bool page = !options.html.empty(), picture = !options.screenshot.empty() || !options.sheet.empty();
  if (!page && !picture) return open_window(options, state, call);
  std::optional<Image<Rgb>> highlight = highlight_of(options, call);
  ViewData data = view_data(panorama_of(options, call), page ? view_page_data_options() : ViewDataOptions(), call.run);
  if (highlight) set_own_highlight(data, std::move(*highlight));
  if (page) write_page(data, state, options, call);
  if (!picture) return;
  if (!state.controls.contains("exposure_ev")) state.set("exposure_ev", opening_exposure_ev(data));
  if (!options.screenshot.empty()) {
    write_screenshot(data, state, options.screenshot, options.size, options.mesh_loading, call);
  }
  if (!options.sheet.empty()) {
    write_view_sheet(data, state, options.sheet, options.mesh_loading, light_name(options), call);
  }
}

}  // namespace

void add_view(CLI::App& app, Call& call) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App& verb =
      *app.add_subcommand("view", "Techniques of lighting by the environment, side by side with the exact answer.");
  add_input_options(verb, options->input);
  verb.get_option("IN")->required(false);  // there is a sky to look at without one
  constexpr const char* kGroup = "View";
  verb.add_option("--technique", options->technique, "what to show: see --list")->group(kGroup);
  verb.add_option("--mesh", options->mesh, "sphere, torus-knot, bumpy, or a file: OBJ, PLY, glTF")->group(kGroup);
  add_choice(verb, "--mesh-up", options->mesh_loading.up, mesh_up_named, "format, y or z",
             "the axis of a mesh file that points up; format: Y in OBJ and glTF, Z in PLY")
      ->group(kGroup);
  verb.add_option(
          "--highlight", options->highlight,
          "any picture as the sphere map of the technique highlight-map: its middle square is the object as the "
          "eye sees it")
      ->group(kGroup);
  verb.add_option("--set", options->settings, "settings, as a page keeps them in its address: \"roughness=0.4&yaw=30\"")
      ->group(kGroup);
  verb.add_option("--screenshot", options->screenshot, "draws one picture, without a display")->group(kGroup);
  verb.add_option(
          "--sheet", options->sheet,
          "draws every technique beside its exact answer, with their differences, in one SVG; without a display")
      ->group(kGroup);
  verb.add_option("--html", options->html,
                  "writes a page that draws all of it in a browser, and takes other panoramas if this build can; "
                  "a --screenshot is then of the page's own, smaller maps")
      ->group(kGroup);
  verb.add_option("--size", options->size, "of the picture, in pixels")->capture_default_str()->group(kGroup);
  verb.add_flag("--list", options->list, "the techniques and the settings that there are")->group(kGroup);
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal view sunset.hdr                     opens a window: drop images and meshes into it\n"
      "  zonal view sunset.hdr --technique split-sum --screenshot ball.png\n"
      "  zonal view sunset.hdr --mesh torus-knot --set \"technique=sh-bands&bands=3&compare=3\" --screenshot knot.png\n"
      "  zonal view sunset.hdr --sheet techniques.svg\n"
      "  zonal view sunset.hdr --highlight window.png --screenshot glint.png\n"
      "  zonal view sunset.hdr --html sunset.html\n"
      "  zonal view --list");
  verb.callback([options, &call] { run_view(*options, call); });
}

}  // namespace zonal
