#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace zonal {
namespace {

/// Real environments, where they are at hand.
class SlowCliRealData : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    if (!std::filesystem::exists(data())) GTEST_SKIP() << "no real data beside this checkout";
  }
  static std::filesystem::path data() { return ZONAL_SOURCE_DIR "/../shared/data"; }
  static std::string file(const std::string& name) { return (data() / name).string(); }
};

TEST_F(SlowCliRealData, BakesHoldTheirBounds) {
  int maps = 0;
  for (const std::string name : {"quarry_01_1k.hdr", "pmndrs_studio.exr", "blender_sunset.exr"}) {
    const Result result = good({"bake", file("equirect/" + name), "-o", "out", "--verify", "--json"});
    const auto json = nlohmann::json::parse(result.out);
    for (const auto& map : json.at("verified")) {
      EXPECT_LE(map.at("rms_relative_error").get<double>(), 1e-3) << name << " " << map;
      ++maps;
    }
  }
  EXPECT_EQ(maps, 3 * 5);
}

TEST_F(SlowCliRealData, PagesOfPanoramasAreSmall) {
  int pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data() / "equirect")) {
    good({"view", entry.path().string(), "--html", "page.html", "--quiet"});
    EXPECT_LT(std::filesystem::file_size(path("page.html")), 3'000'000u) << entry.path();
    ++pages;
  }
  EXPECT_GE(pages, 20);
}

TEST_F(SlowCliRealData, EveryKindOfInput) {
  const std::vector<std::vector<std::string>> inputs = {
      {file("angular/beach_probe.hdr")},
      {file("cube_faces_hdr/pisaHDR")},
      {file("mirror_ball/office_ball_calib.hdr"), "--from", "mirror-ball"},
      {file("fisheye/tokoik/skymap0.tga"), "--ground", "0.2"},
      {file("fisheye/urban_sky/280353_img_roi.jpg"), "--from", "fisheye", "--uncovered", "leave-out"},
      {file("dual_fisheye/theta_s_raw_1920x1080.jpg"), "--from", "dual-fisheye"},
      {file("sphere_map/matcap_jade.exr"), "--from", "sphere-map"},
      {file("cube_faces_ldr/games202_Indoor")}};
  int baked = 0;
  for (std::vector<std::string> words : inputs) {
    words.insert(words.begin(), "bake");
    for (const char* word : {"-o", "out", "--size", "64", "--dfg-size", "16"}) words.emplace_back(word);
    good(words);
    EXPECT_GE(files("out").size(), 9u) << words[1];
    std::filesystem::remove_all(path("out"));
    ++baked;
  }
  EXPECT_EQ(baked, 8);
}

TEST_F(SlowCliRealData, TheSameSceneFromACubeAndAPanoramaGivesTheSameCoefficients) {
  const auto coefficients = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "sh");
    words.emplace_back("--json");
    return nlohmann::json::parse(good(words).out).at("coefficients");
  };
  const auto panorama = coefficients({file("equirect/pisa_latlong_256.hdr")});
  ASSERT_EQ(panorama.size(), 9u);
  int compared = 0;
  // Whoever made the cube put the panorama's centre on another face: a quarter turn, not a mirror.
  for (const auto& words : {std::vector<std::string>{file("equirect/probulator_pisa.hdr")},
                            std::vector<std::string>{file("cube_faces_hdr/pisaHDR"), "--rotate", "90"}}) {
    const auto other = coefficients(words);
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        // They were scaled by different programs: their radiance differs by half a percent.
        EXPECT_NEAR(panorama[i][c].get<double>(), other[i][c].get<double>(), 0.01 * panorama[0][c].get<double>())
            << words[0];
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 54);
}

}  // namespace
}  // namespace zonal
