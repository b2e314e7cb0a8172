#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "zonal/io/json_text.h"

namespace zonal {

/// How outputs came about: beside them as recipe.json, for whoever has to make them again.
struct Recipe {
  struct Input {
    std::string name;  ///< without folders, which differ between machines
    std::uint64_t bytes = 0;
    std::string hash;  ///< io/hash.h
  };
  struct Bound {
    std::string of;           ///< which output
    std::string relative_to;  ///< "mean", "maximum", ...
    double error = 0;
  };

  std::string version;  ///< of this program
  std::string verb;
  std::vector<Input> inputs;
  JsonValue::Object settings;  ///< every one, defaults and guesses included, in a fixed order
  std::vector<Bound> error_bounds;
  JsonValue::Object results;  ///< further figures that follow from the recipe: counts, energy
  std::vector<std::string> warnings;
  std::vector<std::pair<std::string, double>> seconds;  ///< wall time by stage
};

/// "fnv1a64:..." of version, verb, inputs (not their names) and settings: equal for recipes that give the same bytes.
std::string recipe_id(const Recipe&);

/// {"format": "zonal-recipe", "version": 1, "recipe": {...}, "id": ..., "results": {...}, "timings_s": {...}}.
/// Everything but timings_s repeats its bytes when the recipe is repeated.
std::string recipe_json(const Recipe&);

}  // namespace zonal
