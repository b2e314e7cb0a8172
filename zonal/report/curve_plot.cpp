#include "zonal/report/curve_plot.h"

#include <fmt/format.h>

#include <iterator>

#include "zonal/base/check.h"

namespace zonal {
namespace {

std::string dots_of(const Curve& curve, const AxisScale& x, const AxisScale& y) {
  std::string dots;
  for (const auto& [px, py] : curve.points) {
    if (!x.shows(px) || !y.shows(py)) continue;
    fmt::format_to(std::back_inserter(dots), R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.4" fill="{}"/>)", x(px), y(py),
                   color_of(curve.ink));
  }
  return dots;
}

std::string drawn(const Curve& curve, const AxisScale& x, const AxisScale& y) {
  if (curve.dots) return dots_of(curve, x, y);
  std::string path;
  bool down = false;
  for (const auto& [px, py] : curve.points) {
    const bool shown = x.shows(px) && y.shows(py);
    if (shown) fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", down ? "L" : "M", x(px), y(py));
    down = shown;
  }
  if (path.empty()) return {};
  return fmt::format(R"(<path d="{}" fill="none" stroke="{}" stroke-width="{}" stroke-dasharray="{}"/>)", path,
                     color_of(curve.ink), curve.dashed ? 1.2 : 1.8, curve.dashed ? "5 3" : "none");
}

std::string drawn(const PlotNote& note, const AxisScale& x, const AxisScale& y) {
  using enum PlotNote::Side;
  const double at_x = x(note.x), at_y = y(note.y);
  const bool left = note.side == kAboveLeft || note.side == kBelowLeft;
  const bool below = note.side == kBelowRight || note.side == kBelowLeft;
  return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.4"/>)", at_x, at_y) +
         svg_text(at_x + (left ? -4 : 8), at_y + (below ? 19 : -8), left ? "end" : "start", note.label);
}

}  // namespace

std::string curve_plot(const CurvePlot& plot) {
  std::vector<double> xs, ys;
  std::vector<LegendEntry> legend;
  for (const Curve& curve : plot.curves) {
    for (const ChartPoint& point : curve.points) {
      xs.push_back(point.x);
      ys.push_back(point.y);
    }
    if (!curve.name.empty()) legend.push_back({curve.name, curve.ink, curve.dashed});
  }
  const ChartArea area = {.width = plot.width,
                          .height = plot.height,
                          .left = 46,
                          .right = plot.width - 14,
                          .top = 54,
                          .bottom = plot.height - 46};
  const AxisScale x(plot.x, range_for(plot.x, xs), area.left, area.right);
  const AxisScale y(plot.y, range_for(plot.y, ys), area.bottom, area.top);
  std::string inside = draw_axes(plot.x, x, y, area);
  const double zero = y(0);
  if (zero > area.top && zero < area.bottom) inside += svg_line(area.left, zero, area.right, zero, 0.5);
  for (const Curve& curve : plot.curves) inside += drawn(curve, x, y);
  for (const PlotNote& note : plot.notes) inside += drawn(note, x, y);
  inside += svg_text(8, 16, "start", plot.title) + svg_legend(8, 36, legend);
  return svg_frame(plot.width, plot.height, "plot", plot.description, inside);
}

std::vector<ChartPoint> sampled(const std::function<double(double)>& f, double lo, double hi, int count) {
  check(count >= 2, "a sampled curve needs both its ends");
  std::vector<ChartPoint> points;
  for (int i = 0; i < count; ++i) {
    const double x = lo + (hi - lo) * i / (count - 1);
    points.push_back({x, f(x)});
  }
  return points;
}

}  // namespace zonal
