#pragma once

#include <functional>
#include <string>
#include <vector>

#include "zonal/report/svg.h"

namespace zonal {

/// A function of the angle from an axis, symmetric around it. Its size is the distance from the centre, its sign the
/// colour of the lobe; negative lobes are dashed as well, so that the sign shows without colour.
struct PolarCurve {
  std::string name;                           ///< empty: not in the legend
  std::function<double(double theta)> value;  ///< theta in [0, pi]; must be finite
  Ink positive = Ink::kRed, negative = Ink::kBlue;
  bool filled = true;  ///< lobes are tinted
};

/// A dot on a curve and a word beside it.
struct PolarNote {
  double theta = 0;  ///< [0, pi]
  double value = 0;
  std::string label;
};

struct PolarPlot {
  std::string title;
  std::string description;  ///< what the picture shows, for those who cannot see it
  std::vector<PolarCurve> curves;
  std::vector<PolarNote> notes = {};
  double radius = 0;  ///< the value at the outer ring, on which larger ones stand; 0: what the curves need
  double size = 320;  ///< width in user units
};

/// One lobe of a curve: where the function has one sign.
struct PolarLobe {
  bool negative = false;
  struct Point {
    double theta = 0;  ///< [-pi, pi], the mirrored half below zero
    double radius = 0;
  };
  std::vector<Point> points;  ///< begins and ends in the centre, but for a lobe across theta = pi
};

/// The lobes of a curve from theta = -pi to pi. Zeros between two samples (720 of them) are found to rounding.
std::vector<PolarLobe> polar_lobes(const std::function<double(double theta)>& value);

/// An SVG of class "plot": the axis points up, rings carry the values, spokes stand every 30 degrees. Later curves lie
/// on top.
std::string polar_plot(const PolarPlot&);

}  // namespace zonal
