#include "zonal/report/picture_sheet.h"

#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>
#include <string>

#include "zonal/report/html_check.h"
#include "zonal/report/png_uri.h"

namespace zonal {
namespace {

HtmlCheck read_sheet(const std::string& svg) { return HtmlReader::read("<h1>sheet</h1>" + svg); }

const Image<Rgb8> kRed(4, 4, Rgb8{200, 10, 10}), kBlue(4, 4, Rgb8{10, 10, 200});

PictureSheet two_rows() {
  return {.name = "two-rows",
          .description = "a \"b\" <c>",
          .columns = {"first & last", "second"},
          .rows = {{"upper <row>", {{kRed, "red"}, {kBlue, "one\ntwo", false}}},
                   {"", {{}, {kRed, "", true, {{0.5, 0.25}}}}}}};
}

TEST(PictureSheet, IsWellFormedAndEscaped) {
  const std::string svg = picture_sheet(two_rows());
  const HtmlCheck check = read_sheet(svg);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("image"), 3);  // not for the gap
  EXPECT_EQ(check.tags.at("text"), 2 + 1 + 3);
  EXPECT_EQ(check.tags.at("circle"), 1 + 2 + 2);  // the clip, two rims, and a mark's two rings
  EXPECT_EQ(check.ids, std::set<std::string>{"two-rows-disc"});
  EXPECT_NE(check.text.find("upper <row>"), std::string::npos);
  EXPECT_NE(svg.find(png_data_uri(kRed)), std::string::npos);
  EXPECT_NE(svg.find(png_data_uri(kBlue)), std::string::npos);
}

TEST(PictureSheet, PicturesDoNotOverlapAndStayInside) {
  const std::string svg = picture_sheet(two_rows());
  const std::regex form(R"re(<image x="([0-9.]+)" y="([0-9.]+)" width="([0-9.]+)" height="([0-9.]+)")re");
  const std::regex box(R"re(viewBox="0 0 ([0-9.]+) ([0-9.]+)")re");
  std::smatch whole;
  ASSERT_TRUE(std::regex_search(svg, whole, box));
  struct Place {
    double x, y, width, height;
  };
  std::vector<Place> places;
  for (std::sregex_iterator it(svg.begin(), svg.end(), form), end; it != end; ++it) {
    places.push_back({std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4])});
  }
  ASSERT_EQ(places.size(), 3u);
  for (const Place& p : places) {
    EXPECT_LE(p.x + p.width, std::stod(whole[1]) + 0.1);  // printed to a tenth
    EXPECT_LE(p.y + p.height, std::stod(whole[2]) + 0.1);
  }
  EXPECT_GT(places[1].x, places[0].x + places[0].width);
  EXPECT_EQ(places[1].y, places[0].y);
  EXPECT_EQ(places[2].x, places[1].x);                          // in its column although the first has a gap
  EXPECT_GT(places[2].y, places[1].y + places[1].height + 30);  // two lines of words between
}

TEST(PictureSheet, OnlyBallsAreCutOut) {
  const std::string svg = picture_sheet(two_rows());
  std::size_t cuts = 0;
  for (std::size_t at = 0; (at = svg.find("clip-path=\"url(#two-rows-disc)\"", at)) != std::string::npos; ++at) ++cuts;
  EXPECT_EQ(cuts, 2u);
}

TEST(PictureSheet, RefusesWhatHasNoPlace) {
  PictureSheet sheet = two_rows();
  sheet.name = "two rows";
  EXPECT_THROW(picture_sheet(sheet), std::logic_error);
  sheet = two_rows();
  sheet.rows.clear();
  EXPECT_THROW(picture_sheet(sheet), std::logic_error);
  sheet = two_rows();
  sheet.rows[0].cells.resize(8);
  EXPECT_THROW(picture_sheet(sheet), std::logic_error);
}

}  // namespace
}  // namespace zonal
