// Maps of a fisheye photograph: the published program and what it should be.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "zonal/io/picture.h"

namespace zonal {
namespace {

using CliFisheye = Cli;

class SlowCliFisheye : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    if (!std::filesystem::exists(data())) GTEST_SKIP() << "no real data beside this checkout";
  }
  static std::filesystem::path data() { return ZONAL_SOURCE_DIR "/../shared/data/fisheye"; }
};

/// A picture's codes, 0..255, without a curve.
Image<Rgb> codes_in(const std::filesystem::path& path) {
  Image<Rgb> pixels = load_picture(path, {.encoding = Encoding::kLinear}).pixels;
  for (Rgb& texel : pixels.values()) texel = 255.0f * texel;
  return pixels;
}

double largest_difference(const Image<Rgb>& a, const Image<Rgb>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Rgb d = a.values()[i] - b.values()[i];
    most = std::max<double>({most, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
  }
  return most;
}

// The maps that the author published with the first version of the program, from the photographs beside them.
TEST_F(SlowCliFisheye, RepeatsTheAuthorsOwnMapsWithinOneGreyLevel) {
  struct Pair {
    const char *sky, *irradiance, *reflection;  // reflection: nullptr where it was not published
  };
  constexpr Pair kPairs[] = {{"skymap6", "irrmap7", "envmap7"}, {"skymap3", "irrmapa", "envmapa"},
                             {"skymap1", "irrmapb", "envmapb"}, {"skymap8", "irrmapd", "envmapd"},
                             {"skymap5", "irrmape", "envmape"}, {"skymap6", "irrmap6", nullptr}};
  int maps = 0;
  for (const Pair& pair : kPairs) {
    const std::string sky = (data() / "tokoik" / (std::string(pair.sky) + ".tga")).string();
    good({"fisheye", sky, "--mode", "first", "--center", "128,128", "--radius", "127.5", "--ground", "0.2",
          "--shininess", pair.reflection != nullptr ? "100" : "1", "--size", "256", "-o", "out", "-q"});
    for (const auto& [ours, theirs] : {std::pair{"irradiance", pair.irradiance}, {"reflection", pair.reflection}}) {
      if (theirs == nullptr) continue;
      const Image<Rgb> got = codes_in(path(std::string("out/") + ours + "-disc.png"));
      const Image<Rgb> published = codes_in(data() / "tokoik_outputs" / (std::string(theirs) + ".tga"));
      ASSERT_EQ(got.size(), 256u * 256u);
      EXPECT_LE(largest_difference(got, published), 1.001) << theirs;
      int equal = 0;
      for (std::size_t i = 0; i < got.size(); ++i) {
        const Rgb d = got.values()[i] - published.values()[i];
        equal += std::abs(d.r) + std::abs(d.g) + std::abs(d.b) < 0.5f;
      }
      EXPECT_GT(equal, 65536 * 0.998) << theirs;  // the rest lies at a rounding edge
      ++maps;
    }
  }
  EXPECT_EQ(maps, 11);
}

/// A sky over a circle that does not lie in the middle; grey, brighter to the right.
void write_sky(const std::filesystem::path& to) {
  Image<Rgb> sky(60, 50);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 60; ++x) {
      const float v = 0.2f + 0.01f * static_cast<float>(x);
      sky(x, y) = {v, v, v};
    }
  }
  save_picture(sky, to);
}

