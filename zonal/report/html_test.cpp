#include "zonal/report/html.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <stdexcept>
#include <string>

#include "zonal/report/html_check.h"
#include "zonal/report/style.h"

namespace zonal {
namespace {

constexpr const char* kHostile = "</title><script>alert(\"1\")</script> & 'x'.exr";

HtmlPage small_page() {
  const std::string everything =
      html_paragraph(kHostile, "quiet") + html_heading(kHostile) + html_details(kHostile, html_code(kHostile)) +
      html_facts({{kHostile, kHostile}}) +
      html_table({kHostile, {{"name"}, {kHostile, true}}, {{kHostile, "1"}, {"b", kHostile}}}) +
      html_figure(html_picture({"data:image/png;base64,AAAA", 2, 1, kHostile}), "<b>caption</b>", "wide");
  return {.title = kHostile,
          .subtitle = kHostile,
          .lead_html = {},
          .sections = {{"first", kHostile, everything}},
          .footer = kHostile};
}

TEST(Html, EveryPartEscapesHostileText) {
  const HtmlCheck check = HtmlReader::read(html_page(small_page()));
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_FALSE(check.tags.contains("script"));
  EXPECT_EQ(check.tags.at("title"), 1);
  std::size_t shown = 0;
  for (std::size_t at = check.text.find(kHostile); at != std::string::npos; at = check.text.find(kHostile, at + 1))
    ++shown;
  // title, h1, subtitle, contents, h2, paragraph, h3, summary, code, two facts, caption, column, two cells, footer.
  EXPECT_EQ(shown, 16u);
}

TEST(Html, RefusesIdsThatAreNoneOrTwice) {
  HtmlPage page = small_page();
  page.sections[0].id = "two words";
  EXPECT_THROW(html_page(page), std::logic_error);
  page = small_page();
  page.sections.push_back(page.sections[0]);
  EXPECT_THROW(html_page(page), std::logic_error);
  EXPECT_THROW(html_table({"c", {{"a"}, {"b"}}, {{"only one"}}}), std::logic_error);
}

TEST(Html, ReaderSeesWhatIsWrong) {
  const std::string h1 = "<h1>x</h1>";
  EXPECT_EQ(HtmlReader::read(h1).problems.size(), 0u);
  int compared = 0;
  for (const char* bad :
       {"<p>", "</p>", "<b><i></b></i>", "<img src=\"data:,\" width=\"1\" height=\"1\">", "<h3>y</h3>", "a > b",
        "a & b", "&nbsp;", "<a href=\"#none\">x</a>", "<p id=\"a\"></p><p id=\"a\"></p>", "<table></table>",
        "<p class=x></p>", "<svg></svg>", "<a href=\"https://example.org\">x</a>", "<h1>twice</h1>", "<p",
        "<p class=\"a\" class=\"b\"></p>"}) {
    EXPECT_GE(HtmlReader::read(h1 + bad).problems.size(), 1u) << bad;
    ++compared;
  }
  EXPECT_EQ(compared, 17);
}

/// Relative luminance of a colour "#rgb" or "#rrggbb" (WCAG 2.1).
double relative_luminance(std::string hex) {
  if (hex.size() == 4) hex = {hex[0], hex[1], hex[1], hex[2], hex[2], hex[3], hex[3]};
  const auto channel = [&](std::size_t at) {
    const double c = std::stoi(hex.substr(at, 2), nullptr, 16) / 255.0;
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

double contrast(const std::string& a, const std::string& b) {
  const double x = relative_luminance(a), y = relative_luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

TEST(Html, TextContrastIsAaInEveryScheme) {
  const std::string style(page_style());
  const std::regex scheme(
      R"(--paper: (#\w+); --ink: (#\w+); --quiet: (#\w+); --rule: #\w+; --shade: (#\w+); --accent: (#\w+);)");
  int compared = 0;
  for (std::sregex_iterator it(style.begin(), style.end(), scheme), end; it != end; ++it) {
    const std::smatch& colors = *it;
    for (const int text : {2, 3, 5}) {
      for (const int ground : {1, 4}) {
        EXPECT_GE(contrast(colors[text], colors[ground]), 4.5) << colors[text] << " on " << colors[ground];
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 3 * 6);  // light, dark, paper
}

TEST(Html, StyleAsksForNothingOutside) {
  EXPECT_EQ(page_style().find("url("), std::string_view::npos);
  EXPECT_EQ(page_style().find("@import"), std::string_view::npos);
  EXPECT_EQ(page_style().find('<'), std::string_view::npos);
}

}  // namespace
}  // namespace zonal
