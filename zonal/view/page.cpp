#include "zonal/view/page.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/io/utf8.h"
#include "zonal/view/opening_exposure.h"
#include "zonal/view/packed_text.h"
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

/// A script or JSON with its characters beyond ASCII as \uXXXX: a document of ASCII alone is read in half the time.
std::string ascii_script(std::string_view script) {
  std::string ascii;
  for (std::size_t length = 0; !script.empty(); script.remove_prefix(length)) {
    length = utf8_character_length(script);
    check(length > 0, "scripts are UTF-8");
    if (length == 1) {
      ascii += script[0];
      continue;
    }
    std::uint32_t code = static_cast<unsigned char>(script[0]) & (0x7fu >> length);
    for (const char c : script.substr(1, length - 1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3f);
    if (code > 0xffff) {
      code -= 0x10000;
      ascii += fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + (code >> 10), 0xdc00 + (code & 0x3ff));
    } else {
      ascii += fmt::format("\\u{:04x}", code);
    }
  }
  return ascii;
}

/// One function scope: nothing of it is seen by other scripts of the page.
std::string script() {
  std::string text = "'use strict';\n(() => {\n";
  for (const char* stem : {"bytes", "settings", "camera", "light_turn", "gpu", "smooth", "scene", "pace", "measure",
                           "controls", "light", "orbit", "paint", "highlight", "panel", "viewer"}) {
    text += page_part(stem);
  }
  return ascii_script(text + "})();\n");
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
  return ascii_script(text);
}

}  // namespace

ViewSection view_section(const ViewData& light, ViewPageOptions options) {
  if (!options.state.controls.contains("exposure_ev")) {
    options.state.set("exposure_ev", opening_exposure_ev(light));
  }
  const ViewPageTables page = view_page_tables(light, options);
  const bool takes_others = !options.module.empty() && !options.embedded;
  std::string html = filled(std::string(page_part("section")), "@script@", script());
  html = filled(std::move(html), "@opening@", page.opening);
  html = filled(std::move(html), "@rest@", page.rest);
  check(options.notices.find("--") == std::string_view::npos, "notices are a comment, which two hyphens would end");
  const bool has_notices = takes_others && !options.notices.empty();
  html = filled(std::move(html), "@notices@", has_notices ? fmt::format("<!--\n{}-->\n", options.notices) : "");
  html = filled(std::move(html), "@module@", takes_others ? packed_text(options.module) : "");
  // Last: words from outside may look like a mark.
  html = filled(std::move(html), "@tables@", json_for_script(page.tables));
  return {std::string(page_part("viewer_style")), std::move(html)};
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
