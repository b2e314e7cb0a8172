#include "zonal/io/recipe.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace zonal {
namespace {

Recipe sample() {
  return {.version = "1.2.3",
          .verb = "bake",
          .inputs = {{"sky \"a\".exr", 12345678901, "fnv1a64:00ff"}},
          .settings = {{"size_px", 256}, {"lobe", "ggx"}, {"rotate_deg", 12.1f}, {"levels", 5}},
          .error_bounds = {{"specular level 1", "mean", 1e-5}},
          .results = {{"clipped_texels", 0}},
          .warnings = {"the sun is clipped"},
          .seconds = {{"read", 0.25}, {"analyze", 0.5}}};
}

TEST(Recipe, HoldsEverythingInAFixedOrder) {
  const std::string id = recipe_id(sample());
  EXPECT_EQ(recipe_json(sample()), R"({
  "format": "zonal-recipe",
  "version": 1,
  "recipe": {
    "zonal": "1.2.3",
    "verb": "bake",
    "inputs": [
      {
        "name": "sky \"a\".exr",
        "bytes": 12345678901,
        "hash": "fnv1a64:00ff"
      }
    ],
    "settings": {
      "size_px": 256,
      "lobe": "ggx",
      "rotate_deg": 12.1,
      "levels": 5
    }
  },
  "id": ")" + id + R"(",
  "results": {
    "error_bounds": [
      {
        "of": "specular level 1",
        "relative_to": "mean",
        "error": 1e-05
      }
    ],
    "warnings": ["the sun is clipped"],
    "clipped_texels": 0
  },
  "timings_s": {
    "read": 0.25,
    "analyze": 0.5
  }
}
)");
  EXPECT_TRUE(nlohmann::json::parse(recipe_json(sample())).is_object());
}

TEST(Recipe, OnlyTimesDifferWhenItIsRepeated) {
  Recipe slower = sample();
  slower.seconds[0].second = 3;
  EXPECT_EQ(recipe_id(slower), recipe_id(sample()));
  auto a = nlohmann::json::parse(recipe_json(sample())), b = nlohmann::json::parse(recipe_json(slower));
  EXPECT_NE(a, b);
  a.erase("timings_s");
  b.erase("timings_s");
  EXPECT_EQ(a.dump(), b.dump());
}

TEST(Recipe, ItsIdFollowsEveryCause) {
  std::vector<Recipe> recipes(7, sample());
  recipes[1].version = "1.2.4";
  recipes[2].verb = "prefilter";
  recipes[3].inputs[0].hash = "fnv1a64:00fe";
  recipes[4].inputs[0].bytes++;
  recipes[5].settings[0].second = 128;
  recipes[6].settings.pop_back();
  std::set<std::string> ids;
  for (const Recipe& recipe : recipes) ids.insert(recipe_id(recipe));
  EXPECT_EQ(ids.size(), recipes.size());

  Recipe renamed = sample();
  renamed.inputs[0].name = "copy.exr";
  EXPECT_EQ(recipe_id(renamed), recipe_id(sample()));
}

}  // namespace
}  // namespace zonal
