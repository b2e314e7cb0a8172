#include "zonal/io/recipe.h"

#include <span>
#include <string_view>

#include "zonal/io/hash.h"

namespace zonal {
namespace {

JsonValue recipe_object(const Recipe& recipe, bool names) {
  JsonValue::Array inputs;
  for (const Recipe::Input& input : recipe.inputs) {
    JsonValue::Object fields;
    if (names) fields.emplace_back("name", input.name);
    fields.emplace_back("bytes", input.bytes);
    fields.emplace_back("hash", input.hash);
    inputs.emplace_back(std::move(fields));
  }
  return JsonValue::Object{
      {"zonal", recipe.version}, {"verb", recipe.verb}, {"inputs", std::move(inputs)}, {"settings", recipe.settings}};
}

JsonValue results_object(const Recipe& recipe) {
  JsonValue::Array bounds, warnings;
  for (const auto& [of, relative_to, error] : recipe.error_bounds) {
    bounds.emplace_back(JsonValue::Object{{"of", of}, {"relative_to", relative_to}, {"error", error}});
  }
  for (const std::string& warning : recipe.warnings) warnings.emplace_back(warning);
  JsonValue::Object results = {{"error_bounds", std::move(bounds)}, {"warnings", std::move(warnings)}};
  results.insert(results.end(), recipe.results.begin(), recipe.results.end());
  return results;
}

}  // namespace

std::string recipe_id(const Recipe& recipe) {
  const std::string text = json_text(recipe_object(recipe, false));
  Fnv1a hash;
  hash.add(std::as_bytes(std::span(text)));
  return hash.text();
}

std::string recipe_json(const Recipe& recipe) {
  JsonValue::Object timings;
  for (const auto& [stage, seconds] : recipe.seconds) timings.emplace_back(stage, seconds);
  return json_text(JsonValue::Object{{"format", "zonal-recipe"},
                                     {"version", 1},
                                     {"recipe", recipe_object(recipe, true)},
                                     {"id", recipe_id(recipe)},
                                     {"results", results_object(recipe)},
                                     {"timings_s", std::move(timings)}});
}

}  // namespace zonal
