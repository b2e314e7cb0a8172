#include "zonal/report/curve_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <stdexcept>

#include "zonal/report/html_check.h"

namespace zonal {
namespace {

HtmlCheck read_plot(const std::string& svg) { return HtmlReader::read("<h1>plot</h1>" + svg); }

TEST(CurvePlot, SamplesBothEnds) {
  const std::vector<ChartPoint> points = sampled([](double x) { return x * x; }, -1, 3, 5);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_EQ(points.front().x, -1);
  EXPECT_EQ(points.back().x, 3);
  EXPECT_EQ(points.back().y, 9);
  EXPECT_THROW(sampled([](double x) { return x; }, 0, 1, 1), std::logic_error);
}

TEST(CurvePlot, CurvesStandWhereTheirValuesAre) {
  const std::string svg = curve_plot({.title = "",
                                      .description = "",
                                      .x = {.range = AxisRange{0, 2}},
                                      .y = {.range = AxisRange{-1, 1}},
                                      .curves = {{.name = "", .points = {{0, -1}, {1, 0}, {2, 1}}, .ink = Ink::kRed}}});
  std::smatch m;
  ASSERT_TRUE(std::regex_search(
      svg, m,
      std::regex("d=\"M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)\" fill=\"none\" stroke=\"#")));
  EXPECT_EQ(std::stod(m[1]), 46);  // the frame of a plot 440 x 300
  EXPECT_EQ(std::stod(m[5]), 426);
  EXPECT_EQ(std::stod(m[2]), 254);
  EXPECT_EQ(std::stod(m[6]), 54);
  EXPECT_EQ(std::stod(m[3]), (46 + 426) / 2);
  EXPECT_EQ(std::stod(m[4]), (254 + 54) / 2);
}

TEST(CurvePlot, DotsTakeThePlaceOfALine) {
  const Curve curve = {.name = "", .points = {{0, 0}, {1, 1}, {2, 0}}, .dots = true};
  const std::string svg = curve_plot({.title = "", .description = "", .x = {}, .y = {}, .curves = {curve}});
  const HtmlCheck check = read_plot(svg);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("circle"), 3);
  EXPECT_EQ(svg.find("stroke-dasharray"), std::string::npos);
}

TEST(CurvePlot, ALineBreaksWhereThereIsNoValue) {
  const double nan = std::nan("");
  const std::string svg = curve_plot({.title = "",
                                      .description = "",
                                      .x = {},
                                      .y = {},
                                      .curves = {{.name = "", .points = {{0, 0}, {1, 1}, {2, nan}, {3, 1}, {4, 0}}}}});
  EXPECT_TRUE(std::regex_search(svg, std::regex("d=\"M[0-9. ]+L[0-9. ]+M[0-9. ]+L[0-9. ]+\" fill")));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(CurvePlot, MarksNotesAndLegendAreWords) {
  const std::string svg = curve_plot({.title = "a & b",
                                      .description = "d",
                                      .x = {.label = "<x>", .range = AxisRange{-90, 180}, .marks = {-90, 12.5, 180}},
                                      .y = {},
                                      .curves = {{.name = "one", .points = {{0, 0}, {1, 1}}, .dashed = true},
                                                 {.name = "", .points = {{0, 1}, {1, 0}}}},
                                      .notes = {{.x = 0, .y = 0, .label = "17 : 1"}}});
  const HtmlCheck check = read_plot(svg);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  for (const char* words : {"a & b", "<x>", "−90", "12.5", "180", "one", "17 : 1"})
    EXPECT_NE(check.text.find(words), std::string::npos) << words;
  EXPECT_EQ(check.tags.at("circle"), 1);
}

TEST(CurvePlot, EmptyStillHasAxes) {
  const HtmlCheck check = read_plot(curve_plot({.title = "", .description = "", .x = {}, .y = {}, .curves = {}}));
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_GE(check.tags.at("text"), 4);
}

}  // namespace
}  // namespace zonal
