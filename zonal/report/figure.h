#pragma once

#include <string>
#include <vector>

#include "zonal/report/chart_axes.h"

namespace zonal {

// Small SVG figures. Everything is drawn in currentColor, the first series in the class "accent", so that a page's
// light and dark style reach them; they also stand alone. No script. Text is escaped here.

struct ChartPoint {
  double x = 0, y = 0;
};

struct ChartSeries {
  std::string name;
  std::vector<ChartPoint> points;
};

struct LineChart {
  std::string description;  ///< what the picture shows, for those who cannot see it
  ChartAxis x, y;
  std::vector<ChartSeries> series;
};

/// A value on the x axis worth a thin vertical line and a word.
struct ChartMark {
  double x = 0;
  std::string label;
};

/// Bars of equal width, bar i covers [first + i width, first + (i + 1) width].
struct BarChart {
  std::string description;
  ChartAxis x, y;
  double first = 0, width = 1;
  std::vector<double> heights;
  std::vector<ChartMark> marks = {};
};

/// Lines with a dot at each point. A point that is not finite, or not positive on a logarithmic axis, is left out and
/// the line broken there. A chart without points shows empty axes.
std::string line_chart(const LineChart&);

/// Bars from zero. Heights must be finite and not negative, else std::logic_error.
std::string bar_chart(const BarChart&);

}  // namespace zonal
