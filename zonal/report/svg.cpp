#include "zonal/report/svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "zonal/base/check.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

/// Characters, not bytes.
double letters_in(std::string_view words) {
  return static_cast<double>(std::count_if(words.begin(), words.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string_view color_of(Ink ink) {
  // Contrast of 3.4 : 1 at least against both papers of the page's style.
  switch (ink) {
    case Ink::kRed:
      return "#dc4232";
    case Ink::kGreen:
      return "#1f9450";
    case Ink::kBlue:
      return "#3b7fe0";
    case Ink::kText:
      break;
  }
  return "currentColor";
}

std::string svg_text(double x, double y, std::string_view anchor, std::string_view words) {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor, escape(words));
}

std::string svg_line(double x0, double y0, double x1, double y1, double opacity) {
  return fmt::format(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="currentColor" stroke-opacity="{}"/>)", x0, y0,
                     x1, y1, opacity);
}

std::string svg_legend(double x, double y, const std::vector<LegendEntry>& entries) {
  constexpr double kSample = 22, kGap = 6, kBetween = 16, kLetter = 6.8;
  std::string out;
  for (const auto& [name, ink, dashed] : entries) {
    out += fmt::format(R"(<path d="M{:.1f} {:.1f}h{}" stroke="{}" stroke-width="2" stroke-dasharray="{}"/>)", x, y - 4,
                       kSample, color_of(ink), dashed ? "5 3" : "none");
    out += svg_text(x + kSample + kGap, y, "start", name);
    x += kSample + kGap + kLetter * letters_in(name) + kBetween;
  }
  return out;
}

std::string svg_frame(double width, double height, std::string_view css_class, std::string_view description,
                      std::string_view inside) {
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" class="{}" viewBox="0 0 {} {}" role="img" aria-label="{}" )"
      R"(fill="none" font-size="13" font-family="system-ui, sans-serif"><g class="ink" fill="currentColor" )"
      R"(stroke="none">{}</g></svg>)",
      css_class, width, height, escape(description), inside);
}

std::string standalone_svg(std::string_view svg) {
  const std::size_t end = svg.find('>');
  check(svg.starts_with("<svg ") && end != std::string_view::npos, "standalone_svg needs a drawing");
  return fmt::format(
      "{}\n<style>svg {{ color: #1d1c1a; background: #fbfaf8; }}\n"
      "@media (prefers-color-scheme: dark) {{ svg {{ color: #e9e6e0; background: #141414; }} }}</style>\n{}\n",
      svg.substr(0, end + 1), svg.substr(end + 1));
}

}  // namespace zonal
