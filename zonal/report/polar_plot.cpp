#include "zonal/report/polar_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "zonal/base/check.h"
#include "zonal/math/vec.h"
#include "zonal/report/ticks.h"

namespace zonal {
namespace {

constexpr int kHalfSamples = 360;  // of half a turn
constexpr int kMostRings = 6;

/// The zero of f between two angles where its signs differ, by halving.
double zero_between(const std::function<double(double)>& f, double from, double to) {
  const bool from_negative = f(std::abs(from)) < 0;
  for (double middle = (from + to) / 2; middle != from && middle != to; middle = (from + to) / 2) {
    (f(std::abs(middle)) < 0) == from_negative ? from = middle : to = middle;
  }
  return from;
}

/// The plane of the paper: the axis up, angles to the right of it positive. Nothing lies beyond the outer ring.
struct Plane {
  double center_x = 0, center_y = 0;
  double unit = 1;   ///< user units of a value of 1
  double outer = 1;  ///< the value at the outer ring

  double x(double theta, double radius) const { return center_x + unit * std::min(radius, outer) * std::sin(theta); }
  double y(double theta, double radius) const { return center_y - unit * std::min(radius, outer) * std::cos(theta); }
};

std::string rings(const Plane& plane) {
  std::string out;
  const Ticks ticks = linear_ticks({0, plane.outer}, kMostRings);
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    if (ticks.at[i] <= 0) continue;
    out += fmt::format(
        R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="none" stroke="currentColor" stroke-opacity="0.2"/>)",
        plane.center_x, plane.center_y, plane.unit * ticks.at[i]);
  }
  for (int spoke = 0; spoke < 12; ++spoke) {
    const double theta = spoke * kPi / 6;
    out += svg_line(plane.center_x, plane.center_y, plane.x(theta, plane.outer), plane.y(theta, plane.outer),
                    spoke % 3 == 0 ? 0.35 : 0.12);
  }
  return out;
}

/// After the curves, so that no lobe hides them.
std::string ring_labels(const Plane& plane) {
  std::string out;
  const Ticks ticks = linear_ticks({0, plane.outer}, kMostRings);
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    if (ticks.at[i] <= 0) continue;
    const double theta = radians(-106);  // just below the horizontal spoke, where most functions are small
    out += svg_text(plane.x(theta, ticks.at[i]) + 3, plane.y(theta, ticks.at[i]) + 4, "start", ticks.labels[i]);
  }
  return out;
}

std::string drawn(const PolarLobe& lobe, const PolarCurve& curve, const Plane& plane) {
  std::string path;
  for (const auto& [theta, radius] : lobe.points) {
    fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? "M" : "L", plane.x(theta, radius),
                   plane.y(theta, radius));
  }
  const std::string_view color = color_of(lobe.negative ? curve.negative : curve.positive);
  return fmt::format(
      R"(<path class="{0}" d="{1}" fill="{2}" fill-opacity="{3}" stroke="{2}" stroke-width="1.8" stroke-dasharray="{4}" )"
      R"(stroke-linejoin="round"/>)",
      lobe.negative ? "negative" : "positive", path, color, curve.filled ? 0.14 : 0, lobe.negative ? "4 2.5" : "none");
}

std::string drawn(const PolarNote& note, const Plane& plane) {
  const double x = plane.x(note.theta, std::abs(note.value)), y = plane.y(note.theta, std::abs(note.value));
  return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.4"/>)", x, y) +
         svg_text(x + 9, y + 15, "start", note.label);
}

}  // namespace

std::vector<PolarLobe> polar_lobes(const std::function<double(double theta)>& value) {
  std::vector<PolarLobe> lobes;
  double last = -kPi;
  for (int i = 0; i <= 2 * kHalfSamples; ++i) {
    const double theta = kPi * (i - kHalfSamples) / kHalfSamples, here = value(std::abs(theta));
    check(std::isfinite(here), "a polar plot needs finite values");
    const bool negative = here < 0;
    if (lobes.empty()) {
      lobes.push_back({negative, {}});
    } else if (negative != lobes.back().negative) {
      const double zero = zero_between(value, last, theta);
      lobes.back().points.push_back({zero, 0});
      lobes.push_back({negative, {{zero, 0}}});
    }
    lobes.back().points.push_back({theta, std::abs(here)});
    last = theta;
  }
  // Where the function is zero throughout there is nothing to see.
  std::erase_if(lobes, [](const PolarLobe& lobe) {
    return std::all_of(lobe.points.begin(), lobe.points.end(), [](const auto& point) { return point.radius == 0; });
  });
  return lobes;
}

std::string polar_plot(const PolarPlot& plot) {
  double radius = plot.radius;
  std::vector<std::vector<PolarLobe>> lobes;
  std::vector<LegendEntry> legend;
  for (const PolarCurve& curve : plot.curves) {
    lobes.push_back(polar_lobes(curve.value));
    if (plot.radius == 0) {
      for (const PolarLobe& lobe : lobes.back()) {
        for (const PolarLobe::Point& point : lobe.points) radius = std::max(radius, point.radius);
      }
    }
    if (!curve.name.empty()) legend.push_back({curve.name, curve.positive});
  }
  if (radius == 0) radius = 1;

  constexpr double kMargin = 16, kHead = 46, kLetters = 14;
  const double paper_radius = plot.size / 2 - kMargin;
  const Plane plane = {plot.size / 2, kHead + kLetters + paper_radius, paper_radius / radius, radius};
  std::string inside = rings(plane);
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    for (const PolarLobe& lobe : lobes[i]) inside += drawn(lobe, plot.curves[i], plane);
  }
  inside += ring_labels(plane);
  for (const PolarNote& note : plot.notes) inside += drawn(note, plane);
  inside += svg_text(plane.center_x, kHead + kLetters - 6, "middle", "0°");
  inside += svg_text(plane.center_x, kHead + kLetters + 2 * paper_radius + 16, "middle", "180°");
  inside += svg_text(8, 16, "start", plot.title) + svg_legend(8, 34, legend);
  return svg_frame(plot.size, kHead + 2 * kLetters + 2 * paper_radius + 8, "plot", plot.description, inside);
}

}  // namespace zonal
