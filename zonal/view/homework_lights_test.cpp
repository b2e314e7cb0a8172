#include "zonal/view/homework_lights.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"
#include "zonal/sphere/frame.h"
#include "zonal/view/control.h"

namespace zonal {
namespace {

TEST(HomeworkLights, AreTenAndNamedInTheControl) {
  const auto names = control_named("light_set").choices;
  ASSERT_EQ(homework_lights().size(), 10u);
  ASSERT_EQ(names.size(), 11u);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(homework_lights()[i].name, names[i + 1]);
}

TEST(HomeworkLights, TurnIntoOurAxesAsFunctions) {
  int compared = 0;
  for (const HomeworkLight& light : homework_lights()) {
    Sh<RgbD, 3> published;
    for (std::size_t i = 0; i < 9; ++i) {
      published[i] = {light.coefficients[i][0], light.coefficients[i][1], light.coefficients[i][2]};
    }
    const Sh<RgbD, 3> ours = homework_radiance(light);
    for (const Vec3 d : spiral_directions(20)) {
      EXPECT_NEAR(evaluate(ours, d).g, evaluate(published, sampler_from_world(d)).g, 1e-12) << light.name;
      ++compared;
    }
    // What is up in the map (+Y there) is up here; its right is our -Y, its middle our +X.
    EXPECT_NEAR(ours(1, 0).g, light.coefficients[1][1], 1e-12);
    EXPECT_NEAR(ours(1, -1).g, -light.coefficients[3][1], 1e-12);
    EXPECT_NEAR(ours(1, 1).g, light.coefficients[2][1], 1e-12);
  }
  EXPECT_EQ(compared, 200);
}

TEST(HomeworkLights, AreThePublishedNumbers) {
  const std::filesystem::path path = ZONAL_SOURCE_DIR "/../shared/reference/orange_book_sh_tables.json";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference tables";
  const auto tables = nlohmann::json::parse(std::ifstream(path)).at("tables");
  int compared = 0;
  for (const HomeworkLight& light : homework_lights()) {
    const auto& table = tables.at(std::string(light.name));
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(light.coefficients[i][c], table.at(i).at(c).get<double>()) << light.name;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 270);
}

}  // namespace
}  // namespace zonal
