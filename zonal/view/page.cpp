#include "zonal/view/page.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/view/page_parts.h"
#include "zonal/view/page_tables.h"

namespace zonal {
namespace {

std::string_view part(std::string_view stem) {
  for (const PagePart& each : page_parts()) {
    if (each.stem == stem) return each.text;
  }
  check(false, "there is no part of the page of this name");
  return {};
}

/// `text` with the one place that `mark` marks filled.
std::string filled(std::string text, std::string_view mark, std::string_view with) {
  const std::size_t at = text.find(mark);
  check(at != text.npos, "the page has a place for each of its parts");
  return text.replace(at, mark.size(), with);
}

/// One function scope: nothing of it is seen by other scripts of the page.
std::string script() {
  std::string text = "'use strict';\n(() => {\n";
  for (const char* stem : {"bytes", "settings", "camera", "light_turn", "gpu", "scene", "pace", "measure", "controls",
                           "orbit", "paint", "highlight", "panel", "viewer"}) {
    text += part(stem);
  }
  return text + "})();\n";
}

/// JSON that no text in it can end the script element of.
std::string json_for_script(const JsonValue& value) {
  std::string text;
  for (const char c : json_text(value)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

ViewDataOptions view_page_data_options() { return {.panorama_px = 256, .cube_px = 96, .chain_px = 64}; }

ViewSection view_section(const ViewData& light, ViewPageOptions options) {
  if (!options.state.controls.contains("exposure_ev")) {
    const Control& exposure = control_named("exposure_ev");
    options.state.set("exposure_ev",
                      std::clamp(std::round(light.exposure_ev * 4) / 4, exposure.least, exposure.greatest));
  }
  std::string html = filled(std::string(part("section")), "@script@", script());
  return {std::string(part("viewer_style")),
          filled(std::move(html), "@data@", json_for_script(view_page_tables(light, options)))};
}

std::string view_page_html(const ViewData& light, const ViewPageOptions& options) {
  const ViewSection section = view_section(light, options);
  std::string html = filled(std::string(part("skeleton")), "@page_style@", part("page_style"));
  html = filled(std::move(html), "@viewer_style@", section.style);
  return filled(std::move(html), "@viewer@", section.html);
}

}  // namespace zonal