TEST_F(CliFisheye, WritesAllFormsOfBothMapsAndThePage) {
  write_sky(path("sky.png"));
  int modes = 0;
  for (const std::string mode : {"published", "corrected", "first"}) {
    const auto result =
        nlohmann::json::parse(good({"fisheye", "sky.png", "--center", "32,25", "--radius", "20", "--shininess", "10",
                                    "--mode", mode, "--size", "16", "-o", mode, "--json"})
                                  .out);
    const std::size_t maps = mode == "corrected" ? 12 : 6, pages = mode == "first" ? 0 : 1;
    EXPECT_EQ(result.at("files").size(), maps + pages) << mode;
    EXPECT_EQ(files(mode).size(), maps + pages) << mode;
    EXPECT_EQ(result.at("codes").get<bool>(), mode != "corrected");
    for (const auto& file : result["files"]) {
      EXPECT_EQ(std::filesystem::file_size(path(file.at("path").get<std::string>())), file.at("bytes"));
    }
    const std::string first = mode == "first" ? "disc" : "paraboloid";
    EXPECT_EQ(pixels_of(path(mode + "/reflection-" + first + ".png")).width(), 16);
    EXPECT_EQ(pixels_of(path(mode + "/irradiance-panorama.png")).width(), 32);
    EXPECT_EQ(pixels_of(path(mode + "/irradiance-cube-cross.png")).width(), 32);
    ++modes;
  }
  EXPECT_EQ(modes, 3);
  // The zenith's irradiance is nearly that of the middle of the circle, whose code is known.
  const Image<Rgb> published = codes_in(path("published/irradiance-paraboloid.png"));
  const Image<Rgb> photograph = codes_in(path("sky.png"));
  EXPECT_NEAR(published(8, 8).g, photograph(32, 25).g, 6);
  EXPECT_GT(published(12, 8).g, published(4, 8).g);  // right is right
  EXPECT_EQ(published(0, 0).g, 51);                  // 0.2 of 255
}

TEST_F(CliFisheye, TheOutsideIsAsAsked) {
  write_sky(path("sky.png"));
  int widths = 0;
  for (const std::string outside : {"published", "extended", "two"}) {
    good({"fisheye", "sky.png", "--outside", outside, "--shininess", "1", "--size", "16", "--ground", "0", "-o",
          outside, "-q"});
    const Image<Rgb> map = pixels_of(path(outside + "/irradiance-paraboloid.exr"));
    widths += map.width();
    // A corner of the map sees the sky at 109 degrees from the zenith, dimly.
    if (outside == "published") {
      EXPECT_EQ(map(0, 0), Rgb());
    } else {
      EXPECT_GT(map(15, 8).g, 0.02f);
    }
    EXPECT_FALSE(std::filesystem::exists(path(outside + "/reflection-paraboloid.exr")));
  }
  EXPECT_EQ(widths, 16 + 16 + 32);
}

TEST_F(CliFisheye, AFurnaceStaysWhite) {
  good({"sky", "furnace", "--radiance", "1", "--to", "fisheye", "--size", "40", "-o", "white.exr"});
  good({"fisheye", "white.exr", "--ground", "1", "--size", "16", "-o", "out", "-q"});
  int maps = 0;
  for (const char* map :
       {"irradiance-paraboloid", "reflection-paraboloid", "irradiance-panorama", "reflection-panorama"}) {
    EXPECT_LT(worst_from(pixels_of(path("out/" + std::string(map) + ".exr")), 1), 1e-5) << map;
    ++maps;
  }
  EXPECT_EQ(maps, 4);
}

TEST_F(CliFisheye, OtherLensesHaveNoPublishedMap) {
  write_sky(path("sky.png"));
  const Result result =
      good({"fisheye", "sky.png", "--lens", "equisolid", "--fov", "170", "--size", "16", "-o", "out"});
  EXPECT_NE(result.err.find("no page"), std::string::npos);
  EXPECT_EQ(files("out").size(), 12u);
}

TEST_F(CliFisheye, SaysWhatIsWrong) {
  bad(2, {"fisheye"}, "IN");
  bad(3, {"fisheye", "missing.png", "-o", "out"}, "missing.png");
  bad(2, {"fisheye", "missing.png", "-o", "out", "--mode", "best"}, "published, first or corrected");
  bad(2, {"fisheye", "missing.png", "-o", "out", "--outside", "in"}, "published, extended or two");
  bad(2, {"fisheye", "missing.png", "-o", "out", "--shininess", "-1"}, "--shininess");
}

}  // namespace
}  // namespace zonal
