#include "zonal/io/sh_json.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "zonal/base/error.h"
#include "zonal/io/json_text.h"
#include "zonal/sh/convention.h"
#include "zonal/sh/irradiance.h"

namespace zonal {
namespace {

constexpr std::array<std::string_view, 3> kQuantityNames = {"radiance", "irradiance", "irradiance/pi"};
constexpr int kVersion = 1, kMaxBands = 1024;

[[noreturn]] void fail(const std::string& what, std::string hint = {}) {
  throw Error(ErrorKind::kInput, "SH coefficients: " + what, std::move(hint));
}

/// Parses and refuses a field that stands twice at the top: the library would keep the last one without a word.
nlohmann::json parse(std::string_view text) {
  std::set<std::string> seen;
  std::string twice;
  const auto watch = [&](int depth, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
    if (event == nlohmann::json::parse_event_t::key && depth == 1 && !seen.insert(parsed.get<std::string>()).second) {
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

const nlohmann::json& field(const nlohmann::json& document, const char* name) {
  const auto found = document.find(name);
  if (found == document.end()) fail(fmt::format("the field \"{}\" is missing", name));
  return *found;
}

std::string text_field(const nlohmann::json& document, const char* name) {
  const nlohmann::json& value = field(document, name);
  if (!value.is_string()) fail(fmt::format("\"{}\" is not a string", name));
  return value.get<std::string>();
}

void expect_text(const nlohmann::json& document, const char* name, std::string_view expected) {
  const std::string found = text_field(document, name);
  if (found != expected) fail(fmt::format("\"{}\" is \"{}\", must be \"{}\"", name, found, expected));
}

int integer_field(const nlohmann::json& document, const char* name, int smallest, int largest) {
  const nlohmann::json& value = field(document, name);
  // As double: an integer too large for any integer type is a number still, and out of range.
  const double number = value.is_number_integer() ? value.get<double>() : -1;
  if (number < smallest || number > largest) {
    fail(fmt::format("\"{}\" is not an integer from {} to {}", name, smallest, largest));
  }
  return static_cast<int>(number);
}

RgbD color(const nlohmann::json& row, std::size_t index) {
  const auto is_good = [](const nlohmann::json& value) {
    return value.is_number() && std::isfinite(value.get<double>());
  };
  if (!row.is_array() || row.size() != 3 || !is_good(row[0]) || !is_good(row[1]) || !is_good(row[2])) {
    fail(fmt::format("coefficient {} is not three finite numbers [r, g, b]", index));
  }
  return {row[0].get<double>(), row[1].get<double>(), row[2].get<double>()};
}

Sh<RgbD> coefficients_field(const nlohmann::json& document, int bands) {
  const nlohmann::json& rows = field(document, "coefficients");
  if (!rows.is_array()) fail("\"coefficients\" is not an array");
  Sh<RgbD> coefficients(bands);
  if (rows.size() != coefficients.size()) {
    fail(fmt::format("{} bands have {} coefficients, this has {}", bands, coefficients.size(), rows.size()));
  }
  for (std::size_t i = 0; i < rows.size(); ++i) coefficients[i] = color(rows[i], i);
  return coefficients;
}

/// What the quantity has of the radiance of band l.
std::vector<double> factors_of(ShQuantity quantity, int bands) {
  if (quantity == ShQuantity::kRadiance) return std::vector<double>(static_cast<std::size_t>(bands), 1.0);
  std::vector<double> factors = cosine_factors(bands);
  if (quantity == ShQuantity::kIrradiance) {
    for (double& factor : factors) factor *= kPi;
  }
  return factors;
}

}  // namespace

std::string_view name_of(ShQuantity quantity) { return kQuantityNames[static_cast<std::size_t>(quantity)]; }

std::optional<ShQuantity> sh_quantity_named(std::string_view name) {
  for (std::size_t i = 0; i < kQuantityNames.size(); ++i) {
    if (kQuantityNames[i] == name) return static_cast<ShQuantity>(i);
  }
  return std::nullopt;
}

ShFile to_quantity(const ShFile& file, ShQuantity quantity) {
  if (file.quantity == quantity) return file;
  const int bands = file.coefficients.bands();
  if (quantity == ShQuantity::kRadiance && bands > 3) {
    throw Error(ErrorKind::kUsage, fmt::format("radiance cannot be had from irradiance with {} bands", bands),
                "the cosine has removed band 3: use 3 bands, or coefficients of the radiance");
  }
  const std::vector<double> have = factors_of(file.quantity, bands);
  std::vector<double> ratio = factors_of(quantity, bands);
  // Where both are irradiance the lost bands are zero in both: any ratio will do.
  for (std::size_t l = 0; l < ratio.size(); ++l) ratio[l] = have[l] == 0 ? 0 : ratio[l] / have[l];
  return {quantity, convolve(file.coefficients, ratio)};
}

std::string sh_json_text(const ShFile& file) {
  if (file.coefficients.size() == 0) fail("there are none");
  JsonValue::Array rows;
  for (std::size_t i = 0; i < file.coefficients.size(); ++i) {
    const RgbD c = file.coefficients[i];
    if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) {
      fail(fmt::format("coefficient {} is not finite", i), "the picture has NaN or infinite pixels: repair it first");
    }
    rows.emplace_back(JsonValue::Array{c.r, c.g, c.b});
  }
  return json_text(JsonValue::Object{{"format", "zonal-sh"},
                                     {"version", kVersion},
                                     {"bands", file.coefficients.bands()},
                                     {"quantity", name_of(file.quantity)},
                                     {"basis", "real"},
                                     {"condon_shortley", false},
                                     {"frame", "z-up-right-handed"},
                                     {"coefficients", std::move(rows)}});
}

ShFile parse_sh_json(std::string_view text) {
  const nlohmann::json document = parse(text);
  expect_text(document, "format", "zonal-sh");
  integer_field(document, "version", kVersion, kVersion);
  const int bands = integer_field(document, "bands", 1, kMaxBands);
  const std::string quantity_name = text_field(document, "quantity");
  const std::optional<ShQuantity> quantity = sh_quantity_named(quantity_name);
  if (!quantity)
    fail(fmt::format("\"quantity\" is \"{}\"", quantity_name), "it is one of radiance, irradiance, irradiance/pi");
  expect_text(document, "basis", "real");
  const nlohmann::json& signed_basis = field(document, "condon_shortley");
  if (!signed_basis.is_boolean()) fail("\"condon_shortley\" is not true or false");
  expect_text(document, "frame", "z-up-right-handed");
  Sh<RgbD> coefficients = coefficients_field(document, bands);
  constexpr std::size_t kFields = 8;  // all of them are there by now
  if (document.size() > kFields) fail("there are fields that version 1 does not have");
  if (signed_basis.get<bool>()) coefficients = from_condon_shortley(coefficients);
  return {*quantity, std::move(coefficients)};
}

}  // namespace zonal
