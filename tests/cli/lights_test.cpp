// Lights out of pictures and coefficients.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "zonal/io/lights_json.h"
#include "zonal/io/sh_json.h"
#include "zonal/light/model.h"

namespace zonal {
namespace {

using CliLights = Cli;

const Vec3 kFirst = normalize({1, 2, 2}), kSecond = normalize({-3, 1, 1});

Vec3 vec3_in(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

TEST_F(CliLights, FindsTheLightsThatWerePutIn) {
  const Sh<RgbD> scene =
      directional_sh(kFirst, {6, 4, 2}, 6) + directional_sh(kSecond, {1, 2, 3}, 6) + ambient_sh({0.5, 0.25, 0.125}, 6);
  write("scene.json", sh_json_text({ShQuantity::kRadiance, scene}));
  int found = 0;
  for (const std::vector<std::string>& metric : {std::vector<std::string>{}, {"--radiance"}}) {
    std::vector<std::string> words = {"lights", "scene.json", "-n", "2", "--refine", "--json"};
    words.insert(words.end(), metric.begin(), metric.end());
    const auto json = nlohmann::json::parse(good(words).out);
    EXPECT_EQ(json.at("metric"), metric.empty() ? "irradiance" : "radiance");
    ASSERT_EQ(json.at("lights").size(), 2u);
    const auto &first = json["lights"][0], &second = json["lights"][1];
    // The refinement stops when the fit is this good; flat there, so the directions are worse than the residual.
    EXPECT_LT(json.at("residual").get<double>(), 1e-5);
    EXPECT_LT(angle_between(vec3_in(first.at("direction")), kFirst), 1e-4);
    EXPECT_LT(angle_between(vec3_in(second.at("direction")), kSecond), 1e-4);
    EXPECT_NEAR(first.at("azimuth_deg").get<double>(), degrees(std::atan2(2, 1)), 0.01);
    EXPECT_NEAR(first.at("elevation_deg").get<double>(), degrees(std::asin(2.0 / 3)), 0.01);
    EXPECT_NEAR(first.at("irradiance").at(0).get<double>(), 6, 1e-3);
    EXPECT_NEAR(second.at("irradiance").at(2).get<double>(), 3, 1e-3);
    EXPECT_NEAR(json.at("ambient_radiance").at(1).get<double>(), 0.25, 1e-3);
    // Luminance of each over that of all; ambient light comes from 4 pi.
    const double whole = luminance(RgbD(7, 6, 5) + 4 * kPi * RgbD(0.5, 0.25, 0.125));
    EXPECT_NEAR(first.at("share").get<double>(), luminance(RgbD(6, 4, 2)) / whole, 1e-4);
    EXPECT_NEAR(
        first["share"].get<double>() + second.at("share").get<double>() + json.at("ambient_share").get<double>(), 1,
        1e-12);
    ++found;
  }
  EXPECT_EQ(found, 2);
}

TEST_F(CliLights, WritesTheFileAndTheTable) {
  write("scene.json",
        sh_json_text({ShQuantity::kRadiance, cone_sh(kFirst, 0.3, {4, 2, 1}, 6) + ambient_sh({1, 1, 1}, 6)}));
  const std::string table =
      good({"lights", "scene.json", "-n", "1", "--radiance", "--refine", "--cones", "-o", "lights.json"}).out;
  const LightsFile file = parse_lights_json(bytes_of(path("lights.json")));
  ASSERT_EQ(file.lights.size(), 1u);
  ASSERT_TRUE(file.ambient && file.lights[0].share);
  EXPECT_LT(angle_between(file.lights[0].direction, kFirst), 1e-4);
  EXPECT_NEAR(file.lights[0].half_angle, 0.3, 1e-3);
  EXPECT_NEAR(file.lights[0].irradiance.r / (4 * kPi * std::pow(std::sin(0.3), 2)), 1, 1e-3);
  EXPECT_NEAR(file.ambient->g, 1, 1e-3);
  // The disc's radiance times its solid angle is its energy.
  const double disc = luminance(RgbD(4, 2, 1)) * 2 * kPi * (1 - std::cos(0.3));
  EXPECT_NEAR(*file.lights[0].share, disc / (disc + 4 * kPi), 1e-4);
  EXPECT_NE(table.find("63.4°"), std::string::npos) << table;
  EXPECT_NE(table.find("41.8°"), std::string::npos) << table;
  EXPECT_NE(table.find("17.2°"), std::string::npos) << table;
  EXPECT_NE(table.find("1.000  0.500  0.250"), std::string::npos) << table;
  EXPECT_EQ(good({"lights", "scene.json", "-n", "1", "--radiance", "--refine", "--cones", "-o", "-"}).out,
            bytes_of(path("lights.json")));
}

TEST_F(CliLights, MarksThemOnThePanorama) {
  good({"sky", "sun", "--azimuth", "60", "--elevation", "30", "--diameter", "10", "--contrast", "300", "--size", "256",
        "-o", "sun.exr"});
  good({"sh", "sun.exr", "--bands", "6", "-o", "sun.json"});
  int marked = 0;
  for (const std::string input : {"sun.exr", "sun.json"}) {
    good({"lights", input, "-n", "0", "--marked", "none.png", "-q"});
    good({"lights", input, "-n", "1", "--marked", "one.png", "-q"});
    const Image<Rgb> none = pixels_of(path("none.png")), one = pixels_of(path("one.png"));
    ASSERT_EQ(one.width(), 1024);
    ASSERT_EQ(none.size(), one.size());
    double x = 0, y = 0;
    int changed = 0;
    for (int j = 0; j < one.height(); ++j) {
      for (int i = 0; i < one.width(); ++i) {
        if (none(i, j) == one(i, j)) continue;
        x += i, y += j, ++changed;
      }
    }
    // A circle and a digit beside it, where the sun is: azimuth 60 is left of the middle by a sixth.
    EXPECT_GT(changed, 50) << input;
    EXPECT_LT(changed, 20000) << input;
    EXPECT_NEAR(x / changed, 512 - 1024.0 / 6, 40) << input;
    EXPECT_NEAR(y / changed, 512 / 3.0, 40) << input;
    ++marked;
  }
  EXPECT_EQ(marked, 2);
  bad(2, {"lights", "sun.exr", "--marked", "one.jpg"}, "name it .png");
  good({"lights", "sun.exr", "--marked", "none", "-q"});
  good({"lights", "sun.json", "-q"});
  EXPECT_FALSE(std::filesystem::exists(path("sun-lights.png")));
  good({"lights", "sun.exr", "-n", "1", "-q"});
  EXPECT_EQ(pixels_of(path("sun-lights.png")).width(), 1024);
}

TEST_F(CliLights, ProbesWithoutLights) {
  good({"light", "ambient", "--radiance", "2", "--bands", "4", "-o", "even.json"});
  const Result even = good({"lights", "even.json", "-n", "3", "--json"});
  EXPECT_NE(even.err.find("0 of 3 lights"), std::string::npos) << even.err;
  const auto json = nlohmann::json::parse(even.out);
  EXPECT_EQ(json.at("lights").size(), 0u);
  EXPECT_NEAR(json.at("ambient_radiance").at(0).get<double>(), 2, 1e-12);
  EXPECT_NEAR(json.at("ambient_share").get<double>(), 1, 1e-12);
  write("black.json", sh_json_text({ShQuantity::kRadiance, Sh<RgbD>(3)}));
  const auto black = nlohmann::json::parse(good({"lights", "black.json", "--json"}).out);
  EXPECT_EQ(black.at("lights").size(), 0u);
  EXPECT_TRUE(black.at("ambient_share").is_null());
  EXPECT_NE(good({"lights", "black.json"}).out.find("ambient radiance 0 0 0"), std::string::npos);
  good({"light", "cone", "--half-angle", "10", "--bands", "1", "-o", "one.json"});
  bad(2, {"lights", "one.json"}, "band");
  bad(2, {"lights", "even.json", "-n", "-1"}, "--lights");
  bad(2, {"lights", "even.json", "--bands", "65"}, "64 bands at most");
  good({"sh", "even.json", "--quantity", "irradiance", "-o", "e.json"});
  bad(2, {"lights", "e.json"}, "radiance cannot be had");
}

}  // namespace
}  // namespace zonal
