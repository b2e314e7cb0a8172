#include "zonal/view/page.h"

#include <string_view>

#include "zonal/base/check.h"
#include "zonal/view/opening_exposure.h"
#include "zonal/view/page_parts.h"
#include "zonal/view/page_tables.h"

namespace zonal {
namespace {

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
                           "light", "orbit", "paint", "highlight", "panel", "viewer"}) {
    text += page_part(stem);
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

ViewSection view_section(const ViewData& light, ViewPageOptions options) {
  if (!options.state.controls.contains("exposure_ev")) {
    options.state.set("exposure_ev", opening_exposure_ev(light));
  }
  std::string html = filled(std::string(page_part("section")), "@script@", script());
  return {std::string(page_part("viewer_style")),
          filled(std::move(html), "@data@", json_for_script(view_page_tables(light, options)))};
}

std::string view_page_html(const ViewData& light, const ViewPageOptions& options) {
  const ViewSection section = view_section(light, options);
  std::string html = filled(std::string(page_part("skeleton")), "@page_style@", page_part("page_style"));
  html = filled(std::move(html), "@viewer_style@", section.style);
  // The module runs in a worker whose script is a part of the page.
  html =
      filled(std::move(html), "@more_sources@", options.module.empty() ? "" : " 'wasm-unsafe-eval'; worker-src blob:");
  return filled(std::move(html), "@viewer@", section.html);
}

}  // namespace zonal
