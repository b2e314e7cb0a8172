#include "zonal/report/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "zonal/base/check.h"
#include "zonal/report/text.h"

namespace zonal {
namespace {

// User units. Margins hold the text at twice its size, which a narrow screen's style asks for.
constexpr double kWidth = 640, kHeight = 290;
constexpr double kLeft = 84, kRight = 624, kTop = 46, kBottom = 234;
constexpr int kMostTicks = 7;

/// One axis on the paper: from values to user units.
class Scale {
 public:
  Scale(const ChartAxis& axis, AxisRange range, double from, double to) : log_(axis.log), from_(from), to_(to) {
    lo_ = place(range.lo);
    hi_ = place(range.hi);
    ticks_ = axis.log ? log_ticks(range, kMostTicks) : linear_ticks(range, kMostTicks, axis.whole);
  }
  double operator()(double value) const {
    // Halves: the difference of two huge values may overflow.
    const double t = (place(value) / 2 - lo_ / 2) / (hi_ / 2 - lo_ / 2);
    return from_ + std::clamp(t, 0.0, 1.0) * (to_ - from_);
  }
  bool shows(double value) const { return std::isfinite(value) && (!log_ || value > 0); }
  const Ticks& ticks() const { return ticks_; }

 private:
  double place(double value) const { return log_ ? std::log10(value) : value; }
  bool log_;
  double from_, to_, lo_ = 0, hi_ = 1;
  Ticks ticks_;
};

/// The range of the values that an axis can show.
AxisRange range_for(const ChartAxis& axis, const std::vector<double>& values) {
  if (axis.range) return axis_range(axis.range->lo, axis.range->hi, axis.log);
  bool any = false;
  double lo = 0, hi = 0;
  for (const double value : values) {
    if (!std::isfinite(value) || (axis.log && value <= 0)) continue;
    lo = any ? std::min(lo, value) : value;
    hi = any ? std::max(hi, value) : value;
    any = true;
  }
  if (!any) return axis.log ? AxisRange{1, 10} : AxisRange{0, 1};
  if (axis.log) {
    // To the whole decades outside, so that the frame itself is marked.
    lo = std::max(1e-300, std::pow(10, std::floor(std::log10(lo) + 1e-9)));
    hi = std::min(1e300, std::pow(10, std::ceil(std::log10(hi) - 1e-9)));
    hi = std::max(hi, lo);
  }
  return axis_range(lo, hi, axis.log);
}

/// Text in the figure's own letters. `anchor` is start, middle or end.
std::string text_at(double x, double y, std::string_view anchor, std::string_view words) {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor, escape(words));
}

std::string line_from(double x0, double y0, double x1, double y1, double opacity) {
  return fmt::format(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="currentColor" stroke-opacity="{}"/>)", x0, y0,
                     x1, y1, opacity);
}

std::string axes(const ChartAxis& x_axis, const ChartAxis& y_axis, const Scale& x, const Scale& y) {
  std::string out;
  for (std::size_t i = 0; i < y.ticks().at.size(); ++i) {
    const double at = y(y.ticks().at[i]);
    out += line_from(kLeft, at, kRight, at, 0.15);
    out += text_at(kLeft - 8, at + 4, "end", y.ticks().labels[i]);
  }
  for (std::size_t i = 0; i < x.ticks().at.size(); ++i) {
    const double at = x(x.ticks().at[i]);
    out += line_from(at, kBottom, at, kBottom + 5, 0.6);
    out += text_at(at, kBottom + 22, "middle", x.ticks().labels[i]);
  }
  out += line_from(kLeft, kBottom, kRight, kBottom, 0.6);
  out += text_at((kLeft + kRight) / 2, kHeight - 8, "middle", x_axis.label);
  // Above the axis and not along it: nobody has to turn the head.
  out += text_at(8, 18, "start", y_axis.label);
  return out;
}

std::string frame(std::string_view description, std::string_view inside) {
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" class="chart" viewBox="0 0 {} {}" role="img" aria-label="{}" )"
      R"(fill="none" font-size="13" font-family="system-ui, sans-serif"><g class="ink" fill="currentColor" )"
      R"(stroke="none">{}</g></svg>)",
      kWidth, kHeight, escape(description), inside);
}

/// How series are told apart without colour: by their dashes.
struct Pen {
  std::string_view css_class, dashes;
};
constexpr std::array<Pen, 4> kPens = {Pen{"accent", ""}, Pen{"", "7 4"}, Pen{"", "2 3"}, Pen{"", "9 3 2 3"}};

std::string drawn_series(const ChartSeries& series, const Pen& pen, const Scale& x, const Scale& y) {
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
  double left = kRight;
  for (std::size_t i = all.size(); i-- > 0;) {
    const Pen& pen = kPens[i % kPens.size()];
    left -= 60 + 12 * static_cast<double>(all[i].name.size());  // room for letters of twice the size
    out += fmt::format(
        R"(<path class="{}" d="M{:.1f} 14H{:.1f}" stroke="currentColor" stroke-width="2" stroke-dasharray="{}"/>)",
        pen.css_class, left, left + 30, pen.dashes.empty() ? "none" : pen.dashes);
    out += text_at(left + 38, 18, "start", all[i].name);
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
  const Scale x(chart.x, range_for(chart.x, xs), kLeft, kRight), y(chart.y, range_for(chart.y, ys), kBottom, kTop);
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
  const Scale x(chart.x, range_for(chart.x, {chart.first, last}), kLeft, kRight);
  const Scale y(chart.y, range_for(chart.y, heights), kBottom, kTop);
  std::string inside = axes(chart.x, chart.y, x, y);

  std::string path;
  for (std::size_t i = 0; i < chart.heights.size(); ++i) {
    if (chart.heights[i] == 0) continue;
    const double left = x(chart.first + chart.width * static_cast<double>(i));
    const double right = x(chart.first + chart.width * static_cast<double>(i + 1));
    // A bar too low to be seen would read as "none": it gets half a unit.
    const double top = std::min(y(chart.heights[i]), kBottom - 0.5);
    const double gap = std::min(1.0, (right - left) / 5);
    fmt::format_to(std::back_inserter(path), "M{:.1f} {:.1f}V{:.1f}H{:.1f}V{:.1f}z", left + gap / 2, kBottom, top,
                   right - gap / 2, kBottom);
  }
  if (!path.empty()) inside += fmt::format(R"(<path class="accent" d="{}"/>)", path);
  for (const ChartMark& mark : chart.marks) {
    if (!x.shows(mark.x)) continue;
    const double at = x(mark.x);
    inside += line_from(at, kTop - 5, at, kBottom, 0.6);
    // Words stay inside the frame's width, above it.
    const bool late = at > (kLeft + kRight) / 2;
    inside += text_at(late ? at + 4 : at - 4, kTop - 9, late ? "end" : "start", mark.label);
  }
  return frame(chart.description, inside);
}

}  // namespace zonal
