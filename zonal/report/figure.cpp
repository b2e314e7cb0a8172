#include "zonal/report/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/report/svg.h"

namespace zonal {
namespace {

// User units. Margins hold the text at twice its size, which a narrow screen's style asks for.
constexpr ChartArea kArea = {.width = 640, .height = 290, .left = 84, .right = 624, .top = 46, .bottom = 234};

std::string axes(const ChartAxis& x_axis, const ChartAxis& y_axis, const AxisScale& x, const AxisScale& y) {
  // The y axis' label stands above it and not along it: nobody has to turn the head.
  return draw_axes(x_axis, x, y, kArea) + svg_text(8, 18, "start", y_axis.label);
}

std::string frame(std::string_view description, std::string_view inside) {
  return svg_frame(kArea.width, kArea.height, "chart", description, inside);
}

/// How series are told apart without colour: by their dashes.
struct Pen {
  std::string_view css_class, dashes;
};
constexpr std::array<Pen, 4> kPens = {Pen{"accent", ""}, Pen{"", "7 4"}, Pen{"", "2 3"}, Pen{"", "9 3 2 3"}};

std::string drawn_series(const ChartSeries& series, const Pen& pen, const AxisScale& x, const AxisScale& y) {
  std::string path, dots;
  bool down = false;
  for (const auto& [px, py] : series.points) {
    if (!x.shows(px) || !y.shows(py)) {
      down = false;
      continue;
    }
    fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", down ? "L" : "M", x(px), y(py));
    fmt::format_to(std::back_inserter(dots), R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.2"/>)", x(px), y(py));
    down = true;
  }
  return fmt::format(
      R"(<g class="{}"><path d="{}" fill="none" stroke="currentColor" stroke-width="2" stroke-dasharray="{}"/>{}</g>)",
      pen.css_class, path.empty() ? "M0 0" : path, pen.dashes.empty() ? "none" : pen.dashes, dots);
}

/// A sample of line and a name for each series, above the frame at its right end.
std::string legend(const std::vector<ChartSeries>& all) {
  std::string out;
  double left = kArea.right;
  for (std::size_t i = all.size(); i-- > 0;) {
    const Pen& pen = kPens[i % kPens.size()];
    left -= 60 + 12 * static_cast<double>(all[i].name.size());  // room for letters of twice the size
    out += fmt::format(
        R"(<path class="{}" d="M{:.1f} 14H{:.1f}" stroke="currentColor" stroke-width="2" stroke-dasharray="{}"/>)",
        pen.css_class, left, left + 30, pen.dashes.empty() ? "none" : pen.dashes);
    out += svg_text(left + 38, 18, "start", all[i].name);
  }
  return out;
}

}  // namespace

std::string line_chart(const LineChart& chart) {
  std::vector<double> xs, ys;
  for (const ChartSeries& series : chart.series) {
    for (const ChartPoint& point : series.points) {
      xs.push_back(point.x);
      ys.push_back(point.y);
    }
  }
  const AxisScale x(chart.x, range_for(chart.x, xs), kArea.left, kArea.right),
      y(chart.y, range_for(chart.y, ys), kArea.bottom, kArea.top);
  std::string inside = axes(chart.x, chart.y, x, y);
  // The first series last, on top.
  for (std::size_t i = chart.series.size(); i-- > 0;) {
    inside += drawn_series(chart.series[i], kPens[i % kPens.size()], x, y);
  }
  return frame(chart.description, inside + legend(chart.series));
}

std::string bar_chart(const BarChart& chart) {
  check(std::isfinite(chart.first) && std::isfinite(chart.width) && chart.width > 0,
        "bars need a finite place and width");
  for (const double height : chart.heights) {
    check(std::isfinite(height) && height >= 0, "a bar's height must be finite and not negative");
  }
  std::vector<double> heights = chart.heights;
  if (!chart.y.log) heights.push_back(0);  // bars stand on zero, or on the decade at or below the lowest
  const double last = chart.first + chart.width * static_cast<double>(std::max<std::size_t>(1, chart.heights.size()));
  const AxisScale x(chart.x, range_for(chart.x, {chart.first, last}), kArea.left, kArea.right);
  const AxisScale y(chart.y, range_for(chart.y, heights), kArea.bottom, kArea.top);
  std::string inside = axes(chart.x, chart.y, x, y);

  std::string path;
  for (std::size_t i = 0; i < chart.heights.size(); ++i) {
    if (chart.heights[i] == 0) continue;
    const double left = x(chart.first + chart.width * static_cast<double>(i));
    const double right = x(chart.first + chart.width * static_cast<double>(i + 1));
    // A bar too low to be seen would read as "none": it gets half a unit.
    const double top = std::min(y(chart.heights[i]), kArea.bottom - 0.5);
    const double gap = std::min(1.0, (right - left) / 5);
    fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}V{:.1f}H{:.1f}V{:.1f}z", left + gap / 2, kArea.bottom, top,
                   right - gap / 2, kArea.bottom);
  }
  if (!path.empty()) inside += fmt::format(R"(<path class="accent" d="{}"/>)", path);
  for (const ChartMark& mark : chart.marks) {
    if (!x.shows(mark.x)) continue;
    const double at = x(mark.x);
    inside += svg_line(at, kArea.top - 5, at, kArea.bottom, 0.6);
    // Words stay inside the frame's width, above it.
    const bool late = at > (kArea.left + kArea.right) / 2;
    inside += svg_text(late ? at + 4 : at - 4, kArea.top - 9, late ? "end" : "start", mark.label);
  }
  return frame(chart.description, inside);
}

}  // namespace zonal
