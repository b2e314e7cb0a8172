#include "zonal/report/response_figure.h"

#include <gtest/gtest.h>

#include "zonal/report/html_check.h"

namespace zonal {
namespace {

HtmlCheck read_figure(const Response& response) {
  return HtmlReader::read("<h1>figure</h1>" + response_figure(response));
}

TEST(ResponseFigure, EqualChannelsAreOneLine) {
  const HtmlCheck check = read_figure(Response::srgb());
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("circle"), 17);  // codes 15, 30, ... 255; code 0 has no logarithm
  EXPECT_NE(check.text.find("all channels"), std::string::npos);
}

TEST(ResponseFigure, DifferentChannelsStandBesideSrgb) {
  Response response = Response::srgb();
  for (double& x : response.exposure[2]) x = 2 * x + 1e-3;
  const HtmlCheck check = read_figure(response);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("circle"), 17 * 3 + 18);
  for (const char* name : {"red", "green", "blue", "sRGB"}) EXPECT_NE(check.text.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace zonal
