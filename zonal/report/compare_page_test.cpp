#include "zonal/report/compare_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "zonal/report/html_check.h"

namespace zonal {
namespace {

Image<Rgb> ramp(int width, int height) {
  Image<Rgb> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image(x, y) = {static_cast<float>(x + 1), static_cast<float>(y + 1), 0.5f};
  }
  return image;
}

TEST(ComparePage, ShowsTheDifference) {
  const Image<Rgb> expected = ramp(8, 4);
  Image<Rgb> got = expected;
  got(5, 2).g += 0.25f;
  const std::string html = compare_page_html({"a <b> test", expected, got, {{"tolerance", "1e-6"}}});
  const HtmlCheck check = HtmlReader::read(html);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("img"), 3);
  for (const char* words :
       {"0.250000", "5, 2", "6.00000, 3.00000, 0.500000", "6.00000, 3.25000, 0.500000", "32", "1e-6", "a <b> test"}) {
    EXPECT_NE(check.text.find(words), std::string::npos) << words;
  }
}

TEST(ComparePage, SizesMayDiffer) {
  for (const auto& [a, b] :
       {std::pair{ramp(8, 4), ramp(4, 4)}, {ramp(8, 4), Image<Rgb>()}, {Image<Rgb>(), Image<Rgb>()}}) {
    const HtmlCheck check = HtmlReader::read(compare_page_html({"sizes", a, b, {}}));
    EXPECT_EQ(check.problems, std::vector<std::string>());
    EXPECT_NE(check.text.find("not comparable"), std::string::npos);
  }
}

TEST(ComparePage, SurvivesNonFiniteTexels) {
  const Image<Rgb> expected = ramp(8, 4);
  Image<Rgb> got = expected;
  got(1, 1).r = std::nanf("");
  got(2, 1).b = HUGE_VALF;
  for (const auto& [a, b] : {std::pair{expected, got}, std::pair{got, got}}) {
    const HtmlCheck check = HtmlReader::read(compare_page_html({"not finite", a, b, {}}));
    EXPECT_EQ(check.problems, std::vector<std::string>());
    EXPECT_NE(check.text.find("not finite2"), std::string::npos);  // the fact's name and value, tags removed
  }
}

}  // namespace
}  // namespace zonal
