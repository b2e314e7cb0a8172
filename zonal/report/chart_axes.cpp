#include "zonal/report/chart_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "zonal/report/svg.h"

namespace zonal {
namespace {

constexpr int kMostTicks = 7;

Ticks ticks_for(const ChartAxis& axis, AxisRange range) {
  if (axis.marks.empty()) return axis.log ? log_ticks(range, kMostTicks) : linear_ticks(range, kMostTicks, axis.whole);
  Ticks ticks;
  for (const double mark : axis.marks) {
    ticks.at.push_back(mark);
    ticks.labels.push_back(fmt::format("{}{:g}", mark < 0 ? "−" : "", std::abs(mark)));
  }
  return ticks;
}

}  // namespace

AxisScale::AxisScale(const ChartAxis& axis, AxisRange range, double from, double to)
    : log_(axis.log), from_(from), to_(to), ticks_(ticks_for(axis, range)) {
  lo_ = place(range.lo);
  hi_ = place(range.hi);
}

double AxisScale::operator()(double value) const {
  // Halves: the difference of two huge values may overflow.
  const double t = (place(value) / 2 - lo_ / 2) / (hi_ / 2 - lo_ / 2);
  return from_ + std::clamp(t, 0.0, 1.0) * (to_ - from_);
}

bool AxisScale::shows(double value) const { return std::isfinite(value) && (!log_ || value > 0); }

double AxisScale::place(double value) const { return log_ ? std::log10(value) : value; }

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

std::string draw_axes(const ChartAxis& x_axis, const AxisScale& x, const AxisScale& y, const ChartArea& area) {
  std::string out;
  for (std::size_t i = 0; i < y.ticks().at.size(); ++i) {
    const double at = y(y.ticks().at[i]);
    out += svg_line(area.left, at, area.right, at, 0.15);
    out += svg_text(area.left - 8, at + 4, "end", y.ticks().labels[i]);
  }
  for (std::size_t i = 0; i < x.ticks().at.size(); ++i) {
    const double at = x(x.ticks().at[i]);
    out += svg_line(at, area.bottom, at, area.bottom + 5, 0.6);
    out += svg_text(at, area.bottom + 22, "middle", x.ticks().labels[i]);
  }
  out += svg_line(area.left, area.bottom, area.right, area.bottom, 0.6);
  out += svg_text((area.left + area.right) / 2, area.height - 8, "middle", x_axis.label);
  return out;
}

}  // namespace zonal
