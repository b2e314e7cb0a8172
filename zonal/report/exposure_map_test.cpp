#include "zonal/report/exposure_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "zonal/report/pixel_text.h"

namespace zonal {
namespace {

std::tuple<int, int, int> key(Rgb8 c) { return {c.r, c.g, c.b}; }

TEST(ExposureWords, AreThoseOfPhotographers) {
  EXPECT_EQ(exposure_words(1.0 / 250), "1/250 s");
  EXPECT_EQ(exposure_words(1.0 / 8000), "1/8000 s");
  EXPECT_EQ(exposure_words(0.0333), "1/30 s");
  EXPECT_EQ(exposure_words(0.25), "1/4 s");
  EXPECT_EQ(exposure_words(0.6), "0.6 s");
  EXPECT_EQ(exposure_words(0.3), "0.3 s");
  EXPECT_EQ(exposure_words(30), "30 s");
}

TEST(ExposureMap, ColoursEverySourceAndNamesThemAll) {
  Merge merge{Image<Rgb>(40, 30), Image<std::uint8_t>(40, 30)};
  const std::uint8_t sources[] = {0, 1, 2, kOnlySaturated, kOnlyBlack, kInConflict, kNoData};
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) merge.source(x, y) = sources[x / 6 % 7];
  }
  const std::vector<std::string> names = {"1/100 S", "1/10 S", "1 S"};
  const Image<Rgb8> map = exposure_map(merge, names);
  EXPECT_GE(map.width(), 40);
  EXPECT_GT(map.height(), 30);
  std::set<std::tuple<int, int, int>> colors;
  for (int i = 0; i < 7; ++i) colors.insert(key(map(6 * std::min(i, 6), 15)));
  EXPECT_EQ(colors.size(), 7u);  // no two alike
  EXPECT_EQ(map(18, 3), (Rgb8{255, 255, 255}));
  EXPECT_EQ(map(24, 3), (Rgb8{0, 0, 0}));
  // The legend shows each of them: a swatch is at least 10 x 5 pixels.
  int shown = 0;
  for (const auto& color : colors) {
    int pixels = 0;
    for (int y = 30; y < map.height(); ++y) {
      for (const Rgb8& p : map.row(y)) pixels += key(p) == color;
    }
    EXPECT_GE(pixels, 50);
    ++shown;
  }
  EXPECT_EQ(shown, 7);
}

TEST(ExposureMap, LeavesOutWhatDoesNotOccur) {
  Merge merge{Image<Rgb>(300, 20), Image<std::uint8_t>(300, 20)};
  const std::vector<std::string> names = {"1/2 S", "1 S"};
  const Image<Rgb8> map = exposure_map(merge, names);
  EXPECT_EQ(map.width(), 300);
  int magenta = 0;
  for (const Rgb8& p : map.values()) magenta += p == Rgb8{255, 0, 255};
  EXPECT_EQ(magenta, 0);
}

TEST(PixelText, DrawsInsideItsBoxOnly) {
  int drawn = 0;
  for (const std::string_view word : {"0123456789", "ABCDEFGHIJKLMNOPQRSTUVWXYZ", "1/250 s 3.5%", "-"}) {
    for (const int dot : {1, 2}) {
      const int width = pixel_text_width(word, dot);
      Image<Rgb8> picture(width + 8, kPixelTextDots * dot + 8);
      draw_pixel_text(picture, 4, 4, word, dot, {255, 255, 255});
      int inside = 0, outside = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
          const bool box = x >= 4 && x < 4 + width && y >= 4 && y < 4 + kPixelTextDots * dot;
          (box ? inside : outside) += picture(x, y).r > 0;
        }
      }
      EXPECT_EQ(outside, 0) << word;
      EXPECT_GE(inside, 3 * dot * dot) << word;
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 8);
  Image<Rgb8> small(3, 3);
  draw_pixel_text(small, -2, 1, "8888", 3, {255, 255, 255});  // cut off, not written beyond
}

}  // namespace
}  // namespace zonal
