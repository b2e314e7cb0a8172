#include "zonal/report/figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <stdexcept>
#include <string>

#include "zonal/report/html_check.h"

namespace zonal {
namespace {

/// A figure in the smallest page that holds one.
HtmlCheck read_figure(const std::string& svg) { return HtmlReader::read("<h1>figure</h1>" + svg); }

std::vector<double> numbers(const std::string& svg, const char* attribute) {
  const std::regex form(std::string(" ") + attribute + "=\"([-0-9.]+)\"");
  std::vector<double> out;
  for (std::sregex_iterator it(svg.begin(), svg.end(), form), end; it != end; ++it) out.push_back(std::stod((*it)[1]));
  return out;
}

TEST(Figure, LineChartIsWellFormedAndEscaped) {
  const std::string svg = line_chart({.description = "a \"b\" <c>",
                                      .x = {.label = "x & y"},
                                      .y = {.label = "<script>", .log = true},
                                      .series = {{"R'MS", {{1, 0.1}, {2, 0.01}}}, {"worst", {{1, 1}, {2, 0.5}}}}});
  const HtmlCheck check = read_figure(svg);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("circle"), 4);
  EXPECT_FALSE(check.tags.contains("script"));
  EXPECT_NE(check.text.find("<script>"), std::string::npos);
  EXPECT_NE(check.text.find("R'MS"), std::string::npos);
}

TEST(Figure, PointsStandWhereTheirValuesAre) {
  const std::string svg = line_chart(
      {.description = "", .x = {.label = "x"}, .y = {.label = "y"}, .series = {{"s", {{0, 0}, {5, 5}, {10, 10}}}}});
  const std::vector<double> cx = numbers(svg, "cx"), cy = numbers(svg, "cy");
  ASSERT_EQ(cx.size(), 3u);
  EXPECT_NEAR(cx[1], (cx[0] + cx[2]) / 2, 0.11);  // printed to a tenth
  EXPECT_NEAR(cy[1], (cy[0] + cy[2]) / 2, 0.11);
  EXPECT_LT(cx[0], cx[2]);
  EXPECT_GT(cy[0], cy[2]);  // up is more
}

TEST(Figure, LeavesOutWhatHasNoPlace) {
  const double inf = std::numeric_limits<double>::infinity();
  const std::string svg =
      line_chart({.description = "",
                  .x = {.label = "x"},
                  .y = {.label = "y", .log = true},
                  .series = {{"s", {{1, 1}, {2, 0}, {3, std::nan("")}, {4, inf}, {5, -1}, {6, 10}}}}});
  EXPECT_EQ(read_figure(svg).problems, std::vector<std::string>());
  EXPECT_EQ(numbers(svg, "cx").size(), 2u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(Figure, EmptyAndConstantDataStillHaveAxes) {
  for (const bool log : {false, true}) {
    for (const std::vector<ChartPoint>& points :
         {std::vector<ChartPoint>{}, {{1, 3}}, {{1, 3}, {2, 3}}, {{1, 1e300}}}) {
      const std::string svg = line_chart(
          {.description = "", .x = {.label = "x"}, .y = {.label = "y", .log = log}, .series = {{"s", points}}});
      const HtmlCheck check = read_figure(svg);
      EXPECT_EQ(check.problems, std::vector<std::string>());
      EXPECT_GE(check.tags.at("text"), 2 + 2 + 2);  // labels, and two ticks each way
      EXPECT_EQ(numbers(svg, "cx").size(), points.size());
    }
  }
}

TEST(Figure, BarsShareOneBaseAndShowLowOnes) {
  const std::string svg = bar_chart({.description = "",
                                     .x = {.label = "stops"},
                                     .y = {.label = "share"},
                                     .first = -2,
                                     .width = 1,
                                     .heights = {1, 0, 1e-9, 0.5},
                                     .marks = {{0, "mean"}}});
  EXPECT_EQ(read_figure(svg).problems, std::vector<std::string>());
  const std::regex bar(R"(M([0-9.]+) ([0-9.]+)V([0-9.]+)H([0-9.]+)V([0-9.]+)z)");
  std::vector<double> heights;
  for (std::sregex_iterator it(svg.begin(), svg.end(), bar), end; it != end; ++it) {
    EXPECT_EQ((*it)[2], (*it)[5]);
    heights.push_back(std::stod((*it)[2]) - std::stod((*it)[3]));
  }
  ASSERT_EQ(heights.size(), 3u);  // nothing for zero
  EXPECT_NEAR(heights[2], heights[0] / 2, 0.11);
  EXPECT_GE(heights[1], 0.4);
}

TEST(Figure, LogarithmicBarsStandOnTheLowestDecade) {
  const std::string svg = bar_chart({.description = "",
                                     .x = {.label = "stops"},
                                     .y = {.label = "share", .log = true},
                                     .first = 0,
                                     .width = 1,
                                     .heights = {0.5, 0.003, 0}});
  const HtmlCheck check = read_figure(svg);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_NE(check.text.find("10⁻³"), std::string::npos);
}

TEST(Figure, RefusesBarsOfNoHeight) {
  BarChart chart = {.description = "", .x = {}, .y = {}, .heights = {std::nan("")}};
  EXPECT_THROW(bar_chart(chart), std::logic_error);
  chart.heights = {-1};
  EXPECT_THROW(bar_chart(chart), std::logic_error);
  chart.heights = {};
  EXPECT_NO_THROW(bar_chart(chart));
}

}  // namespace
}  // namespace zonal
