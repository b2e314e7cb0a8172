#include "zonal/report/fisheye_page.h"

#include <gtest/gtest.h>

#include <string>

#include "zonal/report/fisheye_page_script.h"
#include "zonal/report/html_check.h"

namespace zonal {
namespace {

Environment photograph(float top) {
  Environment e{Image<Rgb>(40, 32), {Layout::kFisheye, {.center_x_px = 18, .center_y_px = 15, .radius_x_px = 12}}};
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 40; ++x) e.radiance(x, y) = {0.1f + 0.02f * static_cast<float>(x), 0.5f, y < 16 ? top : 0.2f};
  }
  return e;
}

FisheyePage page_of(const Environment& e, bool codes, FisheyeOutside outside = FisheyeOutside::kGround) {
  const Rgb ground{0.2f, 0.4f, 0.6f};
  FisheyePage page{"a <b>'s & sky.tga", &e, codes, ground, outside, "--mode published", {}, {}, "zonal 0"};
  page.studies = fisheye_study(e, {1, 20}, {.ground = ground, .size_px = 12, .outside = outside});
  if (codes) page.averaging_codes = {{0.125, 0.25}, {0.0625, 0.5}};
  return page;
}

/// The page without its script, which is no markup.
std::string without_script(std::string html) {
  const std::size_t begin = html.find("<script>"), end = html.find("</script>");
  EXPECT_NE(begin, std::string::npos);
  EXPECT_EQ(html.substr(begin + 8, end - begin - 8), fisheye_page_script());
  return html.erase(begin, end + 9 - begin);
}

TEST(SlowFisheyePage, ShowsBothMapsInAllForms) {
  const Environment e = photograph(0.9f);
  const HtmlCheck check = HtmlReader::read(without_script(fisheye_page_html(page_of(e, true))));
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("img"), 2 * 3 * 3 + 1);
  EXPECT_EQ(check.tags.at("canvas"), 2);
  EXPECT_EQ(check.tags.at("input"), 5);
  EXPECT_EQ(check.tags.at("label"), 5);
  int found = 0;
  for (const char* words : {"irradiance map (shininess 1)", "reflection map (shininess 20)", "weights alone",
                            "ground alone", "12.5 %", "50.0 %", "cube, difference", "a <b>'s & sky.tga"}) {
    EXPECT_NE(check.text.find(words), std::string::npos) << words;
    ++found;
  }
  EXPECT_EQ(found, 8);
}

TEST(SlowFisheyePage, LightOfAnyBrightnessAndTwoParaboloids) {
  const Environment bright = photograph(30);
  const std::string html = fisheye_page_html(page_of(bright, false, FisheyeOutside::kTwo));
  const HtmlCheck check = HtmlReader::read(without_script(html));
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.text.find("codes averaged"), std::string::npos);
  EXPECT_NE(html.find("data-outside=\"two\""), std::string::npos);
  EXPECT_NE(html.find("width=\"24\" height=\"12\""), std::string::npos);
  EXPECT_EQ(check.text.find("not a number"), std::string::npos);
}

TEST(SlowFisheyePage, TheCircleIsThatOfThePhotograph) {
  const Environment e = photograph(0.9f);
  const std::string html = fisheye_page_html(page_of(e, true));
  int found = 0;
  for (const char* words :
       {"data-width=\"40\" data-height=\"32\"", "data-codes=\"yes\" data-kept=\"--mode published\"",
        "max=\"40\" step=\"0.5\" value=\"18\"", "max=\"32\" step=\"0.5\" value=\"15\"", "value=\"12\"",
        "value=\"#336699\"", "value=\"20\"", "viewBox=\"0 0 40 32\"", "script-src 'unsafe-inline'"}) {
    EXPECT_NE(html.find(words), std::string::npos) << words;
    ++found;
  }
  EXPECT_EQ(found, 9);
  // The script may not end early, nor reach out.
  EXPECT_EQ(fisheye_page_script().find("</script"), std::string_view::npos);
  EXPECT_EQ(fisheye_page_script().find("http"), std::string_view::npos);
  EXPECT_EQ(fisheye_page_script().find("eval("), std::string_view::npos);
}

TEST(SlowFisheyePage, ABlackPhotographIsStillAPage) {
  Environment black = photograph(0);
  for (Rgb& texel : black.radiance.values()) texel = {};
  FisheyePage page{"black", &black, false, {}, FisheyeOutside::kExtended, "--mode corrected", {}, {}, "zonal 0"};
  page.studies = fisheye_study(black, {1}, {.size_px = 8, .outside = FisheyeOutside::kExtended});
  const HtmlCheck check = HtmlReader::read(without_script(fisheye_page_html(page)));
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.text.find("not a number"), std::string::npos);
}

}  // namespace
}  // namespace zonal
