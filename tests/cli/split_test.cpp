// The sun out of pictures, on the command line.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "zonal/io/lights_json.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

using CliSplit = Cli;
using nlohmann::json;

Vec3 vec3_in(const json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

/// Radiance times solid angle, in green.
double energy_of(const Image<Rgb>& panorama) {
  const Mapping mapping({Layout::kEquirect}, {panorama.width(), panorama.height()});
  double energy = 0;
  for (int y = 0; y < panorama.height(); ++y) {
    for (int x = 0; x < panorama.width(); ++x) energy += mapping.solid_angle(x, y) * panorama(x, y).g;
  }
  return energy;
}

TEST_F(CliSplit, LightsAndRestAddUpToTheWhole) {
  good({"sky", "sun", "--azimuth", "60", "--elevation", "30", "--diameter", "6", "--contrast", "1e4", "--size", "256",
        "-o", "sun.exr"});
  const Result result =
      good({"split", "sun.exr", "-o", "rest.exr", "--lights", "lights.json", "--marked", "marked.png", "--json"});
  const auto said = json::parse(result.out);
  ASSERT_EQ(said.at("lights").size(), 1u);
  const auto& light = said["lights"][0];
  EXPECT_NEAR(light.at("azimuth_deg").get<double>(), 60, 0.07);  // a tenth of a texel
  EXPECT_NEAR(light.at("elevation_deg").get<double>(), 30, 0.07);
  EXPECT_NEAR(light.at("half_angle_deg").get<double>(), 3, 0.01);
  EXPECT_EQ(light.at("half_angle_resolved"), true);
  EXPECT_NEAR(light.at("irradiance").at(1).get<double>() / (9999 * kPi * std::pow(std::sin(radians(3)), 2)), 1, 1e-3);
  EXPECT_NEAR(light.at("radiance").at(1).get<double>() / 9999, 1, 1e-3);
  EXPECT_LT(said.at("balance").at("energy_difference").get<double>(), 1e-5);
  EXPECT_LT(said.at("balance").at("vector_difference").get<double>(), 1e-5);
  EXPECT_NEAR(said.at("range_after").get<double>(), 1, 1e-5);

  // From the files themselves.
  const double whole = energy_of(pixels_of(path("sun.exr"))), rest = energy_of(pixels_of(path("rest.exr")));
  EXPECT_NEAR((light.at("energy").at(1).get<double>() + rest) / whole, 1, 1e-5);
  EXPECT_NEAR(rest / (4 * kPi), 1, 1e-5);
  const LightsFile file = parse_lights_json(bytes_of(path("lights.json")));
  ASSERT_EQ(file.lights.size(), 1u);
  EXPECT_FALSE(file.ambient);
  EXPECT_EQ(file.lights[0].direction, vec3_in(light.at("direction")));
  EXPECT_EQ(file.lights[0].irradiance.g, light["irradiance"][1].get<double>());
  EXPECT_NEAR(*file.lights[0].share, light.at("share").get<double>(), 1e-15);
  EXPECT_EQ(pixels_of(path("marked.png")).width(), 1024);  // 512, twice
  EXPECT_EQ(files().size(), 4u);
}

TEST_F(CliSplit, PeopleReadATable) {
  good({"sky", "sun", "--azimuth", "-90", "--elevation", "0", "--diameter", "0.53", "-o", "sun.exr"});
  const std::string out = good({"split", "sun.exr", "-o", "rest.exr"}).out;
  EXPECT_NE(out.find("-90."), std::string::npos) << out;
  EXPECT_NE(out.find("< 0."), std::string::npos) << out;  // half a degree in texels of a third
  EXPECT_NE(out.find("differs by"), std::string::npos) << out;
  for (const char* row : {"\nwhole ", "\nlights ", "\nrest ", "\nsum ", "\nrange "})
    EXPECT_NE(out.find(row), std::string::npos) << row << out;
}

TEST_F(CliSplit, WithoutASunTheRestIsTheWhole) {
  int pictures = 0;
  for (const std::string kind : {"furnace", "gradient", "checker"}) {
    good({"sky", kind, "--size", "64", "-o", "sky.pfm"});
    const Result result = good({"split", "sky.pfm", "-o", "rest.pfm", "--lights", "lights.json"});
    EXPECT_NE(result.out.find("no compact source"), std::string::npos);
    EXPECT_EQ(bytes_of(path("sky.pfm")), bytes_of(path("rest.pfm")));
    EXPECT_TRUE(parse_lights_json(bytes_of(path("lights.json"))).lights.empty());
    ++pictures;
  }
  EXPECT_EQ(pictures, 3);
}

TEST_F(CliSplit, LightsTurnWithThePicture) {
  good({"sky", "sun", "--azimuth", "20", "--elevation", "10", "--diameter", "6", "--size", "128", "-o", "sun.exr"});
  const auto light_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"split", "sun.exr", "-o", "rest.exr", "--json", "--lights", "lights.json"};
    words.insert(words.end(), more.begin(), more.end());
    const auto said = json::parse(good(words).out);
    // The sums turn too, so they still belong together.
    const auto& lights = said.at("balance").at("lights").at("vector_irradiance").at(1);
    EXPECT_LT(length(vec3_in(lights) -
                     said["lights"][0]["irradiance"][1].get<double>() * vec3_in(said["lights"][0]["direction"])),
              1e-9);
    EXPECT_LT(worst_from(pixels_of(path("rest.exr")), 1), 1e-5);
    return parse_lights_json(bytes_of(path("lights.json"))).lights.at(0);
  };
  const FileLight as_is = light_of({}), turned = light_of({"--rotate", "90"}), tilted = light_of({"--rotate", "7,8,9"});
  EXPECT_NEAR(azimuth_deg(turned.direction), azimuth_deg(as_is.direction) + 90, 1e-9);
  EXPECT_NEAR(elevation_deg(turned.direction), elevation_deg(as_is.direction), 1e-9);
  EXPECT_EQ(turned.irradiance, as_is.irradiance);
  good({"convert", "sun.exr", "--rotate", "7,8,9", "-o", "tilted.exr"});
  const auto there = json::parse(good({"split", "tilted.exr", "-o", "rest.exr", "--json"}).out);
  EXPECT_LT(degrees(angle_between(vec3_in(there["lights"][0]["direction"]), tilted.direction)), 0.14);  // 0.1 texel
}

