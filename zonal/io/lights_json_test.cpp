#include "zonal/io/lights_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "zonal/base/error.h"
#include "zonal/io/json_text.h"

namespace zonal {
namespace {

LightsFile example() {
  return {RgbD{0.5, 0.25, 1},
          {{{0, 0.6, 0.8}, {3, 2, 1}, radians(30), 0.625}, {{-1, 0, 0}, {1, -0.5, 0}, 0, std::nullopt}}};
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(LightsJson, WritesTheSchema) {
  LightsFile file = example();
  file.lights.erase(file.lights.begin());
  EXPECT_EQ(lights_json_text(file), R"({
  "format": "zonal-lights",
  "version": 1,
  "frame": "z-up-right-handed",
  "azimuth": "from +X toward +Y",
  "ambient_radiance": [0.5, 0.25, 1],
  "lights": [
    {
      "direction": [-1, 0, 0],
      "azimuth_deg": 180,
      "elevation_deg": 0,
      "half_angle_deg": 0,
      "solid_angle_sr": 0,
      "irradiance": [1, -0.5, 0],
      "radiance": null,
      "share": null
    }
  ]
}
)");
  EXPECT_NE(lights_json_text({}).find("\"ambient_radiance\": null"), std::string::npos);
}

TEST(LightsJson, DerivedNumbersAreThoseOfADisc) {
  EXPECT_DOUBLE_EQ(azimuth_deg({0, 1, 0}), 90);
  EXPECT_DOUBLE_EQ(azimuth_deg({-1, -0.0, 0}), 180);
  EXPECT_EQ(azimuth_deg({0, 0, 1}), 0);
  EXPECT_EQ(azimuth_deg({-0.0, 0, 1}), 0);
  EXPECT_DOUBLE_EQ(elevation_deg({0, 0, -1}), -90);
  EXPECT_DOUBLE_EQ(elevation_deg({1, 0, 1}), 45);
  EXPECT_DOUBLE_EQ(disc_solid_angle(kPi), 4 * kPi);
  EXPECT_DOUBLE_EQ(disc_solid_angle(radians(60)), kPi);  // 2 pi (1 - 1/2)
  // The sun's disc of radiance 1: nearly pi a².
  EXPECT_NEAR(disc_solid_angle(1e-8) / (kPi * 1e-16), 1, 1e-15);
  // Irradiance of a uniform half sphere of radiance 1 is pi, and the other half adds nothing.
  EXPECT_NEAR(disc_radiance({kPi, 0, 1}, kPi / 2).r, 1, 1e-15);
  EXPECT_NEAR(disc_radiance({kPi, 0, 1}, kPi).r, 1, 1e-15);
  EXPECT_NEAR(disc_radiance({kPi / 4, 0, 1}, radians(30)).r, 1, 1e-15);
}

void expect_same(const LightsFile& a, const LightsFile& b) {
  EXPECT_EQ(a.ambient, b.ambient);
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    EXPECT_EQ(a.lights[i].direction, b.lights[i].direction);
    EXPECT_EQ(a.lights[i].irradiance, b.lights[i].irradiance);
    EXPECT_EQ(a.lights[i].share, b.lights[i].share);
    // Radians to degrees and back: one rounding each.
    EXPECT_DOUBLE_EQ(a.lights[i].half_angle, b.lights[i].half_angle);
  }
}

TEST(LightsJson, RoundTripsEveryBit) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> exponent(-30, 30), angle(0, kPi);
  int lights = 0;
  for (int file_number = 0; file_number < 50; ++file_number) {
    LightsFile file;
    if (file_number % 2 == 0) file.ambient = RgbD{normal(random), normal(random), -0.0};
    for (int i = 0; i < file_number % 7; ++i, ++lights) {
      const double scale = std::exp(exponent(random));
      FileLight light{normalize({normal(random), normal(random), normal(random)}),
                      scale * RgbD{normal(random), normal(random), normal(random)},
                      angle(random),
                      {}};
      if (i % 3 == 0) light.half_angle = 0;
      if (i % 3 == 1) light.half_angle = 1e-6 * light.half_angle;
      if (i % 2 == 0) light.share = normal(random);
      file.lights.push_back(light);
    }
    expect_same(parse_lights_json(lights_json_text(file)), file);
  }
  EXPECT_GT(lights, 100);
  // Where an azimuth means little, and the ends of every range.
  LightsFile ends;
  for (const Vec3 d : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{-1, -0.0, 0}, normalize({1e-12, -1e-13, 1})}) {
    ends.lights.push_back({d, {1, 1, 1}, kPi, 0.0});
  }
  expect_same(parse_lights_json(lights_json_text(ends)), ends);
  expect_same(parse_lights_json(lights_json_text({})), {});
}

