#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "zonal/io/engine.h"
#include "zonal/io/file.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/ktx2_check.h"
#include "zonal/io/sh_json.h"
#include "zonal/sphere/cube.h"

namespace zonal {
namespace {

using CliBake = Cli;
using SlowCliBake = Cli;

const std::vector<std::string> kSmall = {"--size", "32", "--dfg-size", "8", "--irradiance-size", "8"};

std::vector<std::string> bake_to(const std::string& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"bake", "sky.exr", "-o", folder};
  words.insert(words.end(), kSmall.begin(), kSmall.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(CliBake, WritesWhatItSaysAndNothingElse) {
  good({"sky", "sun", "--contrast", "1e4", "--size", "64", "-o", "sky.exr"});
  const Result result = good(bake_to("out"));
  const std::vector<std::string> order = {
      "environment.ktx2", "irradiance.ktx2", "specular.ktx2", "dfg.ktx2",   "dfg_multiscatter.ktx2",
      "sh.json",          "sh.glsl",         "index.html",    "recipe.json"};
  std::size_t at = 0;
  for (const std::string& name : order) {
    const std::size_t found = result.out.find("out/" + name);
    EXPECT_GE(found, at) << name;
    at = found;
    EXPECT_GT(std::filesystem::file_size(path("out/" + name)), 100u);
  }
  EXPECT_EQ(files("out").size(), order.size());
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), static_cast<std::ptrdiff_t>(order.size()));

  const auto recipe = nlohmann::json::parse(bytes_of(path("out/recipe.json")));
  EXPECT_EQ(recipe.at("settings").at("levels"), 2);
  EXPECT_EQ(recipe.at("results").size(), 7u);
  for (const auto& file : recipe.at("results")) {
    EXPECT_EQ(file.at("bytes"), std::filesystem::file_size(path("out/" + file.at("file").get<std::string>())));
  }
  EXPECT_EQ(recipe.at("maps").size(), 2u);  // irradiance and one convolved level
  for (const auto& map : recipe.at("maps")) EXPECT_LE(map.at("bound_to_mean").get<double>(), 1e-3);
  EXPECT_GT(recipe.at("seconds").size(), 5u);
  EXPECT_EQ(parse_sh_json(bytes_of(path("out/sh.json"))).coefficients.bands(), 3);

  const std::string page = bytes_of(path("out/index.html"));
  EXPECT_EQ(page.find("http://"), page.find("http://www.w3.org"));  // no network: at most the name of a format
  EXPECT_NE(page.find("sky.exr"), std::string::npos);
}

TEST_F(CliBake, TexturesAreValidAndChained) {
  good({"sky", "gradient", "--size", "64", "-o", "sky.exr"});
  good(bake_to("out", {"--levels", "6"}));
  int checked = 0;
  for (const std::string name : {"environment", "irradiance", "specular", "dfg", "dfg_multiscatter"}) {
    EXPECT_TRUE(check_ktx2(read_file(path("out/" + name + ".ktx2"))).empty()) << name;
    ++checked;
  }
  EXPECT_EQ(checked, 5);
  const Ktx2Texture specular = decode_ktx2(read_file(path("out/specular.ktx2")));
  ASSERT_EQ(specular.chain.levels.size(), 6u);
  EXPECT_EQ(specular.chain.levels[5].width(), 1);
  EXPECT_EQ(specular.chain.levels[0], decode_ktx2(read_file(path("out/environment.ktx2"))).chain.levels.at(0));
  const auto quantity = std::find_if(specular.metadata.begin(), specular.metadata.end(),
                                     [](const auto& e) { return e.first == "zonal:roughness"; });
  ASSERT_NE(quantity, specular.metadata.end());
  EXPECT_EQ(quantity->second, "0 0.2 0.4 0.6 0.8 1");
}

TEST_F(SlowCliBake, PictureFormats) {
  good({"sky", "gradient", "--size", "64", "-o", "sky.exr"});
  int formats = 0;
  for (const std::string format : {"exr", "hdr", "png"}) {
    good(bake_to(format, {"--format", format}));
    EXPECT_EQ(pixels_of(path(format + "/specular_0." + format)).width(), 4 * 32);
    EXPECT_EQ(pixels_of(path(format + "/specular_1." + format)).width(), 4 * 16);
    EXPECT_EQ(pixels_of(path(format + "/irradiance." + format)).width(), 4 * 8);
    EXPECT_EQ(files(format).size(), 10u);
    ++formats;
  }
  EXPECT_EQ(formats, 3);
  good(bake_to("stack", {"--format", "exr", "--layout", "cube-stack"}));
  EXPECT_EQ(pixels_of(path("stack/environment.exr")).height(), 6 * 32);
}

TEST_F(SlowCliBake, ClippingIsSaid) {
  good({"sky", "sun", "--diameter", "20", "--contrast", "1e6", "--size", "64", "-o", "sky.exr"});
  const Result half = good(bake_to("half"));
  EXPECT_NE(half.err.find("brighter than 65504"), std::string::npos) << half.err;
  EXPECT_NE(half.err.find("--float32"), std::string::npos) << half.err;
  const Result full = good(bake_to("full", {"--float32"}));
  EXPECT_EQ(full.err.find("65504"), std::string::npos) << full.err;
}

TEST_F(CliBake, VerifyMeasuresEveryConvolvedMap) {
  good({"sky", "daylight", "--size", "64", "-o", "sky.exr"});
  const Result result = good(bake_to("out", {"--verify", "--levels", "4", "--json"}));
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json.at("verified").size(), 4u);  // irradiance and three levels
  for (const auto& map : json.at("verified")) {
    EXPECT_EQ(map.at("directions"), 64);
    EXPECT_GT(map.at("rms_relative_error").get<double>(), 0);
    EXPECT_LE(map.at("rms_relative_error").get<double>(), 1e-3);
  }
}

