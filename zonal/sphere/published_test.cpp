// Published numbers, where the reference folder is at hand.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "zonal/sphere/every_projection.h"

namespace zonal {
namespace {

std::optional<nlohmann::json> vectors(const std::string& name) {
  const std::filesystem::path path = std::string(ZONAL_SOURCE_DIR "/../shared/reference/vectors/") + name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  std::ifstream file(path);
  return nlohmann::json::parse(file);
}

/// The eye of OpenGL looks along -z with +x right and +y up; ours along +X with -Y right and +Z up.
Vec3 world_from_eye(const nlohmann::json& r) {
  return normalize({-r[2].get<double>(), -r[0].get<double>(), r[1].get<double>()});
}

TEST(Published, SphereMap) {
  const auto data = vectors("slides_a.json");
  if (!data) GTEST_SKIP() << "no reference folder beside the checkout";
  const int n = 512;
  const Mapping mapping({Layout::kSphereMap}, {n, n});
  int compared = 0;
  for (const auto& row : (*data)["sphere_map"]) {
    const auto p = mapping.position(world_from_eye(row["r"]));
    ASSERT_TRUE(p);
    EXPECT_NEAR(p->x / n, row["uv"][0].get<double>(), 1e-14);
    EXPECT_NEAR(1 - p->y / n, row["uv"][1].get<double>(), 1e-14);  // v runs up
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

TEST(Published, DualParaboloid) {
  const auto data = vectors("slides_a.json");
  if (!data) GTEST_SKIP() << "no reference folder beside the checkout";
  const int n = 512;
  const Mapping mapping({Layout::kDualParaboloid}, {2 * n, n});
  int front = 0, back = 0;
  for (const auto& row : (*data)["paraboloid"]) {
    // Its front image looks along +z with +x right and +y up; ours along +X.
    const auto& r = row["r"];
    const auto p = mapping.position({r[2].get<double>(), -r[0].get<double>(), r[1].get<double>()});
    ASSERT_TRUE(p);
    const bool is_front = row["front"].get<bool>();
    EXPECT_EQ(mapping.chart(*p), is_front ? 0 : 1);
    EXPECT_NEAR(p->x / n - (is_front ? 0 : 1), row["uv"][0].get<double>(), 1e-14);
    EXPECT_NEAR(1 - p->y / n, row["uv"][1].get<double>(), 1e-14);
    ++(is_front ? front : back);
  }
  EXPECT_EQ(front + back, 10);
  EXPECT_GT(front, 0);
  EXPECT_GT(back, 0);
}

TEST(Published, ParaboloidDirections) {
  const auto data = vectors("irradiance_program.json");
  if (!data) GTEST_SKIP() << "no reference folder beside the checkout";
  // That paraboloid's square reaches below the horizon, as a stereographic fisheye of 300 degrees does; (u, v) = (½, 0)
  // is tan(θ/2) = 1. It is y-up with u along x and v along z; our picture has +Y to the right and -X down.
  const int n = 1000;
  const Mapping mapping({Layout::kFisheye, {LensModel::kStereographic, 300}}, {n, n});
  const double unit = n / 2 / std::tan(radians(75));
  int compared = 0;
  for (const auto& row : (*data)["paraboloid_dirs"]) {
    const double u = row["u"].get<double>(), v = row["v"].get<double>();
    const auto d = mapping.direction({n / 2 + 2 * u * unit, n / 2 + 2 * v * unit});
    ASSERT_TRUE(d);
    const auto& q = row["q"];
    EXPECT_LT(angle_between(*d, {-q[2].get<double>(), q[0].get<double>(), q[1].get<double>()}), 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 20);
}

TEST(Published, FisheyeSolidAngle) {
  const auto data = vectors("irradiance_program.json");
  if (!data) GTEST_SKIP() << "no reference folder beside the checkout";
  // r = 1 at 90 degrees, so a full fisheye of radius 2: 1000 texels to the unit.
  const Mapping mapping({Layout::kFisheye, {LensModel::kEquidistant, 360, 2000.5, 2000.5, 2000}}, {4001, 4001});
  int compared = 0;
  for (const auto& row : (*data)["fisheye_solid_angle"]) {
    const int x = 2000 + static_cast<int>(std::lround(1000 * row["r"].get<double>()));
    const double density = mapping.solid_angle(x, 2000) * 1e6;
    // A texel's mean differs from its centre by (texel size)²/24 of the second derivative; edges cancel by 1e-16 of
    // 1e-6.
    EXPECT_NEAR(density, row["dOmega_dsdt"].get<double>(), 1e-6);
    ++compared;
  }
  EXPECT_EQ(compared, 8);
}

TEST(Published, EquirectRowsAndCubeTexels) {
  const auto program = vectors("irradiance_program.json");
  const auto normalisation = vectors("normalisation.json");
  if (!program || !normalisation) GTEST_SKIP() << "no reference folder beside the checkout";
  int compared = 0;
  const Mapping panorama({Layout::kEquirect}, {16, 8});
  for (const auto& row : (*program)["equirect_h8_exact_rows"]) {
    EXPECT_NEAR(panorama.solid_angle(3, compared), row.get<double>(), 1e-15);
    ++compared;
  }
  EXPECT_EQ(compared, 8);
  const Mapping cube({Layout::kCubeStack}, {4, 24});
  for (const auto& texel : (*normalisation)["texel_solid_angles_N4_row0"]) {
    EXPECT_NEAR(cube.solid_angle(compared - 8, 0), texel.get<double>(), 1e-15);
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

}  // namespace
}  // namespace zonal
