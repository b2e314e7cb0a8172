#include "zonal/report/svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "zonal/image/color.h"
#include "zonal/math/vec.h"
#include "zonal/report/html_check.h"

namespace zonal {
namespace {

double channel(std::string_view hex, std::size_t at) {
  return srgb_decode(static_cast<float>(std::stoi(std::string(hex.substr(at, 2)), nullptr, 16)) / 255.0f);
}

/// The luminance of "#rrggbb".
double luminance_of(std::string_view hex) { return luminance(RgbD{channel(hex, 1), channel(hex, 3), channel(hex, 5)}); }

/// WCAG 2, relative contrast.
double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

TEST(Svg, InksCanBeReadOnBothPapers) {
  std::set<std::string_view> inks;
  for (const Ink ink : {Ink::kRed, Ink::kGreen, Ink::kBlue}) {
    const std::string_view color = color_of(ink);
    ASSERT_EQ(color.size(), 7u);
    for (const char* paper : {"#fbfaf8", "#141414"})
      EXPECT_GE(contrast(luminance_of(color), luminance_of(paper)), 3.0) << color << " on " << paper;  // WCAG: graphics
    inks.insert(color);
  }
  EXPECT_EQ(inks.size(), 3u);
  EXPECT_EQ(color_of(Ink::kText), "currentColor");
}

TEST(Svg, AFileBringsItsOwnPaper) {
  const std::string file = standalone_svg(svg_frame(10, 20, "plot", "a \"b\"", svg_text(1, 2, "start", "x < y")));
  const HtmlCheck check = HtmlReader::read("<h1>file</h1>" + file);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("style"), 1);
  EXPECT_NE(file.find("prefers-color-scheme: dark"), std::string::npos);
  EXPECT_NE(file.find("viewBox=\"0 0 10 20\""), std::string::npos);
  EXPECT_TRUE(file.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THROW(standalone_svg("<p>"), std::logic_error);
}

TEST(Svg, LegendEntriesDoNotOverlap) {
  const std::string legend = svg_legend(0, 10, {{"αβγ", Ink::kRed, true}, {"b", Ink::kText, false}});
  const HtmlCheck check = HtmlReader::read("<h1>legend</h1>" + legend);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.text, "legendαβγb");
  // Three letters, not six bytes: the second sample begins after them.
  EXPECT_NE(legend.find("M0.0 6.0h22"), std::string::npos);
  EXPECT_NE(legend.find("M64.4 6.0h22"), std::string::npos);
}

}  // namespace
}  // namespace zonal
