// Real environments, split by the command: do the files it writes shade like the file it read?
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "zonal/io/environment_file.h"
#include "zonal/io/lights_json.h"
#include "zonal/light/model.h"
#include "zonal/light/reference.h"

namespace zonal {
namespace {

class SlowCliSplitRealData : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    if (!std::filesystem::exists(data())) GTEST_SKIP() << "no real data beside this checkout";
  }
  static std::filesystem::path data() { return ZONAL_SOURCE_DIR "/../shared/data/equirect"; }
};

std::vector<Vec3> normals() {
  std::vector<Vec3> spread;  // Gonzalez 2010
  constexpr int kCount = 200;
  for (int i = 0; i < kCount; ++i) {
    const double z = 1 - (2 * i + 1.0) / kCount, azimuth = i * kPi * (3 - std::sqrt(5.0)), s = std::sqrt(1 - z * z);
    spread.push_back({s * std::cos(azimuth), s * std::sin(azimuth), z});
  }
  return spread;
}

/// Luminance, so that lights whose colours differ across them count with their exact centre.
std::vector<double> irradiance_by(const Environment& e, const std::vector<Vec3>& normals) {
  std::vector<double> irradiance;
  for (const RgbD& over_pi : convolve_at(e, Lobe::cosine(), normals)) irradiance.push_back(kPi * luminance(over_pi));
  return irradiance;
}

double irradiance_by(const FileLight& light, Vec3 normal) {
  const double seen = cone_irradiance(light.half_angle, angle_between(normal, light.direction));
  return luminance(light.irradiance) * seen / cone_irradiance(light.half_angle, 0);
}

TEST_F(SlowCliSplitRealData, LightsAndRestShadeLikeTheWhole) {
  const std::vector<Vec3> facing = normals();
  int pictures = 0, lights = 0;
  // A sun is a disc, and its glow is close to it. In rooms some lights are strips, spread wider than the disc that
  // stands for them, which shows where a surface's horizon crosses them.
  constexpr double kSun = 1e-3, kRoom = 1e-2;
  const std::vector<std::pair<std::string, double>> files = {
      {"venice_sunset_1k.hdr", kSun}, {"quarry_01_1k.hdr", kSun},      {"blender_city.exr", kSun},
      {"pmndrs_sunset.exr", kSun},    {"pmndrs_forest.exr", kSun},     {"blender_interior.exr", kSun},
      {"pmndrs_hall.exr", kSun},      {"pmndrs_park.exr", kRoom},      {"pmndrs_lobby.exr", kRoom},
      {"pmndrs_studio.exr", kRoom},   {"pmndrs_warehouse.exr", kRoom}, {"pmndrs_bridge.exr", 0},
      {"pmndrs_apartment.exr", 0},    {"pmndrs_city.exr", 0},          {"pmndrs_dawn.exr", 0}};
  for (const auto& [name, tolerance] : files) {
    const std::string file = (data() / name).string();
    const auto said =
        nlohmann::json::parse(good({"split", file, "-o", "rest.exr", "--lights", "lights.json", "--json"}).out);
    EXPECT_LT(said.at("balance").at("energy_difference").get<double>(), 1e-5) << name;
    EXPECT_LT(said.at("balance").at("vector_difference").get<double>(), 1e-5) << name;

    const LoadedEnvironment whole = load_environment(file), rest = load_environment(path("rest.exr"));
    const LightsFile file_of_lights = parse_lights_json(bytes_of(path("lights.json")));
    const std::vector<double> expected = irradiance_by(whole.environment, facing);
    std::vector<double> got = irradiance_by(rest.environment, facing);
    double worst = 0;
    for (std::size_t i = 0; i < facing.size(); ++i) {
      for (const FileLight& light : file_of_lights.lights) got[i] += irradiance_by(light, facing[i]);
      worst = std::max(worst, std::abs(got[i] - expected[i]));
    }
    worst /= *std::ranges::max_element(expected);
    EXPECT_LE(worst, tolerance) << name;
    EXPECT_EQ(file_of_lights.lights.empty(), tolerance == 0) << name;
    ++pictures;
    lights += static_cast<int>(file_of_lights.lights.size());
  }
  EXPECT_EQ(pictures, 15);
  EXPECT_GT(lights, 35);
}

}  // namespace
}  // namespace zonal
