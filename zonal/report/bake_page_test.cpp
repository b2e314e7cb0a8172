#include "zonal/report/bake_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "zonal/report/html_check.h"

namespace zonal {
namespace {

constexpr const char* kHostile = "\"><img src=x onerror=alert(1)>&'.exr";

/// A map that is no function in particular, but the same each time.
Environment noise(const Projection& projection, ImageSize size, float scale = 1) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> value(0, scale);
  Environment map = {Image<Rgb>(size.width, size.height), projection};
  for (Rgb& texel : map.radiance.values()) texel = {value(random), value(random), value(random)};
  return map;
}

/// A page in which every figure is different, so that each can be found.
BakePage full_page() {
  BakePage page;
  page.title = kHostile;
  page.subtitle = "equirect, 64 × 32";
  page.panorama = noise({Layout::kEquirect}, {64, 32});
  Survey& survey = page.survey;
  survey.size = {64, 32};
  survey.mean = {0.1111, 0.2222, 0.3333};
  survey.min_luminance = 0.00123;
  survey.max_luminance = 4567;
  survey.histogram[20] = 3.5;
  survey.histogram[23] = 1.25;
  survey.sun = SunEstimate{normalize({1, 1, 1}), 0.654, {7.111, 7.222, 7.333}, 0.2468};

  page.irradiance = noise({Layout::kCubeStack}, {16, 96});
  page.irradiance_up = {1.011, 1.022, 1.033};
  page.irradiance_down = {2.011, 2.022, 2.033};
  page.irradiance_report = {.bands = 41,
                            .points = 0,
                            .widened_deg = 0,
                            .error_bound = 1,
                            .bound_to_mean = 2.3e-7,
                            .bound_to_peak = 4.5e-8,
                            .zeroed_texels = 0,
                            .zeroed_depth = 0};
  page.irradiance_verified = Verification{.directions = 257, .rms = 6.7e-9, .worst = 8.9e-9};
  page.lobe = "GGX";
  page.chain.push_back({noise({Layout::kCubeStack}, {32, 192}), 0, 0});
  page.chain.push_back({noise({Layout::kCubeStack}, {16, 96}),
                        0.321,
                        0.103,
                        {.bands = 77,
                         .points = 9,
                         .widened_deg = 0.087,
                         .error_bound = 1,
                         .bound_to_mean = 1.9e-4,
                         .bound_to_peak = 1.7e-5,
                         .zeroed_texels = 5,
                         .zeroed_depth = 1e-9},
                        Verification{.directions = 259, .rms = 1.3e-6, .worst = 1.4e-5}});
  for (const int bands : {1, 3}) {
    page.sh.push_back({bands, noise({Layout::kEquirect}, {96, 48}), 0.1234 / bands, 0.5432 / bands});
  }
  page.split_sum = noise({}, {8, 8}).radiance;
  page.split_sum_channels = "Red: scale.";
  page.files = {{"a<b>.ktx2", "cube & all", 1234567}, {"sh.json", "coefficients", 890}};
  page.settings = {{"levels", "2"}, {"<name>", kHostile}};
  page.timings = {{"read", 0.25}, {"write", 0.75}};
  page.loading = {{"engine", "if (a < b && c) load(\"x\");"}};
  page.footer = "Zonal";
  return page;
}

/// Drawn once: several tests read it.
const std::string& full_page_html() {
  static const std::string html = bake_page_html(full_page());
  return html;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(SlowBakePage, IsWellFormedWithEveryPicture) {
  const HtmlCheck check = HtmlReader::read(full_page_html());
  EXPECT_EQ(check.problems, std::vector<std::string>());
  // Panorama; irradiance map and ball; a ball a level; exact ball and map; three a fit; colour scale; split sum.
  EXPECT_EQ(check.tags.at("img"), 1 + 2 + 2 + 2 + 3 * 2 + 1 + 1);
  EXPECT_EQ(check.tags.at("svg"), 1 + 2);  // the sun's ring, two charts
  EXPECT_FALSE(check.tags.contains("script"));
  EXPECT_GE(count(check.text, kHostile), 3u);  // title, heading, setting
}

TEST(SlowBakePage, SectionsComeInOrder) {
  const std::string& html = full_page_html();
  std::size_t last = 0, compared = 0;
  for (const char* id : {"panorama", "irradiance", "chain", "sh", "histogram", "energy", "sun", "warnings", "split-sum",
                         "files", "settings", "accuracy", "timings", "loading"}) {
    const std::size_t at = html.find(std::string("<section id=\"") + id + "\"");
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_GT(at, last) << id;
    last = at;
    ++compared;
  }
  EXPECT_EQ(compared, count(html, "<section "));
}

TEST(SlowBakePage, ShowsTheFiguresGiven) {
  const std::string text = HtmlReader::read(full_page_html()).text;
  int compared = 0;
  for (const char* figure : {
           "64 × 32",  // size
           "0.1111",
           "0.2222",
           "0.3333",
           "0.00123",
           "4567",    // survey
           "0.2066",  // luminance of the mean, by Rec. 709
           "45.00°",
           "35.26°",
           "0.654°",
           "24.7 %",  // sun: azimuth, elevation, diameter, share
           "7.111",
           "7.222",
           "7.333",  //
           "3.500",
           "73.7 %",
           "1.250",
           "26.3 %",  // histogram: 3.5 and 1.25 of 4.75 sr
           "1.011",
           "1.022",
           "1.033",
           "2.011",
           "2.022",
           "2.033",  // irradiance
           "2.3×10⁻⁷",
           "4.5×10⁻⁸",
           "6.7×10⁻⁹",
           "8.9×10⁻⁹",
           "257",  // its accuracy
           "0.321",
           "0.103",
           "77 bands + 9 texels",
           "32 px",
           "16 px",  // chain
           "1.9×10⁻⁴",
           "1.7×10⁻⁵",
           "1.3×10⁻⁶",
           "1.4×10⁻⁵",
           "259",
           "5 texels came out below zero",
           "Level 1: the lobe is too sharp for its bands and was widened by 0.087°",
           "RMS 12 %",
           "worst 54 %",
           "RMS 4.1 %",
           "worst 18 %",
           "12.3 %",
           "54.3 %",
           "4.11 %",
           "18.1 %",  // harmonics
           "1.23 MB",
           "890 B",
           "2 files",
           "a<b>.ktx2",
           "cube & all",  // files
           "250 ms",
           "750 ms",
           "1.00 s",
           "25 %",
           "75 %",  // timings
           "if (a < b && c) load(\"x\");",
       }) {
    EXPECT_NE(text.find(figure), std::string::npos) << figure;
    ++compared;
  }
  EXPECT_EQ(compared, 60);
}

TEST(SlowBakePage, MarksTheSunWhereItIs) {
  BakePage page = full_page();
  page.survey.sun->toward_sun = {0, -1, 0};  // a quarter of the width right of the centre, on the horizon
  const std::string html = bake_page_html(page);
  EXPECT_EQ(count(html, "cx=\"768.0\" cy=\"256.0\""), 2u);
  page.survey.sun.reset();
  EXPECT_EQ(count(bake_page_html(page), "r=\"17\""), 0u);
}

TEST(SlowBakePage, WarnsOrSaysThatThereIsNothing) {
  EXPECT_EQ(count(full_page_html(), "No warnings"), 1u);
  BakePage page = full_page();
  page.survey.negative_texels = 31;
  page.survey.clipped_sun = true;
  page.warnings = {kHostile};
  const HtmlCheck check = HtmlReader::read(bake_page_html(page));
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(count(check.text, "No warnings"), 0u);
  EXPECT_EQ(count(check.text, "31 texels hold negative radiance"), 1u);
  EXPECT_EQ(count(check.text, "clipped"), 1u);
}

TEST(SlowBakePage, HasAViewerWhereOneIsGiven) {
  BakePage page = full_page();
  page.viewer = bake_page_viewer(page.panorama);
  const std::string html = bake_page_html(page);
  const HtmlCheck check = HtmlReader::read(html);
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_EQ(check.tags.at("script"), 6);  // tables, program, two parts of the numbers, a call between them, no module
  EXPECT_TRUE(check.ids.contains("live"));
  EXPECT_TRUE(check.ids.contains("zonal-view"));
  EXPECT_EQ(count(html, "script-src 'unsafe-inline'"), 1u);
  EXPECT_EQ(count(full_page_html(), "script-src"), 0u);
  EXPECT_LT(page.viewer.html.size(), 1.8e6);  // of noise, which does not compress
}

TEST(SlowBakePage, SaysWhenNothingWasMeasured) {
  EXPECT_EQ(count(full_page_html(), "Nothing was measured"), 0u);
  BakePage page = full_page();
  page.irradiance_verified.reset();
  page.chain[1].verified.reset();
  EXPECT_EQ(count(bake_page_html(page), "Nothing was measured"), 1u);
}

TEST(SlowBakePage, SameBytesOnAnyNumberOfThreads) {
  const BakePage page = full_page();
  zonal::Run run;  // testing::Test has a Run of its own
  run.threads = 1;
  const std::string one = bake_page_html(page, run);
  int compared = 0;
  for (const int threads : {1, 2, 7}) {
    run.threads = threads;
    EXPECT_TRUE(bake_page_html(page, run) == one) << threads;
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

TEST(SlowBakePage, LivesWithLittle) {
  BakePage page;
  page.panorama = noise({Layout::kEquirect}, {2, 1});
  page.irradiance = noise({Layout::kEquirect}, {2, 1});
  const HtmlCheck check = HtmlReader::read(bake_page_html(page));
  EXPECT_EQ(check.problems, std::vector<std::string>());
  EXPECT_FALSE(check.ids.contains("chain"));
  EXPECT_TRUE(check.ids.contains("panorama"));
}

TEST(SlowBakePage, LivesWithDoubtfulMaps) {
  const float odd[] = {0, std::nanf(""), HUGE_VALF, -1, 1e30f, 1e-30f};
  int compared = 0;
  for (const float value : odd) {
    BakePage page = full_page();
    for (Environment* map : {&page.panorama, &page.irradiance, &page.chain[0].map, &page.sh[0].irradiance}) {
      for (Rgb& texel : map->radiance.values()) texel = {value, value, value};
    }
    page.survey.mean = {value, value, value};
    page.survey.max_luminance = value;
    page.survey.histogram = {};
    page.sh[0].rms = value;
    EXPECT_EQ(HtmlReader::read(bake_page_html(page)).problems, std::vector<std::string>()) << value;
    ++compared;
  }
  EXPECT_EQ(compared, 6);
}

TEST(SlowBakePage, StaysSmallForNoiseOfAnySize) {
  BakePage page = full_page();
  page.panorama = noise({Layout::kEquirect}, {2048, 1024});
  page.irradiance = noise({Layout::kEquirect}, {1024, 512});
  page.chain.clear();
  for (int level = 0; level < 6; ++level) {
    page.chain.push_back(
        {noise({Layout::kCubeStack}, {256 >> level, 6 * (256 >> level)}), level / 5.0, level * level / 25.0});
  }
  const std::string html = bake_page_html(page);
  EXPECT_LT(html.size(), 3.5e6);  // noise does not compress: nothing real is as large
  EXPECT_GT(html.size(), 1e6);
}

}  // namespace
}  // namespace zonal
