// Pictures and pages of the viewer, from the command line.
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "zonal/view/technique.h"

namespace zonal {
namespace {

class SlowCliView : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    good({"sky", "daylight", "--size", "32", "-o", "sky.exr", "-q"});
  }
  bool can_draw() const { return run({"view", "sky.exr", "--screenshot", "try.png", "--size", "8x8", "-q"}).code == 0; }
};

TEST_F(SlowCliView, ListsEveryTechnique) {
  const auto list = nlohmann::json::parse(good({"view", "--list", "--json"}).out).at("techniques");
  ASSERT_EQ(list.size(), all_techniques().size());
  for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(list[i].at("id"), all_techniques()[i].id);
}

TEST_F(SlowCliView, ASheetHasEveryTechniqueWithItsDifference) {
  if (!can_draw()) GTEST_SKIP() << "no OpenGL without a display";
  const auto said = nlohmann::json::parse(good({"view", "sky.exr", "--sheet", "all.svg", "--json"}).out);
  ASSERT_EQ(said.at("techniques").size(), all_techniques().size());
  const std::string svg = bytes_of(path("all.svg"));
  std::size_t pictures = 0, off = 0;
  for (std::size_t at = svg.find("<image"); at != std::string::npos; at = svg.find("<image", at + 1)) ++pictures;
  EXPECT_EQ(pictures, all_techniques().size());
  for (const auto& technique : said["techniques"]) off += technique.at("difference_rms").get<double>() > 0.01;
  EXPECT_GT(off, 5u) << "techniques that are not exact differ from what is";
  EXPECT_LT(off, all_techniques().size()) << "and those that are do not";
  EXPECT_NE(svg.find(">Ambient cube<"), std::string::npos) << "what a picture is stands under it";
}

TEST_F(SlowCliView, AHighlightOfOnesOwnIsShown) {
  if (!can_draw()) GTEST_SKIP() << "no OpenGL without a display";
  good({"testcard", "--size", "64", "-o", "card.png", "-q"});
  const auto picture = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> words = {"view", "sky.exr", "--screenshot", name, "--size", "64x64", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    good(words);
    return bytes_of(path(name));
  };
  const std::string own = picture("own.png", {"--highlight", "card.png"});
  EXPECT_NE(own, picture("none.png", {"--set", "technique=highlight-map&highlight_source=2"}));
  EXPECT_NE(own, picture("weak.png", {"--highlight", "card.png", "--set", "highlight_strength=0.5"}));
  EXPECT_EQ(picture("other.png", {"--highlight", "card.png", "--technique", "cube-map"}),
            picture("cube.png", {"--technique", "cube-map"}))
      << "another technique does not look at it";
  good({"view", "sky.exr", "--highlight", "card.png", "--html", "own.html", "-q"});
  EXPECT_NE(bytes_of(path("own.html")).find("technique=highlight-map"), std::string::npos);
  write("text.png", "no picture");
  bad(3, {"view", "sky.exr", "--highlight", "text.png", "--html", "a.html"}, "text.png");
}

TEST_F(SlowCliView, WhatIsWrongIsSaid) {
  bad(2, {"view", "sky.exr", "--screenshot", "a.png", "--size", "12"}, "'12' is not a size");
  bad(2, {"view", "sky.exr", "--screenshot", "a.png", "--size", "0x5"}, "is not a size");
  bad(2, {"view", "sky.exr", "--screenshot", "a.png", "--technique", "magic"}, "no technique 'magic'");
  bad(2, {"view", "sky.exr", "--sheet", "a.svg", "--set", "roughness=7"}, "roughness is 7");
  bad(2, {"view", "sky.exr", "--html", "a.html", "--set", "shiny=1"}, "shiny");
  write("broken.ply", "ply\nformat ascii 1.0\nelement vertex 9999999999\nproperty float x\nend_header\n");
  bad(3, {"view", "sky.exr", "--html", "a.html", "--mesh", "broken.ply"}, "broken.ply");
  bad(3, {"view", "sky.exr", "--html", "a.html", "--mesh", "nothing.obj"}, "nothing.obj");
  std::vector<float> values(3 * 32 * 16, 1);
  values[100] = std::nanf("");
  write_pfm("nan.pfm", 32, 16, values);
  bad(3, {"view", "nan.pfm", "--html", "a.html"}, "NaN");
}

}  // namespace
}  // namespace zonal
