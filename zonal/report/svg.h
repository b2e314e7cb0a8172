#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zonal {

// The parts that every drawing of ours is made of, in user units. Text is escaped here.

/// Colours that can be told apart on light and on dark paper. kText is the paper's own ink: currentColor.
enum class Ink { kText, kRed, kGreen, kBlue };
std::string_view color_of(Ink);

/// Text in the drawing's own letters. `anchor` is start, middle or end.
std::string svg_text(double x, double y, std::string_view anchor, std::string_view words);
/// A straight line in the paper's ink.
std::string svg_line(double x0, double y0, double x1, double y1, double opacity);

/// One entry of a legend: a sample of line and what it stands for.
struct LegendEntry {
  std::string name;
  Ink ink = Ink::kText;
  bool dashed = false;
};
/// Entries in a row from (x, y) to the right; y is the letters' base line.
std::string svg_legend(double x, double y, const std::vector<LegendEntry>&);

/// The whole drawing. `description` is for those who cannot see it; `css_class` is what a page's style calls it:
/// "chart" for drawings that are letters and lines over the page's full width, "plot" for those that stand beside each
/// other.
std::string svg_frame(double width, double height, std::string_view css_class, std::string_view description,
                      std::string_view inside);

/// A drawing of svg_frame() as a file: its ink and its paper follow the reader's choice of light or dark.
std::string standalone_svg(std::string_view svg);

}  // namespace zonal
