#pragma once

#include <optional>
#include <string>
#include <vector>

#include "zonal/report/ticks.h"

namespace zonal {

struct ChartAxis {
  std::string label = {};               ///< with its unit
  bool log = false;                     ///< base ten
  bool whole = false;                   ///< only whole numbers are marked
  std::optional<AxisRange> range = {};  ///< empty: what the data need; values outside stand at its edge
  std::vector<double> marks = {};       ///< empty: round numbers; else these, e.g. right angles
};

/// Where the axes of a chart lie, in user units.
struct ChartArea {
  double width = 0, height = 0;
  double left = 0, right = 0, top = 0, bottom = 0;
};

/// One axis on the paper: from values to user units.
class AxisScale {
 public:
  AxisScale(const ChartAxis& axis, AxisRange range, double from, double to);

  double operator()(double value) const;
  /// Whether a value has a place at all: finite and, on a logarithmic axis, positive.
  bool shows(double value) const;
  const Ticks& ticks() const { return ticks_; }

 private:
  double place(double value) const;

  bool log_;
  double from_, to_, lo_ = 0, hi_ = 1;
  Ticks ticks_;
};

/// The range that an axis needs for the values that it can show, or the one it was given.
AxisRange range_for(const ChartAxis&, const std::vector<double>& values);

/// Grid lines, marks and their words, and the x axis' label below. The y axis' label is the chart's to place.
std::string draw_axes(const ChartAxis& x_axis, const AxisScale& x, const AxisScale& y, const ChartArea&);

}  // namespace zonal
