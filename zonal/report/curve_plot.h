#pragma once

#include <functional>
#include <string>
#include <vector>

#include "zonal/report/chart_axes.h"
#include "zonal/report/figure.h"
#include "zonal/report/svg.h"

namespace zonal {

/// A smooth function, or with `dots` one that has values at its points alone: dots in place of a line.
struct Curve {
  std::string name;  ///< empty: not in the legend
  std::vector<ChartPoint> points;
  Ink ink = Ink::kText;
  bool dashed = false;
  bool dots = false;
};

/// A dot on the plot and a word beside it.
struct PlotNote {
  double x = 0, y = 0;
  std::string label;
  enum class Side { kAboveRight, kAboveLeft, kBelowRight, kBelowLeft } side = Side::kAboveRight;
};

/// Curves in colours, made to stand beside other plots.
struct CurvePlot {
  std::string title;
  std::string description;  ///< what the picture shows, for those who cannot see it
  ChartAxis x, y;           ///< the y axis' label is not drawn: the title says what is plotted
  std::vector<Curve> curves;
  std::vector<PlotNote> notes = {};
  double width = 440, height = 300;  ///< user units
};

/// An SVG of class "plot"; later curves lie on top. The zero line is drawn stronger than the others.
std::string curve_plot(const CurvePlot&);

/// f at `count` equal steps from lo to hi, both included; count >= 2.
std::vector<ChartPoint> sampled(const std::function<double(double)>& f, double lo, double hi, int count);

}  // namespace zonal