TEST_F(SlowCliBake, EveryLobeAndRoughnessMap) {
  good({"sky", "gradient", "--size", "64", "-o", "sky.exr"});
  int baked = 0;
  for (const std::string lobe : {"ggx", "charlie", "phong", "blinn-phong"})
    good(bake_to("l", {"--lobe", lobe})), ++baked;
  for (const std::string map : {"linear", "filament", "unity", "unreal", "babylon"}) {
    good(bake_to("r", {"--roughness-map", map, "--levels", "5"}));
    EXPECT_EQ(nlohmann::json::parse(bytes_of(path("r/recipe.json"))).at("settings").at("roughness_map"), map);
    ++baked;
  }
  EXPECT_EQ(baked, 9);
}

/// The test card's colour toward +X, +Y, ... as each engine's shader would look it up in the cube that was made for it.
TEST_F(SlowCliBake, EveryEngineFindsTheTestCardWhereItsPanoramaLies) {
  good({"testcard", "--size", "64", "-o", "sky.exr"});
  good(bake_to("ours"));
  const Image<Rgb> ours = decode_ktx2(read_file(path("ours/environment.ktx2"))).chain.levels.at(0);
  const auto texel_toward = [](const Image<Rgb>& stack, Vec3 sampler_direction) {
    const auto [face, u, v] = face_point(sampler_direction);
    const auto place = [&](double s) { return std::min(31, static_cast<int>((0.5 * s + 0.5) * 32)); };
    return stack(place(u), 32 * face + place(v));
  };
  int compared = 0;
  for (const EngineConvention& engine : all_engines()) {
    const std::string name(engine.name);
    good(bake_to(name, {"--engine", name}));
    const Image<Rgb> cube = decode_ktx2(read_file(path(name + "/environment.ktx2"))).chain.levels.at(0);
    for (const Vec3 world : {Vec3{0.9, 0.3, 0.2}, Vec3{-0.9, 0.1, 0.3}, Vec3{0.1, 0.9, -0.2}, Vec3{0.3, -0.9, 0.1},
                             Vec3{0.2, 0.1, 0.9}, Vec3{-0.1, 0.3, -0.9}}) {
      const Vec3 engine_direction = engine.engine_from_world * world;
      EXPECT_EQ(texel_toward(cube, engine.cube_from_engine * engine_direction),
                texel_toward(ours, sampler_from_world(world)))
          << name;
      ++compared;
    }
    const auto sh = nlohmann::json::parse(bytes_of(path(name + "/sh." + name + ".json")));
    EXPECT_EQ(sh.at("coefficients").size(), 9u) << name;
  }
  EXPECT_EQ(compared, 6 * 12);
}

TEST_F(SlowCliBake, TheSameBytesTwiceAndOnAnyNumberOfThreads) {
  good({"sky", "daylight", "--size", "128", "-o", "sky.exr"});
  const auto bytes = [&](const std::string& threads, const std::string& folder) {
    good(bake_to(folder, {"--levels", "4", "--no-timings", "--verify", "--threads", threads}));
    auto all = files(folder);
    std::filesystem::remove_all(path(folder));
    return all;
  };
  const auto once = bytes("1", "out");
  EXPECT_EQ(once.size(), 9u);
  for (auto& [name, content] : bytes("1", "out")) EXPECT_EQ(content, once.at(name)) << name;
  int compared = 0;
  for (const std::string threads : {"2", "7"}) {
    for (auto& [name, content] : bytes(threads, "out")) {
      // The page and the recipe hold the command, in which the number of threads stands.
      if (name == "recipe.json" || name == "index.html") continue;
      EXPECT_EQ(content, once.at(name)) << name << " on " << threads;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 14);
}

}  // namespace
}  // namespace zonal
