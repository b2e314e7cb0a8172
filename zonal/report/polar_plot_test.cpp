#include "zonal/report/polar_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <stdexcept>

#include "zonal/math/vec.h"
#include "zonal/report/html_check.h"

namespace zonal {
namespace {

double cosine(double theta) { return std::cos(theta); }

struct PathPoint {
  double x, y;
};

/// The points of every path of a class, in order.
std::vector<PathPoint> points_of(const std::string& svg, const std::string& css_class) {
  std::vector<PathPoint> points;
  const std::regex path("<path class=\"" + css_class + "\" d=\"([^\"]*)\""), point("[ML]([-0-9.]+) ([-0-9.]+)");
  for (std::sregex_iterator p(svg.begin(), svg.end(), path), end; p != end; ++p) {
    const std::string d = (*p)[1];
    for (std::sregex_iterator q(d.begin(), d.end(), point); q != end; ++q)
      points.push_back({std::stod((*q)[1]), std::stod((*q)[2])});
  }
  return points;
}

TEST(PolarPlot, LobesChangeWhereTheSignDoes) {
  const std::vector<PolarLobe> lobes = polar_lobes(cosine);
  ASSERT_EQ(lobes.size(), 3u);  // behind on the left, in front, behind on the right
  EXPECT_TRUE(lobes[0].negative);
  EXPECT_FALSE(lobes[1].negative);
  EXPECT_TRUE(lobes[2].negative);
  EXPECT_NEAR(lobes[1].points.front().theta, -kPi / 2, 1e-15);
  EXPECT_NEAR(lobes[1].points.back().theta, kPi / 2, 1e-15);
  EXPECT_EQ(lobes[1].points.front().radius, 0);
  int compared = 0;
  for (const PolarLobe& lobe : lobes) {
    for (std::size_t i = 1; i + 1 < lobe.points.size(); ++i) {
      const auto& [theta, radius] = lobe.points[i];
      EXPECT_EQ(radius, std::abs(std::cos(theta)));
      EXPECT_EQ(std::cos(theta) < 0, lobe.negative);
      ++compared;
    }
  }
  EXPECT_GT(compared, 700);
}

TEST(PolarPlot, NothingIsDrawnOfZeroAndOneLobeOfAConstant) {
  EXPECT_TRUE(polar_lobes([](double) { return 0.0; }).empty());
  const std::vector<PolarLobe> circle = polar_lobes([](double) { return -2.0; });
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_TRUE(circle[0].negative);
  EXPECT_EQ(circle[0].points.size(), 721u);
}

TEST(PolarPlot, RefusesWhatIsNotFinite) {
  EXPECT_THROW(polar_lobes([](double theta) { return 1 / (theta - theta); }), std::logic_error);
}

TEST(PolarPlot, StandsUprightAndInProportion) {
  const std::string svg = polar_plot({.title = "t", .description = "d", .curves = {{.name = "f", .value = cosine}}});
  // |cos| in polar coordinates is two circles of diameter 1: one above the centre (positive), one below it.
  const std::vector<PathPoint> up = points_of(svg, "positive"), down = points_of(svg, "negative");
  ASSERT_GT(up.size(), 300u);
  ASSERT_GT(down.size(), 300u);
  const double center_x = up.front().x, center_y = up.front().y;  // the lobe begins in the centre
  double top = center_y;
  for (const auto& [x, y] : up) top = std::min(top, y);
  const double diameter = center_y - top;
  EXPECT_NEAR(diameter, 320.0 / 2 - 16, 0.06);  // touches the outer ring; printed to a tenth
  int compared = 0;
  for (const auto& [x, y] : up) {
    EXPECT_NEAR(std::hypot(x - center_x, y - (center_y - diameter / 2)), diameter / 2, 0.15);
    ++compared;
  }
  for (const auto& [x, y] : down) {
    EXPECT_NEAR(std::hypot(x - center_x, y - (center_y + diameter / 2)), diameter / 2, 0.15);
    ++compared;
  }
  EXPECT_GT(compared, 700);
}

TEST(PolarPlot, LobesHaveTheColoursOfTheirSigns) {
  const std::string svg = polar_plot({.title = "", .description = "", .curves = {{.name = "", .value = cosine}}});
  const std::regex lobe(
      "<path class=\"(positive|negative)\"[^>]* stroke=\"([^\"]*)\"[^>]* stroke-dasharray=\"([^\"]*)\"");
  int positive = 0, negative = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), lobe), end; it != end; ++it) {
    const bool is_negative = (*it)[1] == "negative";
    EXPECT_EQ((*it)[2].str(), color_of(is_negative ? Ink::kBlue : Ink::kRed));
    EXPECT_EQ((*it)[3] == "none", !is_negative);  // the sign shows without colour
    ++(is_negative ? negative : positive);
  }
  EXPECT_EQ(positive, 1);
  EXPECT_EQ(negative, 2);
}

TEST(PolarPlot, WhatIsLargerStandsOnTheOuterRing) {
  const std::string svg = polar_plot(
      {.title = "", .description = "", .curves = {{.name = "", .value = [](double) { return 5.0; }}}, .radius = 1});
  int compared = 0;
  for (const auto& [x, y] : points_of(svg, "positive")) {
    EXPECT_NEAR(std::hypot(x - 160, y - (46 + 14 + 144)), 144, 0.1);
    ++compared;
  }
  EXPECT_EQ(compared, 721);
}

TEST(PolarPlot, RingsAreLabelledAndTheDrawingIsWellFormed) {
  const std::string svg = polar_plot({.title = "a < b",
                                      .description = "\"d\"",
                                      .curves = {{.name = "f & g", .value = cosine}},
                                      .notes = {{0, 1, "one"}},
                                      .radius = 1});
  const HtmlCheck check = HtmlReader::read("<h1>plot</h1>" + svg);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  for (const char* words : {"0.2", "1.0", "0°", "180°", "one", "f & g", "a < b"})
    EXPECT_NE(check.text.find(words), std::string::npos) << words;
  EXPECT_EQ(check.tags.at("circle"), 5 + 1);  // five rings and the note's dot
}

}  // namespace
}  // namespace zonal
