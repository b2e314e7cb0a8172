#include "zonal/io/ambient_cube_json.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "zonal/base/check.h"
#include "zonal/base/error.h"
#include "zonal/io/json_text.h"

namespace zonal {
namespace {

constexpr std::array<std::string_view, 6> kSideNames = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
constexpr int kVersion = 1;

[[noreturn]] void fail(const std::string& what, std::string hint = {}) {
  throw Error(ErrorKind::kInput, "ambient cube: " + what, std::move(hint));
}

/// Parses and refuses a name that stands twice in the document (no name belongs to two places of this schema): the
/// library would keep the last one without a word.
nlohmann::json parse(std::string_view text) {
  std::set<std::string> seen;
  std::string twice;
  const auto watch = [&](int, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
    if (event == nlohmann::json::parse_event_t::key && !seen.insert(parsed.get<std::string>()).second) {
      twice = parsed.get<std::string>();
    }
    return true;
  };
  nlohmann::json document;
  try {
    document = nlohmann::json::parse(text, watch);
  } catch (const nlohmann::json::exception&) {
    fail("this is not JSON");
  }
  if (!document.is_object()) fail("this is JSON, but not an object");
  if (!twice.empty()) fail(fmt::format("the field \"{}\" appears twice", twice));
  return document;
}

const nlohmann::json& field(const nlohmann::json& object, std::string_view name) {
  const auto found = object.find(std::string(name));
  if (found == object.end()) fail(fmt::format("the field \"{}\" is missing", name));
  return *found;
}

void expect(const nlohmann::json& document, const char* name, const nlohmann::json& expected) {
  if (field(document, name) != expected) fail(fmt::format("\"{}\" must be {}", name, expected.dump()));
}

RgbD color(const nlohmann::json& value, std::string_view side) {
  const auto is_good = [](const nlohmann::json& number) {
    return number.is_number() && std::isfinite(number.get<double>());
  };
  if (!value.is_array() || value.size() != 3 || !is_good(value[0]) || !is_good(value[1]) || !is_good(value[2])) {
    fail(fmt::format("side {} is not three finite numbers [r, g, b]", side));
  }
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

}  // namespace

std::string_view ambient_cube_side_name(std::size_t side) {
  check(side < kSideNames.size(), "a cube has six sides");
  return kSideNames[side];
}

std::string ambient_cube_json_text(const AmbientCubeFile& file) {
  JsonValue::Object sides;
  for (std::size_t i = 0; i < kSideNames.size(); ++i) {
    const RgbD c = file.cube.sides[i];
    if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) {
      fail(fmt::format("side {} is not finite", kSideNames[i]));
    }
    sides.emplace_back(kSideNames[i], JsonValue::Array{c.r, c.g, c.b});
  }
  return json_text(JsonValue::Object{{"format", "zonal-ambient-cube"},
                                     {"version", kVersion},
                                     {"quantity", name_of(file.quantity)},
                                     {"frame", "z-up-right-handed"},
                                     {"sides", std::move(sides)}});
}

AmbientCubeFile parse_ambient_cube_json(std::string_view text) {
  const nlohmann::json document = parse(text);
  expect(document, "format", "zonal-ambient-cube");
  expect(document, "version", kVersion);
  expect(document, "frame", "z-up-right-handed");
  const nlohmann::json& quantity = field(document, "quantity");
  const auto known = quantity.is_string() ? sh_quantity_named(quantity.get<std::string>()) : std::nullopt;
  if (!known) fail("\"quantity\" is unknown", "it is one of radiance, irradiance, irradiance/pi");
  const nlohmann::json& sides = field(document, "sides");
  if (!sides.is_object()) fail("\"sides\" is not an object");
  AmbientCubeFile file{*known, {}};
  for (std::size_t i = 0; i < kSideNames.size(); ++i) {
    file.cube.sides[i] = color(field(sides, kSideNames[i]), kSideNames[i]);
  }
  constexpr std::size_t kFields = 5;  // all of them are there by now
  if (document.size() > kFields || sides.size() > kSideNames.size()) {
    fail("there are fields that version 1 does not have");
  }
  return file;
}

}  // namespace zonal