TEST(LightsJson, NamesTheFieldThatIsWrong) {
  const std::string good = lights_json_text(example());
  const std::string half_angle = "\"half_angle_deg\": " + shortest(degrees(example().lights[0].half_angle));
  const struct {
    std::string_view what, with, named;
  } cases[] = {
      {"zonal-lights", "zonal-sh", "\"format\""},
      {"\"zonal-lights\"", "[\"zonal-lights\"]", "\"format\""},
      {"\"version\": 1", "\"version\": 2", "\"version\""},
      {"\"version\": 1", "\"version\": 1.0", "\"version\""},
      {"\"version\": 1,", "", "\"version\""},
      {"z-up", "y-up", "\"frame\""},
      {"from +X", "from +Y", "\"azimuth\""},
      {"[0.5, 0.25, 1]", "0.5", "\"ambient_radiance\""},
      {"[0.5, 0.25, 1]", "[0.5, 0.25]", "\"ambient_radiance\""},
      {"[0.5, 0.25, 1]", "[0.5, null, 1]", "\"ambient_radiance\""},
      {"\"lights\": [", "\"lights\": [7,", "light 0: is not an object"},
      {"[0, 0.6, 0.8]", "[0, 0, 0]", "\"direction\""},
      {"[0, 0.6, 0.8]", "[0, 0.6, 0.9]", "\"direction\""},
      {"[0, 0.6, 0.8]", "[0, 0.8, 0.6]", "\"direction\" points elsewhere"},
      {"\"azimuth_deg\": 90", "\"azimuth_deg\": -90", "\"direction\" points elsewhere"},
      {"\"azimuth_deg\": 90", "\"azimuth_deg\": \"90\"", "light 0: \"azimuth_deg\""},
      {"\"azimuth_deg\": 90,", "", "light 0: \"azimuth_deg\" is missing"},
      {half_angle, "\"half_angle_deg\": 31", "\"solid_angle_sr\""},
      {half_angle, "\"half_angle_deg\": -30", "\"half_angle_deg\""},
      {half_angle, "\"half_angle_deg\": 0", "\"solid_angle_sr\""},
      {half_angle, "\"half_angle_deg\": 181", "\"half_angle_deg\""},
      {half_angle, "\"half_angle_deg\": 1e-200", "too small"},
      {"[3, 2, 1]", "[3, 2]", "\"irradiance\""},
      {"[3, 2, 1]", "[3, 2.1, 1]", "\"radiance\""},
      {"\"share\": 0.625", "\"share\": \"most\"", "\"share\""},
      {"\"share\": 0.625", "\"share\": 0.625, \"colour\": 3", "light 0: there are fields"},
      {"\"share\": 0.625", "\"share\": 0.5, \"share\": 0.625", "\"share\" appears twice"},
      {"\"radiance\": null", "\"radiance\": [0, 0, 0]", "light 1: \"radiance\""},
      {"{\n  \"format\"", "{\n \"unit\": \"lux\", \"format\"", "fields"},
      {"{\n  \"format\"", "{\n \"lights\": [], \"format\"", "\"lights\" appears twice"},
      {"0.25, 1]", "1e999, 1]", "not JSON"},
      {"]\n}", "]", "not JSON"},
  };
  int named = 0;
  for (const auto& [what, with, name] : cases) {
    try {
      (void)parse_lights_json(replaced(good, what, with));
      ADD_FAILURE() << "accepted " << with;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_NE(std::string_view(error.what()).find(name), std::string_view::npos) << with << ": " << error.what();
      ++named;
    }
  }
  EXPECT_EQ(named, static_cast<int>(std::size(cases)));
}

TEST(LightsJson, HostileTextIsRefusedWithoutACrash) {
  const std::string good = lights_json_text(example());
  std::vector<std::string> texts = {"", "null", "[]", "7", "\"zonal-lights\"", "{", "\xff\xfe", std::string(3, '\0')};
  texts.push_back(std::string(200000, '['));
  texts.push_back(std::string(100000, '[') + std::string(100000, ']'));
  texts.push_back("{\"lights\":" + std::string(100000, '{'));
  std::string deep;
  for (int i = 0; i < 50000; ++i) deep += "{\"a\":";
  texts.push_back(deep);
  for (std::size_t size = 0; size + 2 < good.size(); ++size) texts.push_back(good.substr(0, size));
  std::size_t refused = 0;
  for (const std::string& text : texts) {
    try {
      (void)parse_lights_json(text);
    } catch (const Error& error) {
      refused += error.kind() == ErrorKind::kInput;
    }
  }
  EXPECT_EQ(refused, texts.size());
}

TEST(LightsJson, RandomDamageIsRefusedOrReadNeverMore) {
  const std::string good = lights_json_text(example());
  std::mt19937 random(5);
  int refused = 0, read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = good;
    text[random() % text.size()] = static_cast<char>(random() % 256);
    try {
      read += parse_lights_json(text).lights.size() == 2;
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_EQ(refused + read, 20000);
  EXPECT_GT(refused, 10000);
  EXPECT_GT(read, 0);  // one space for another, the last digit of a number
}

TEST(LightsJson, WhatCannotBeReadIsNotWritten) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int refused = 0;
  const auto refuses = [&](const auto& change) {
    LightsFile file = example();
    change(file);
    EXPECT_THROW((void)lights_json_text(file), Error);
    ++refused;
  };
  refuses([&](LightsFile& f) { f.ambient->g = nan; });
  refuses([&](LightsFile& f) { f.lights[0].direction = {0, 0, 2}; });
  refuses([&](LightsFile& f) { f.lights[0].direction.x = nan; });
  refuses([&](LightsFile& f) { f.lights[1].irradiance.b = INFINITY; });
  refuses([&](LightsFile& f) { f.lights[1].half_angle = nan; });
  refuses([&](LightsFile& f) { f.lights[1].half_angle = -1; });
  refuses([&](LightsFile& f) { f.lights[1].half_angle = 1e-300; });
  refuses([&](LightsFile& f) { f.lights[1].half_angle = 4; });
  refuses([&](LightsFile& f) { f.lights[1].share = nan; });
  EXPECT_EQ(refused, 9);
}

}  // namespace
}  // namespace zonal