TEST_F(CliSplit, EveryProjectionInAndOut) {
  int split = 0;
  for (const std::string layout : {"cube-cross", "octahedral", "angular", "mirror-ball", "fisheye"}) {
    good({"sky", "sun", "--azimuth", "20", "--elevation", "40", "--diameter", "8", "--to", layout, "--size", "96", "-o",
          "sun.exr"});
    const auto said = json::parse(
        good({"split", "sun.exr", "--from", layout, "-o", "rest.exr", "--to", "cube-row", "--size", "16", "--json"})
            .out);
    ASSERT_EQ(said.at("lights").size(), 1u) << layout;
    EXPECT_NEAR(said["lights"][0]["azimuth_deg"].get<double>(), 20, 1) << layout;
    EXPECT_NEAR(said["lights"][0]["elevation_deg"].get<double>(), 40, 1) << layout;
    EXPECT_LT(worst_from(pixels_of(path("rest.exr")), 1), 1e-5) << layout;
    ++split;
  }
  EXPECT_EQ(split, 5);
}

TEST_F(CliSplit, OptionsChooseTheLights) {
  good({"sky", "sun", "--diameter", "6", "--contrast", "1e4", "--size", "64", "-o", "sun.exr"});
  const auto lights_with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"split", "sun.exr", "-o", "rest.exr", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return json::parse(good(words).out).at("lights").size();
  };
  EXPECT_EQ(lights_with({}), 1u);
  EXPECT_EQ(lights_with({"-n", "0"}), 0u);
  EXPECT_EQ(lights_with({"--threshold", "1e5"}), 0u);
  EXPECT_EQ(lights_with({"--min-share", "0.99"}), 0u);
  EXPECT_EQ(lights_with({"--max-angle", "2"}), 0u);
}

TEST_F(CliSplit, RefusesWhatItCannotDo) {
  std::vector<float> values(32, 1);
  values[5] = std::nanf("");
  write_pfm("nan.pfm", 8, 4, values);
  bad(3, {"split", "nan.pfm", "-o", "rest.pfm"}, "not finite");
  good({"split", "nan.pfm", "-o", "rest.pfm", "--fix"});
  good({"sky", "sun", "--size", "16", "-o", "sun.exr"});
  bad(2, {"split", "sun.exr"}, "--output");
  bad(2, {"split", "sun.exr", "-o", "rest.txt"}, "names no format");
  bad(2, {"split", "sun.exr", "-o", "r.exr", "--marked", "m.jpg"}, "name it .png");
  bad(2, {"split", "sun.exr", "-o", "r.exr", "--threshold", "0.5"}, "--threshold");
  bad(2, {"split", "sun.exr", "-o", "r.exr", "-n", "-1"}, "--max-lights");
  bad(2, {"split", "sun.exr", "-o", "r.exr", "--min-share", "2"}, "--min-share");
  bad(4, {"split", "sun.exr", "-o", "nowhere/r.exr"}, "nowhere");
}

}  // namespace
}  // namespace zonal
