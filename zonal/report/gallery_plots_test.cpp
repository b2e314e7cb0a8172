#include "zonal/report/gallery_plots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "zonal/report/html_check.h"

namespace zonal {
namespace {

/// Drawn once for all tests.
const std::vector<GalleryFigure>& plots() {
  static const std::vector<GalleryFigure> all = gallery_plots();
  return all;
}

const GalleryFigure& figure(const std::string& id) {
  const auto found = std::ranges::find(plots(), id, &GalleryFigure::id);
  if (found == plots().end()) throw std::out_of_range(id);
  return *found;
}

TEST(SlowGalleryPlots, EveryNumberHolds) {
  int compared = 0;
  std::map<std::string, int> by_figure;
  for (const GalleryFigure& f : plots()) {
    for (const PublishedNumber& n : f.numbers) {
      EXPECT_TRUE(holds(n)) << f.id << ": " << n.what << ' ' << n.ours << " for " << n.expected;
      EXPECT_LT(n.tolerance, 0.01) << n.what << ": this would hold for nearly anything";
      ++compared;
      ++by_figure[f.id];
    }
  }
  EXPECT_EQ(compared, 65);
  EXPECT_EQ(by_figure.size(), 10u);  // every figure has some
}

TEST(SlowGalleryPlots, TheNumbersThatThePaperIsKnownFor) {
  int found = 0;
  const auto expect = [&](const std::string& id, const std::string& printed, double value, double tolerance) {
    const auto& numbers = figure(id).numbers;
    const auto number = std::ranges::find(numbers, printed, &PublishedNumber::printed);
    ASSERT_NE(number, numbers.end()) << id << ' ' << printed;
    EXPECT_NEAR(number->ours, value, tolerance) << printed;
    ++found;
  };
  expect("clamped-cosine-3", "17 : 1", 17, 1e-12);
  expect("clamped-cosine-5", "31 : −1", -31, 1e-12);
  expect("clamped-cosine-3", "16π/17", 2.956793, 1e-6);
  expect("clamped-cosine-5", "32π/31", 3.242934, 1e-6);
  expect("laplacian", "0.004209", 0.004209, 5e-7);  // half of the last digit
  expect("laplacian", "0.000632", 0.000632, 5e-7);
  expect("windows", "12.0105", 12.0105, 5e-5);
  expect("windows", "9.8725", 9.8725, 5e-5);
  EXPECT_EQ(found, 8);
}

TEST(SlowGalleryPlots, EveryPictureIsThereWellFormedAndDescribed) {
  std::set<std::string> names, ids;
  int drawings = 0, pictures = 0;
  for (const GalleryFigure& f : plots()) {
    EXPECT_TRUE(ids.insert(f.id).second) << f.id;
    EXPECT_FALSE(f.title.empty() || f.caption.empty() || f.source.empty() || f.pictures.empty()) << f.id;
    for (const GalleryPicture& p : f.pictures) {
      EXPECT_TRUE(names.insert(p.name).second) << p.name;
      EXPECT_GT(p.alt.size(), 20u) << p.name;
      EXPECT_NE(p.svg.empty(), p.picture.empty()) << p.name << " must be one of the two";
      if (p.svg.empty()) {
        for (const Rgb c : p.picture.values()) ASSERT_TRUE(c.r >= 0 && c.g >= 0 && c.b >= 0 && c.r < 2) << p.name;
        ++pictures;
      } else {
        EXPECT_EQ(HtmlReader::read("<h1>plot</h1>" + p.svg).problems, std::vector<std::string>()) << p.name;
        EXPECT_EQ(p.svg.find("nan"), std::string::npos) << p.name;
        ++drawings;
      }
    }
  }
  EXPECT_EQ(drawings, 23);
  EXPECT_EQ(pictures, 3);
}

TEST(SlowGalleryPlots, RatiosAreMarkedInTheDrawings) {
  int marked = 0;
  for (const auto& [id, words] : {std::pair{"clamped-cosine-3", "17 : 1"}, {"clamped-cosine-5", "31 : −1"}}) {
    EXPECT_NE(figure(id).pictures.at(0).svg.find(words), std::string::npos) << words;
    ++marked;
  }
  EXPECT_EQ(marked, 2);
}

TEST(SlowGalleryPlots, ConesShowFourAnglesInTwoKindsAndTwoBands) {
  const GalleryFigure& cones = figure("cones");
  ASSERT_EQ(cones.pictures.size(), 4u);
  for (const GalleryPicture& p : cones.pictures) {
    for (const char* angle : {">90°<", ">45°<", ">30°<", ">12.5°<"}) EXPECT_NE(p.svg.find(angle), std::string::npos);
  }
}

TEST(GalleryNumbers, HoldWithinTheirToleranceAndNeverAsNan) {
  EXPECT_TRUE(holds({"", "", 1.5, 1, 0.5}));
  EXPECT_FALSE(holds({"", "", 1.6, 1, 0.5}));
  EXPECT_FALSE(holds({"", "", std::nan(""), 1, 0.5}));
}

}  // namespace
}  // namespace zonal
